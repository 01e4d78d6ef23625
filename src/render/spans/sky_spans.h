// Spans of sky: two layers that scroll over each other. The left half of the texture is the cloud layer; the
// right half is the background, which shows through the clear texels of the clouds.
//
// The direction of each pixel's ray, with z stretched threefold, selects the texel, as in stock Quake: a
// flattened dome that moves with the eye.
#pragma once

#include "base/arena.h"
#include "render/frame_buffer.h"
#include "render/spans/span_kernels.h"
#include "render/surfaces/surface_draws.h"

namespace temblor::render {

// The ray of pixel (x, y) is forward + x * right + y * down, in world space, of any length. In parallel
// projection all rays are `forward`.
struct SkyRays {
  math::Vec3d forward, right, down;
};
// Rays for the skies of this frame; also used by skyboxes.
SkyRays sky_rays(const ViewFrame& view);

// Copies the rays to a kernel's input: SkySpans or SkyboxSpans.
template <typename Spans>
void set_rays(const SkyRays& rays, Spans& io_spans) {
  for (int axis = 0; axis < 3; ++axis) {
    io_spans.forward[axis] = rays.forward[axis];
    io_spans.right[axis] = rays.right[axis];
    io_spans.down[axis] = rays.down[axis];
  }
}

// For every draw of kind kSky: everything that its kernel needs except the spans and their depth. By draw
// number, null for other draws. Lives in the frame's arena.
std::span<const SkySpans*> prepare_sky_spans(const FrameContext& context, const ViewFrame& view,
                                             const SurfaceDraws& draws);

}  // namespace temblor::render
