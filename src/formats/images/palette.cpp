#include "formats/images/palette.h"

#include <algorithm>
#include <limits>
#include <span>

#include "base/check.h"

namespace temblor::formats {
namespace {

constexpr std::size_t kPaletteBytes = 256 * 3;
constexpr std::size_t kColormapBytes = Colormap::kRows * 256;

// Shades one channel for row `row`, rounded like the stock generator.
int shade_channel(std::uint8_t channel, int row) {
  return std::min(255, (channel * (63 - row) + 16) / 32);
}

// Returns the index of the nearest color among the first `candidates`; ties go to the lowest index.
std::uint8_t find_nearest_index(const Palette& palette, int candidates, int r, int g, int b) {
  int best = 0;
  int best_distance = std::numeric_limits<int>::max();
  for (int i = 0; i < candidates; ++i) {
    const Rgb& color = palette[static_cast<std::size_t>(i)];
    const int dr = color.r - r;
    const int dg = color.g - g;
    const int db = color.b - b;
    const int distance = dr * dr + dg * dg + db * db;
    if (distance < best_distance) {
      best = i;
      best_distance = distance;
    }
  }
  return static_cast<std::uint8_t>(best);
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
  constexpr int kCandidates = 255;
  Colormap colormap;
  const int lit_colors = 256 - colormap.fullbrights;
  for (int row = 0; row < Colormap::kRows; ++row) {
    for (int index = 0; index < 256; ++index) {
      const Rgb& color = palette[static_cast<std::size_t>(index)];
      colormap.rows[static_cast<std::size_t>(row * 256 + index)] =
          index >= lit_colors ? static_cast<std::uint8_t>(index)
                              : find_nearest_index(palette, kCandidates, shade_channel(color.r, row),
                                                   shade_channel(color.g, row), shade_channel(color.b, row));
    }
  }
  return colormap;
}

}  // namespace temblor::formats
