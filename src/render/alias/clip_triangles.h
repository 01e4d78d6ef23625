// Clips the triangles of a model that crosses the near plane, or that is so near that parts of it are too far
// to the side to be projected. Few models need this, so clipping favors simplicity over speed.
#pragma once

#include <span>

#include "base/arena.h"
#include "render/alias/place_alias.h"
#include "render/alias/triangle_kernels.h"

namespace temblor::render {

// The input: a projected mesh.
struct ProjectedMesh {
  std::span<const ScreenVertex> vertices;  // valid for vertices inside all planes
  std::span<const float> view[3];          // x, y, z
  std::span<const TexelPoint> texels;
  std::span<const MeshTriangle> triangles;
};

// The remaining triangles, in the order of the triangles that they come from. The projected mesh's vertices
// keep their numbers; new vertices follow.
struct ClippedMesh {
  std::span<const ScreenVertex> vertices;
  std::span<const TexelPoint> texels;
  std::span<const MeshTriangle> triangles;
};

// Triangles that share an edge still share what is left of it, so no cracks appear. Lives in `arena`.
ClippedMesh clip_triangles(const ViewFrame& view, const AliasPlacement& placement, const ProjectedMesh& mesh,
                           std::int32_t steps_per_pixel, base::Arena& arena);

}  // namespace temblor::render
