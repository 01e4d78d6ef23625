// Pictures that are larger than the card's textures. Their sides are halved until they fit, so that a frame
// shows them coarsely instead of failing.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "render_gl/gl/functions.h"

namespace temblor::render_gl {

// The longest side of a texture, and the layers of an array texture.
struct TextureLimits {
  int side = 1, layers = 1;
};
inline TextureLimits find_texture_limits(const Functions& gl) {
  TextureLimits limits;
  gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &limits.side);
  gl.GetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &limits.layers);
  return limits;
}

// A side of at least one texel after so many halvings.
constexpr int halve(int side, int halvings) {
  return std::max(side >> halvings, 1);
}

// How often both sides must be halved until neither is longer than `limit`, which is positive.
constexpr int count_halvings(int width, int height, int limit) {
  int halvings = 0;
  while (halve(std::max(width, height), halvings) > limit) ++halvings;
  return halvings;
}

// Every 2^halvings-th texel of every 2^halvings-th row. Texels are not blended, since some are clear and some
// are indices. `texels` has width * height of them.
template <typename Texel>
std::vector<Texel> halve_picture(const Texel* texels, int width, int height, int halvings) {
  std::vector<Texel> out;
  const int out_width = halve(width, halvings), out_height = halve(height, halvings);
  out.reserve(static_cast<std::size_t>(out_width) * static_cast<std::size_t>(out_height));
  for (int row = 0; row < out_height; ++row)
    for (int column = 0; column < out_width; ++column)
      out.push_back(texels[static_cast<std::ptrdiff_t>(row << halvings) * width + (column << halvings)]);
  return out;
}

}  // namespace temblor::render_gl
