// Spans of sky: two layers that scroll over one another (the texture's left half, clouds, and behind its
// clear texels its right half), seen along the ray of each pixel.
#pragma once

#include "base/arena.h"
#include "render/frame.h"
#include "render/spans/span_kernels.h"
#include "render/surfaces/surface_draws.h"

namespace temblor::render {

// The ray of pixel (x, y) is forward + x * right + y * down, in the world; seen in parallel, all are forward.
struct SkyRays {
  math::Vec3d forward, right, down;
};
SkyRays sky_rays(const ViewFrame& view);

// For what kernels read of them: SkyRuns or SkyboxRuns.
template <typename Runs>
void set_rays(const SkyRays& rays, Runs& io_runs) {
  for (int axis = 0; axis < 3; ++axis) {
    io_runs.forward[axis] = rays.forward[axis];
    io_runs.right[axis] = rays.right[axis];
    io_runs.down[axis] = rays.down[axis];
  }
}

// For every sky item, all that its spans need but the spans and their depth; by item number, null for others.
// Memory comes from `arena`.
std::span<const SkyRuns*> prepare_sky_runs(const Scene& scene, const ViewFrame& view,
                                           const SurfaceDraws& items, const ColorTables& tables,
                                           PixelFormat format, base::Arena& arena);

}  // namespace temblor::render
