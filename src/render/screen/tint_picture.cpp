#include "render/screen/tint_picture.h"

#include <algorithm>

#include "render/color/blend_tables.h"
#include "render/screen/tint_kernels.h"

namespace temblor::render {

PictureTint::PictureTint(const Tint& tint, PixelFormat format, bool simd_kernels)
    : opacity_256_(format == PixelFormat::kRgb ? opacity_256(tint.opacity) : 0),
      rgb_(to_rgb(to_bytes(tint.color / 255.0f))),
      simd_kernels_(simd_kernels) {}

void PictureTint::apply(std::span<std::uint32_t> io_rgb) const {
  const TintJob job{io_rgb.data(), io_rgb.size(), rgb_, opacity_256_};
  simd_kernels_ ? tint_rgb_simd(job) : tint_rgb_scalar(job);
}

void PictureTint::apply_to_rows(RowRange rows, FrameBuffer& io_frame) const {
  const auto width = static_cast<std::size_t>(io_frame.width());
  const std::size_t first = static_cast<std::size_t>(rows.first) * width;
  const std::size_t count = static_cast<std::size_t>(rows.end - rows.first) * width;
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
