// Textures: square pictures whose side is a power of two, and smaller copies of them for far walls.
#pragma once

#include <cmath>
#include <vector>

#include "lab/school/picture.h"

namespace temblor::lab::school {

// The texel at (s, t), where the texture repeats at every whole number.
inline const Color& read_texel(const Picture& texture, float s, float t) {
  const auto side = static_cast<float>(texture.width());
  const int x = static_cast<int>(std::floor(s * side)), y = static_cast<int>(std::floor(t * side));
  return texture.color(x & (texture.width() - 1), y & (texture.width() - 1));
}

// Half the size: each texel is the mean of four.
inline Picture halve(const Picture& texture) {
  Picture half(texture.width() / 2, texture.width() / 2);
  for (int y = 0; y < half.height(); ++y)
    for (int x = 0; x < half.width(); ++x)
      half.color(x, y) = (texture.color(2 * x, 2 * y) + texture.color(2 * x + 1, 2 * y) +
                          texture.color(2 * x, 2 * y + 1) + texture.color(2 * x + 1, 2 * y + 1)) *
                         0.25f;
  return half;
}

// The texture and all its halves, down to one texel.
inline std::vector<Picture> make_mip_levels(const Picture& texture) {
  std::vector<Picture> levels{texture};
  while (levels.back().width() > 1) levels.push_back(halve(levels.back()));
  return levels;
}

// The level at which a pixel is about as wide as a texel, if it is `texels_per_pixel` wide at level 0.
inline std::size_t choose_mip_level(float texels_per_pixel, std::size_t levels) {
  std::size_t level = 0;
  for (; level + 1 < levels && texels_per_pixel >= 2; texels_per_pixel /= 2) ++level;
  return level;
}

}  // namespace temblor::lab::school
