// Transforms the vertices of a model as one set: blends two poses, transforms, lights by normals, and
// projects. The SIMD version and the scalar reference have the same results, bit for bit. This header has
// plain types only, because the SIMD file is compiled for several processors.
#pragma once

#include <cstddef>
#include <cstdint>

namespace temblor::render {

// Subpixels per pixel: screen coordinates are integers in this unit, so that coverage is exact.
constexpr int kSubpixels = 256;
// Coordinates are clamped to this many pixels. Models that reach farther are clipped (place_alias.h).
constexpr float kGuardPixels = 65536.0f;

// A projected vertex.
struct ScreenVertex {
  std::int32_t x, y;  // in subpixels; pixel centers at multiples of kSubpixels; y down
  float depth;        // larger is nearer: 1/z times the job's depth_scale; parallel projection: -z
  float light;        // blended from `lights`, by the normals of both poses
};

// `Element` is what poses are stored as: bytes, as in MDL files, or 16 bits for models with finer positions.
template <typename Element>
struct PoseJob {
  // The two poses: x, y, z, and number of the normal, each by vertex.
  const Element* from[4];
  const Element* to[4];
  float blend;        // 0: from, 1: to
  std::size_t count;  // a multiple of 16
  // Elements to view space: x right, y up, z forward. The last column is added.
  float to_view[3][4];
  float center_x, center_y, pixels_per_unit;
  bool perspective;
  float near_z;  // nearer vertices are projected as if at this distance
  float depth_scale;
  // Coordinates are rounded to this; a divisor of kSubpixels.
  std::int32_t steps_per_pixel;
  // 256 elements, by normal.
  const float* lights;
  // `count` elements.
  ScreenVertex* out;
  // View-space x, y, z, `count` elements each; null: not needed.
  float* view[3];
};

using VertexJob = PoseJob<std::uint8_t>;
using WideVertexJob = PoseJob<std::uint16_t>;

void project_vertices_scalar(const VertexJob& job);
void project_vertices_scalar(const WideVertexJob& job);
void project_vertices_simd(const VertexJob& job);
void project_vertices_simd(const WideVertexJob& job);

}  // namespace temblor::render
