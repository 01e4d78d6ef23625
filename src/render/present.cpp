#include "render/present.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "base/check.h"
#include "render/color/blend_tables.h"
#include "render/screen/present_kernels.h"

namespace temblor::render {

formats::Palette shown_palette(const FrameBuffer& frame, const formats::Palette& palette) {
  const Tint& tint = frame.palette_tint();
  const formats::Rgb color = to_bytes(tint.color / 255.0f);
  formats::Palette tinted = palette;
  for (formats::Rgb& entry : tinted) entry = blend_colors(color, entry, opacity_256(tint.opacity));
  return tinted;
}

void present(const FrameBuffer& frame, const formats::Palette& palette, bool simd_kernels, base::Jobs& jobs,
             std::span<std::uint32_t> out) {
  CHECK(out.size() == frame.pixel_count(), "{} pixels for a frame of {}", out.size(), frame.pixel_count());
  std::array<std::uint32_t, 256> colors;
  for (std::size_t i = 0; i < colors.size(); ++i) colors[i] = to_rgb(palette[i]);
  const std::size_t width = static_cast<std::size_t>(frame.width());
  const std::size_t height = static_cast<std::size_t>(frame.height());
  const std::size_t slices = std::min<std::size_t>(height, static_cast<std::size_t>(jobs.threads()) * 4);
  jobs.parallel_for(slices, [&](std::size_t slice) {
    const std::size_t first = height * slice / slices * width, last = height * (slice + 1) / slices * width;
    if (frame.format() == PixelFormat::kRgb) {
      std::memcpy(out.data() + first, frame.rgb().data() + first, (last - first) * sizeof(std::uint32_t));
      return;
    }
    const auto expand = simd_kernels ? expand_palette_simd : expand_palette_scalar;
    expand(frame.indexed().data() + first, last - first, colors.data(), out.data() + first);
  });
}

}  // namespace temblor::render
