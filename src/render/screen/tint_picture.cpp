#include "render/screen/tint_picture.h"

#include <algorithm>
#include <cstring>

#include "render/screen/tint_kernels.h"

namespace temblor::render {

PictureTint::PictureTint(const Tint& tint, const ColorTables& tables, PixelFormat format, bool simd_kernels)
    : opacity_256_(opacity_256(tint.opacity)), simd_kernels_(simd_kernels) {
  if (!changes_pixels()) return;
  const formats::Rgb color = to_bytes(tint.color / 255.0f);
  rgb_ = to_rgb(color);
  if (format != PixelFormat::kIndexed) return;
  for (std::size_t i = 0; i < remap_.size(); ++i)
    remap_[i] =
        tables.match(blend_colors(color, tables.palette[i], opacity_256_), tables.match.is_fullbright(i));
}

// Hot loop. Eight pixels are read before any is written: byte stores may alias the table, so the compiler
// would otherwise reload after each one.
void PictureTint::apply(std::span<std::uint8_t> io_indexed) const {
  constexpr std::size_t kTogether = 8;
  std::size_t i = 0;
  for (; i + kTogether <= io_indexed.size(); i += kTogether) {
    std::array<std::uint8_t, kTogether> now;
    for (std::size_t k = 0; k < kTogether; ++k) now[k] = remap_[io_indexed[i + k]];
    std::memcpy(&io_indexed[i], now.data(), kTogether);
  }
  for (; i < io_indexed.size(); ++i) io_indexed[i] = remap_[io_indexed[i]];
}

void PictureTint::apply(std::span<std::uint32_t> io_rgb) const {
  const TintJob job{io_rgb.data(), io_rgb.size(), rgb_, opacity_256_};
  simd_kernels_ ? tint_rgb_simd(job) : tint_rgb_scalar(job);
}

void PictureTint::apply_to_rows(RowRange rows, FrameBuffer& io_frame) const {
  const auto width = static_cast<std::size_t>(io_frame.width());
  const std::size_t first = static_cast<std::size_t>(rows.first) * width;
  const std::size_t count = static_cast<std::size_t>(rows.end - rows.first) * width;
  if (io_frame.format() == PixelFormat::kIndexed)
    apply(io_frame.indexed().subspan(first, count));
  else
    apply(io_frame.rgb().subspan(first, count));
}

void tint_picture(const PictureTint& tint, base::Jobs& jobs, FrameBuffer& io_frame) {
  constexpr int kRowsPerJob = 16;
  if (!tint.changes_pixels()) return;
  const int height = io_frame.height();
  jobs.parallel_for(static_cast<std::size_t>((height + kRowsPerJob - 1) / kRowsPerJob), [&](std::size_t job) {
    const int first = static_cast<int>(job) * kRowsPerJob;
    tint.apply_to_rows({first, std::min(first + kRowsPerJob, height)}, io_frame);
  });
}

}  // namespace temblor::render
