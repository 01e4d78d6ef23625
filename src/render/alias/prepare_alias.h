// Prepares one visible instance: from its poses to triangles on the screen that only need to be filled.
//
//   poses -> project_vertices -> clip_triangles (rarely) -> find_front_triangles -> PreparedAlias
#pragma once

#include "base/arena.h"
#include "render/alias/light_alias.h"
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

// The steps of prepare_alias, for techniques that transform vertices in another way.
//
// The light on the instance, by the frame's settings.
AliasLight choose_light(const FrameContext& context, const AliasInstance& instance);
// Transform, projection, and blending. Poses, `count`, `lights`, and outputs are left empty. `Element` is a
// byte or 16 bits.
template <typename Element>
PoseJob<Element> make_pose_job(const FrameContext& context, const ViewFrame& view,
                               const AliasPlacement& placement);
// Skin, colors, and how triangles are drawn. Vertices and triangles are left empty.
TriangleJob make_skin_job(const FrameContext& context, const AliasPlacement& placement,
                          const AliasLight& light, base::Arena& arena);

// The result refers to the model, to the color tables, and to `arena`.
PreparedAlias prepare_alias(const FrameContext& context, const ViewFrame& view,
                            const AliasPlacement& placement, base::Arena& arena);

}  // namespace temblor::render
