// How far the texel coordinates of a pixel are from exact ones.
#pragma once

#include "lab/technique.h"
#include "render/surfaces/surface_draws.h"

namespace temblor::lab {

// The position on the texture that a pixel shows, clamped to the block like in the span kernels.
struct TexelPosition {
  double s, t;
};
struct PixelPlace {
  int x, y;
};

TexelPosition find_texel(const render::SurfaceDraw& draw, PixelPlace pixel, double z);
TexelPosition find_exact_texel(const render::SurfaceDraw& draw, PixelPlace pixel);

// Both change Counts::pixels_off and max_texel_error. The second is for a pixel with another z than the exact
// one.
void compare_texels(const TexelPosition& shown, const TexelPosition& exact, Counts& io_counts);
void compare_texels(const render::SurfaceDraw& draw, PixelPlace pixel, double z, Counts& io_counts);

}  // namespace temblor::lab
