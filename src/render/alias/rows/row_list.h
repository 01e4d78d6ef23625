// Rows of triangles, listed before any of them is drawn: the number of rows and pixels of a triangle is
// unpredictable, and a branch that depends on it would stall until the triangle's divisions are done. The
// list passes from triangle_kernels_simd.cpp to row_kernels_simd.cpp; both use vectors of the same length.
//
//   group by triangles    vector 0: first row of triangles 0 1 2 ...    vector 1: their second rows    ...
//   group by rows         one vector: rows of one triangle
#pragma once

#include <cstddef>
#include <cstdint>

#include "render/alias/triangle_kernels.h"

namespace temblor::render {

struct RowList {
  static constexpr std::size_t kCapacity = 256, kMaxLanes = 8;
  static constexpr std::size_t kMaxGroupRows = 64;          // eight vectors of eight
  static constexpr std::size_t kMaxGroups = kCapacity / 2;  // of one vector, which has at least two rows

  alignas(64) std::int32_t place[kCapacity];        // of the row's first pixel in the target
  alignas(64) std::int32_t count[kCapacity];        // not positive: the row has no pixels
  alignas(64) std::int32_t perspective[kCapacity];  // 0 or -1
  // Four values vary along a row: depth, light, s, and t. Each begins at `value` and changes by `step` per
  // pixel.
  alignas(64) float value[4][kCapacity], step[4][kCapacity];
  std::size_t size;
  // Without short rows: the numbers of the rows that have pixels, in drawing order. Pixels must meet the
  // triangles in their order.
  alignas(64) std::int32_t order[kCapacity + kMaxLanes];
  std::size_t ordered;
  // With short rows: the end of each group, as a number of rows. Groups are ordered when they are drawn.
  std::int32_t group_end[kMaxGroups];
  std::size_t groups;
};

// Draw the list by job.has_short_rows.
void draw_rows_u8_simd(const TriangleJob& job, const RowList& rows, const TriangleTarget& target);
void draw_rows_u32_simd(const TriangleJob& job, const RowList& rows, const TriangleTarget& target);

}  // namespace temblor::render
