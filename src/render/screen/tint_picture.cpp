#include "render/screen/tint_picture.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "render/screen/tint_kernels.h"

namespace temblor::render {

namespace {

constexpr std::size_t kPixelsAJob = std::size_t{1} << 15;

using Remap = std::array<std::uint8_t, 256>;
Remap tint_palette(formats::Rgb tint, int opacity, const ColourTables& tables) {
  Remap tinted;
  for (std::size_t i = 0; i < tinted.size(); ++i)
    tinted[i] = tables.match(blend_colours(tint, tables.palette[i], opacity), tables.match.is_fullbright(i));
  return tinted;
}

// Hot loop. Eight pixels are read before any is written: the compiler must take bytes for neighbours of the
// table's.
void remap(const Remap& tinted, std::span<std::uint8_t> io_pixels) {
  constexpr std::size_t kTogether = 8;
  std::size_t i = 0;
  for (; i + kTogether <= io_pixels.size(); i += kTogether) {
    std::array<std::uint8_t, kTogether> now;
    for (std::size_t k = 0; k < kTogether; ++k) now[k] = tinted[io_pixels[i + k]];
    std::memcpy(&io_pixels[i], now.data(), kTogether);
  }
  for (; i < io_pixels.size(); ++i) io_pixels[i] = tinted[io_pixels[i]];
}

}  // namespace

void tint_picture(const Tint& tint, const ColourTables& tables, bool vector_kernels, base::Jobs& jobs,
                  FrameBuffer& io_frame) {
  const int opacity = opacity_256(tint.opacity);
  if (opacity == 0) return;
  const formats::Rgb colour = to_bytes(tint.colour / 255.0f);
  const bool indexed = io_frame.format() == PixelFormat::kIndexed;
  const Remap tinted = indexed ? tint_palette(colour, opacity, tables) : Remap{};
  const std::size_t pixels = io_frame.pixel_count();
  jobs.parallel_for((pixels + kPixelsAJob - 1) / kPixelsAJob, [&](std::size_t job) {
    const std::size_t first = job * kPixelsAJob, count = std::min(kPixelsAJob, pixels - first);
    if (indexed) {
      remap(tinted, io_frame.indexed().subspan(first, count));
      return;
    }
    const TintJob tint_job{io_frame.rgb().data() + first, count, to_rgb(colour), opacity};
    vector_kernels ? tint_rgb_vector(tint_job) : tint_rgb_plain(tint_job);
  });
}

}  // namespace temblor::render
