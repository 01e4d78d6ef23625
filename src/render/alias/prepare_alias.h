// One instance in view, from its poses to triangles on the screen that only need to be filled.
#pragma once

#include "base/arena.h"
#include "render/alias/place_alias.h"
#include "render/alias/triangle_kernels.h"
#include "render/color/color_tables.h"
#include "render/renderer.h"

namespace temblor::render {

// Below so many pixels from end to end, a model's triangles are drawn by subdivision where the rasterizer is
// chosen by size: the mean length of their sides, at the nearest point of the model's box. Up to 2 its
// picture differs little enough from affine's, but from here on it is slower (docs/performance.md).
constexpr double kSubdivisionSidePx = 1.35;

struct PreparedAlias {
  TriangleJob job;
  bool by_subdivision;
  int first_row, row_end;  // that it may touch
};

// What is pointed to is the model's, the tables' and the arena's.
PreparedAlias prepare_alias(const Scene& scene, const Settings& settings, const ViewFrame& view,
                            const AliasPlacement& placement, const ColorTables& tables, PixelFormat format,
                            base::Arena& arena);

}  // namespace temblor::render
