// Finds the visible parts of all models' triangles in a band of rows, without a depth buffer among them.
//
//   triangles -> edges -> active edges by column -> intervals -> the nearest of the triangles there -> spans
//
// Depths are compared at the first pixel of an interval between two edges, among all triangles that cover it,
// so a triangle that pierces another one within an interval is wrong there.
#pragma once

#include <span>

#include "base/arena.h"
#include "lab/technique.h"
#include "render/alias/affine_triangle.h"
#include "render/alias/prepare_alias.h"
#include "render/frame_buffer.h"

namespace temblor::lab {

// Pixels of a triangle of model number `model`.
struct ModelSpan {
  std::uint32_t model;
  render::TriangleSpan span;
};

struct ModelScan {
  std::span<const ModelSpan> spans;  // row by row, from left to right
  Counts counts;
};

// `uses_tree`: keeps the active edges in a tree, not in a list. Results live in `arena`.
ModelScan scan_models(std::span<const render::PreparedAlias> models, render::RowRange rows, int width,
                      bool uses_tree, base::Arena& arena);

}  // namespace temblor::lab
