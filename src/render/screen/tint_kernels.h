// The inner loop of tint_picture, as vector code and as plain C++ with the same results. Only plain types
// here: the vector file is compiled for several processors.
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

// From pixel `first` on.
void tint_rgb_scalar(const TintJob& job, std::size_t first = 0);
void tint_rgb_simd(const TintJob& job);

}  // namespace temblor::render
