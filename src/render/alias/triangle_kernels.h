// Triangles of a model, drawn from projected vertices: the inner loops, as vector code and as plain C++ with
// the same results, bit for bit. Only plain types here: the vector file is compiled for several processors.
#pragma once

#include <cstddef>
#include <cstdint>

#include "render/alias/vertex_kernels.h"

namespace temblor::render {

struct TexelPoint {
  float s, t;
};

// A triangle whose front is seen and that has rows and columns between its corners; those smaller than a
// pixel often have none.
struct FrontTriangle {
  std::uint32_t corners[3];
  std::int16_t first_row, row_end;  // of those below row 0 or beyond 32767: cut off there
};

struct TriangleJob {
  const ScreenVertex* vertices;
  const TexelPoint* texels;        // by vertex
  const std::uint32_t* triangles;  // three vertices each, clockwise seen from the front
  std::size_t vertex_count, triangle_count;
  const std::uint8_t* skin;  // palette indices; rows follow one another
  std::int32_t skin_width, skin_height;
  // Bytes: 64 rows of 256, which `light` >> 8 chooses from. 32-bit colors: 256, 0xffRRGGBB, alpha 0: not
  // lit; `light` is as in build_kernels.h, half the sum.
  const void* colors;
  std::int32_t tint[3];  // 32-bit colors: red, green, blue of the light, of 32768
  bool perspective;      // false: affine whatever the triangle's size
  // What vector code draws, in the order of `triangles`: found once for all the bands of a picture.
  const FrontTriangle* fronts;
  std::size_t front_count;
};

// Room for job.triangle_count. Returns how many there are.
std::size_t find_front_triangles(const TriangleJob& job, FrontTriangle* out);

// Rows of `width` pixels; the first one in memory is `first_row` of the picture. What lies from row_begin to
// row_end is drawn.
struct TriangleTarget {
  void* pixels;
  float* depth;
  std::int32_t width, first_row, row_begin, row_end;
};

// A triangle whose corners' nearness differs so much that texels between them would be out of place by more
// than this is drawn in perspective.
constexpr float kAffineErrorTexels = 0.5f;
constexpr float kBrightestLight = 32640.0f;  // 32-bit colors
constexpr float kDarkestRow = 16383.0f;      // bytes

// Scan line by scan line (affine_triangle.h); vector code draws the job's `fronts`.
void draw_triangles_u8_scalar(const TriangleJob& job, const TriangleTarget& target);
void draw_triangles_u32_scalar(const TriangleJob& job, const TriangleTarget& target);
void draw_triangles_u8_simd(const TriangleJob& job, const TriangleTarget& target);
void draw_triangles_u32_simd(const TriangleJob& job, const TriangleTarget& target);

// What vector code leaves to plain code: out[i] is what the skin's texel number texels[i] shows as under
// light row lights[i], a multiple of 256; or, in 32 bits, its color, not lit.
void look_up_texels_u8(const TriangleJob& job, const std::int32_t* texels, const std::int32_t* lights,
                       std::size_t count, std::uint8_t* out);
void look_up_texels_u32(const TriangleJob& job, const std::int32_t* texels, std::size_t count,
                        std::uint32_t* out);

// By recursive subdivision (subdivide_triangles.cpp). All vertices lie inside the target's columns, and
// whole pixels inside int16.
void subdivide_triangles_u8(const TriangleJob& job, const TriangleTarget& target);
void subdivide_triangles_u32(const TriangleJob& job, const TriangleTarget& target);

}  // namespace temblor::render
