// How far affine texture coordinates are from exact ones.
#pragma once

#include "lab/technique.h"
#include "render/surfaces/surface_draws.h"

namespace temblor::lab {

// Compares all pixels of the spans. `pixels`: from one exact pixel to the next (SurfaceSpans::affine_pixels).
// Sets Counts::pixels_off and max_texel_error; texels are those of the drawn mip level.
Counts find_affine_error(const render::SurfaceDraw& draw, std::span<const render::Span> spans, int pixels);

}  // namespace temblor::lab
