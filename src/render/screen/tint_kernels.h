// The inner loop of PictureTint for rgb frames, as SIMD and as the scalar reference with the same results,
// bit for bit. Plain types only, because the SIMD file is compiled for several processors.
#pragma once

#include <cstddef>
#include <cstdint>

namespace temblor::render {

// Each channel becomes (tint * opacity + own * (256 - opacity) + 128) >> 8; alpha becomes 255.
struct TintJob {
  std::uint32_t* pixels;
  std::size_t count;
  std::uint32_t color;
  std::int32_t opacity_256;
};

// The scalar version begins at pixel `first`, so that it can finish what SIMD leaves.
void tint_rgb_scalar(const TintJob& job, std::size_t first = 0);
void tint_rgb_simd(const TintJob& job);

}  // namespace temblor::render
