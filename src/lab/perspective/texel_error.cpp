#include "lab/perspective/texel_error.h"

#include <algorithm>
#include <cmath>

namespace temblor::lab {

TexelPosition find_texel(const render::SurfaceDraw& draw, PixelPlace pixel, double z) {
  return {std::clamp(draw.s.at(pixel.x, pixel.y) * z, 0.0, draw.block.shape.width - 1.0),
          std::clamp(draw.t.at(pixel.x, pixel.y) * z, 0.0, draw.block.shape.height - 1.0)};
}

TexelPosition find_exact_texel(const render::SurfaceDraw& draw, PixelPlace pixel) {
  return find_texel(draw, pixel,
                    1 / std::max(draw.depth.at(pixel.x, pixel.y), double{render::kMinSpanDepth}));
}

void compare_texels(const TexelPosition& shown, const TexelPosition& exact, Counts& io_counts) {
  io_counts.pixels_off +=
      std::floor(shown.s) != std::floor(exact.s) || std::floor(shown.t) != std::floor(exact.t);
  io_counts.max_texel_error =
      std::max({io_counts.max_texel_error, std::abs(shown.s - exact.s), std::abs(shown.t - exact.t)});
}

void compare_texels(const render::SurfaceDraw& draw, PixelPlace pixel, double z, Counts& io_counts) {
  compare_texels(find_texel(draw, pixel, z), find_exact_texel(draw, pixel), io_counts);
}

}  // namespace temblor::lab
