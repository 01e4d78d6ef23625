// Prepares one visible instance: from its poses to triangles on the screen that only need to be filled.
//
//   poses -> project_vertices -> clip_triangles (rarely) -> find_front_triangles -> PreparedAlias
#pragma once

#include "base/arena.h"
#include "render/alias/place_alias.h"
#include "render/alias/triangle_kernels.h"
#include "render/view/frame_context.h"

namespace temblor::render {

// With AliasRaster::kAuto, models whose triangles have shorter sides than this (pixels; mean length at the
// nearest point of the model's box) are drawn by subdivision. Up to 2 pixels its picture differs little from
// the affine rasterizer's, but above this limit it is slower (docs/performance.md).
constexpr double kSubdivisionSidePx = 1.35;

// An instance that is ready to be filled.
struct PreparedAlias {
  TriangleJob job;
  bool by_subdivision;
  int first_row, row_end;  // the rows that it may touch
};

// The result refers to the model, to the color tables, and to `arena`.
PreparedAlias prepare_alias(const FrameContext& context, const ViewFrame& view,
                            const AliasPlacement& placement, base::Arena& arena);

}  // namespace temblor::render
