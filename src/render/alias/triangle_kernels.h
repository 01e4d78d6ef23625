// Inner loops that draw the triangles of a model from projected vertices, as SIMD and as the scalar reference
// with the same results, bit for bit. This header has plain types only, because the SIMD file is compiled for
// several processors.
#pragma once

#include <cstddef>
#include <cstdint>

#include "render/alias/vertex_kernels.h"

namespace temblor::render {

// A position on a skin, in texels.
struct TexelPoint {
  float s, t;
};

// The rows of a triangle, clamped to 0 to 32767.
struct TriangleRows {
  std::int16_t first, end;
};

// The front-facing triangles whose bounding box contains at least one pixel center. Triangles smaller than a
// pixel often contain none. Both arrays have room for kFrontsSpare more elements, because whole vectors are
// written.
struct FrontTriangles {
  std::uint32_t* numbers;  // in increasing order
  TriangleRows* rows;
  std::size_t count;
};
constexpr std::size_t kFrontsSpare = 8;

// The triangles of one model instance.
struct TriangleJob {
  const ScreenVertex* vertices;
  const TexelPoint* texels;        // by vertex
  const std::uint32_t* triangles;  // three vertices each, clockwise seen from the front
  std::size_t vertex_count, triangle_count;
  const std::uint8_t* skin;  // palette indices; rows follow one another
  std::int32_t skin_width, skin_height;
  // Indexed: 64 rows of 256 indices; light >> 8 is the row. Rgb: 256 colors 0xffRRGGBB, alpha 0 for
  // full-bright ones; light is half the light sum, as in build_kernels.h.
  const void* colors;
  std::int32_t tint[3];  // rgb: red, green, blue of the light, in 32768ths
  bool perspective;      // false: affine whatever the triangle's size
  // With `perspective`: every triangle is drawn in perspective, also those for which it does not show.
  bool always_perspective;
  // SIMD only: most rows of the triangles have one to three pixels. Changes the order of work, not the
  // result.
  bool has_short_rows;
  FrontTriangles fronts;  // SIMD only: found once for all bands of a picture
};

// Fills the arrays of io_fronts, which have room for job.triangle_count and kFrontsSpare elements.
void find_front_triangles_scalar(const TriangleJob& job, FrontTriangles& io_fronts);
void find_front_triangles_simd(const TriangleJob& job, FrontTriangles& io_fronts);

// The destination: rows of `width` pixels, of which the first in memory is row `first_row` of the picture.
// Only rows from row_begin up to row_end (exclusive) are drawn.
struct TriangleTarget {
  void* pixels;
  float* depth;
  std::int32_t width, first_row, row_begin, row_end;
};

// A triangle is drawn in perspective if affine texels would be off by more than this.
constexpr float kAffineErrorTexels = 0.5f;
constexpr float kBrightestLight = 32640.0f;  // rgb: the largest light
constexpr float kDarkestRow = 16383.0f;      // indexed: the largest light, which is the darkest

// Scan line by scan line (affine_triangle.h). The SIMD versions draw the job's `fronts`.
void draw_triangles_u8_scalar(const TriangleJob& job, const TriangleTarget& target);
void draw_triangles_u32_scalar(const TriangleJob& job, const TriangleTarget& target);
void draw_triangles_u8_simd(const TriangleJob& job, const TriangleTarget& target);
void draw_triangles_u32_simd(const TriangleJob& job, const TriangleTarget& target);

// The table lookups that SIMD code leaves to scalar code. Indexed: out[i] is the skin's texel number
// texels[i] in light row lights[i], a multiple of 256. Rgb: its color, unlit.
void look_up_texels_u8(const TriangleJob& job, const std::int32_t* texels, const std::int32_t* lights,
                       std::size_t count, std::uint8_t* out);
void look_up_texels_u32(const TriangleJob& job, const std::int32_t* texels, std::size_t count,
                        std::uint32_t* out);

// By recursive subdivision (subdivide_triangles.cpp). All vertices must lie inside the target's columns, and
// their pixel coordinates must fit 16 bits.
void subdivide_triangles_u8(const TriangleJob& job, const TriangleTarget& target);
void subdivide_triangles_u32(const TriangleJob& job, const TriangleTarget& target);

}  // namespace temblor::render
