#include <cmath>

#include "render/alias/vertex_kernels.h"

namespace temblor::render {

namespace {

template <typename Element>
float blended(const Element* from, const Element* to, std::size_t i, float blend) {
  const float a = from[i], b = to[i];
  return a + (b - a) * blend;
}

// Rounds to the nearest step, ties to even, as SIMD conversions do.
std::int32_t to_subpixels(float pixels, std::int32_t steps_per_pixel) {
  float inside = pixels > -kGuardPixels ? pixels : -kGuardPixels;
  inside = inside < kGuardPixels ? inside : kGuardPixels;
  return static_cast<std::int32_t>(std::nearbyint(inside * static_cast<float>(steps_per_pixel))) *
         (kSubpixels / steps_per_pixel);
}

// The order of operations defines the result; the SIMD version has the same order and no fused multiply-adds.
template <typename Element>
void project(const PoseJob<Element>& job) {
  for (std::size_t i = 0; i < job.count; ++i) {
    const float x = blended(job.from[0], job.to[0], i, job.blend);
    const float y = blended(job.from[1], job.to[1], i, job.blend);
    const float z = blended(job.from[2], job.to[2], i, job.blend);
    float view[3];
    for (int axis = 0; axis < 3; ++axis) {
      const float* row = job.to_view[axis];
      view[axis] = row[0] * x + row[1] * y + row[2] * z + row[3];
      if (job.view[axis] != nullptr) job.view[axis][i] = view[axis];
    }
    ScreenVertex& out = job.out[i];
    float scale = job.pixels_per_unit;
    out.depth = -view[2];
    if (job.perspective) {
      const float nearness = 1.0f / (view[2] > job.near_z ? view[2] : job.near_z);
      scale = job.pixels_per_unit * nearness;
      out.depth = nearness * job.depth_scale;
    }
    out.x = to_subpixels(job.center_x + view[0] * scale, job.steps_per_pixel);
    out.y = to_subpixels(job.center_y - view[1] * scale, job.steps_per_pixel);
    const float light_from = job.lights[job.from[3][i]], light_to = job.lights[job.to[3][i]];
    out.light = light_from + (light_to - light_from) * job.blend;
  }
}

}  // namespace

void project_vertices_scalar(const VertexJob& job) {
  project(job);
}

void project_vertices_scalar(const WideVertexJob& job) {
  project(job);
}

}  // namespace temblor::render
