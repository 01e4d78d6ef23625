#include "formats/images/palette.h"

#include <algorithm>
#include <span>

#include "base/check.h"
#include "formats/images/nearest_color.h"

namespace temblor::formats {
namespace {

constexpr std::size_t kPaletteBytes = 256 * 3;
constexpr std::size_t kColormapBytes = Colormap::kRows * 256;

// Shades one channel for row `row`, rounded like the stock generator.
std::uint8_t shade_channel(std::uint8_t channel, int row) {
  return static_cast<std::uint8_t>(std::min(255, (channel * (63 - row) + 16) / 32));
}

}  // namespace

base::Result<Palette> read_palette(base::Bytes bytes) {
  if (bytes.size() < kPaletteBytes)
    return base::malformed("palette has {} bytes, expected {}", bytes.size(), kPaletteBytes);
  base::ByteReader reader(bytes);
  Palette palette;
  for (Rgb& color : palette) {
    color.r = reader.u8();
    color.g = reader.u8();
    color.b = reader.u8();
  }
  return palette;
}

base::ByteVector write_palette(const Palette& palette) {
  base::ByteWriter writer;
  for (const Rgb& color : palette) {
    writer.u8(color.r);
    writer.u8(color.g);
    writer.u8(color.b);
  }
  return std::move(writer).take();
}

base::Result<Colormap> read_colormap(base::Bytes bytes) {
  if (bytes.size() < kColormapBytes)
    return base::malformed("colormap has {} bytes, expected {} or {}", bytes.size(), kColormapBytes,
                           kColormapBytes + 1);
  const std::span<const std::uint8_t> values = base::as_u8(bytes);
  Colormap colormap;
  std::copy_n(values.begin(), kColormapBytes, colormap.rows.begin());
  if (values.size() > kColormapBytes) colormap.fullbrights = values[kColormapBytes];
  return colormap;
}

base::ByteVector write_colormap(const Colormap& colormap) {
  CHECK(colormap.fullbrights >= 0 && colormap.fullbrights <= 255, "{}", colormap.fullbrights);
  base::ByteWriter writer;
  writer.bytes(std::as_bytes(std::span(colormap.rows)));
  writer.u8(static_cast<std::uint8_t>(colormap.fullbrights));
  return std::move(writer).take();
}

Colormap make_colormap(const Palette& palette) {
  // Index 255 marks transparent pixels in pictures, so no shaded color may become 255.
  const NearestColor colors(palette, 0, kTransparentIndex);
  Colormap colormap;
  const int lit_colors = 256 - colormap.fullbrights;
  for (int row = 0; row < Colormap::kRows; ++row) {
    const auto shade = [row](std::uint8_t channel) { return shade_channel(channel, row); };
    for (int index = 0; index < 256; ++index) {
      const Rgb& color = palette[static_cast<std::size_t>(index)];
      colormap.rows[static_cast<std::size_t>(row * 256 + index)] =
          index >= lit_colors ? static_cast<std::uint8_t>(index)
                              : colors.find({shade(color.r), shade(color.g), shade(color.b)});
    }
  }
  return colormap;
}

}  // namespace temblor::formats
