// The vertices of a model as one set: two poses blended, transformed, lit by their normals, projected. As
// vector code and as plain C++ with the same results, bit for bit. Only plain types here: the vector file is
// compiled for several processors.
#pragma once

#include <cstddef>
#include <cstdint>

namespace temblor::render {

// Screen coordinates are counted in this part of a pixel, so that what a triangle covers is exact.
constexpr int kSubpixels = 256;
// Vertices farther out than this many pixels are clipped before; kernels cut their coordinates off.
constexpr float kGuardPixels = 65536.0f;

struct ScreenVertex {
  std::int32_t x, y;  // in 1/kSubpixels, centers of pixels at multiples of it, y down
  float depth;        // larger is nearer: 1/z times the job's depth_scale; seen in parallel, -z
  float light;        // what `lights` has for its normal
};

struct VertexJob {
  // x, y, z and number of the normal, by vertex.
  const std::uint8_t* from[4];
  const std::uint8_t* to[4];
  float blend;        // 0: from, 1: to
  std::size_t count;  // a multiple of 16
  // Bytes to view space: x right, y up, z forward. The last column is added.
  float to_view[3][4];
  float center_x, center_y, pixels_per_unit;
  bool perspective;
  float near_z;  // nearer vertices are projected as if there
  float depth_scale;
  std::int32_t steps_a_pixel;  // that coordinates are rounded to: a divisor of kSubpixels
  const float* lights;         // 256, by normal
  ScreenVertex* out;           // `count`
  float* view[3];              // view-space x, y, z, `count` each; null: not wanted
};

void project_vertices_scalar(const VertexJob& job);
void project_vertices_simd(const VertexJob& job);

}  // namespace temblor::render
