// Triangles of a model that comes nearer than the near plane, or so near that parts of it lie too far to the
// side to be projected: cut off there.
#pragma once

#include <span>

#include "base/arena.h"
#include "render/alias/place_alias.h"
#include "render/alias/triangle_kernels.h"

namespace temblor::render {

// A mesh as projected: what clipping starts from.
struct ProjectedMesh {
  std::span<const ScreenVertex> vertices;  // right where clipping leaves them alone
  std::span<const float> view[3];          // x, y, z
  std::span<const TexelPoint> texels;
  std::span<const MeshTriangle> triangles;
};

// The triangles that are left, in the order of those that they are pieces of. Vertices up to the projected
// mesh's number are the same.
struct ClippedMesh {
  std::span<const ScreenVertex> vertices;
  std::span<const TexelPoint> texels;
  std::span<const MeshTriangle> triangles;
};

// Two triangles that share an edge still share what is left of it.
ClippedMesh clip_triangles(const ViewFrame& view, const AliasPlacement& placement, const ProjectedMesh& mesh,
                           std::int32_t steps_a_pixel, base::Arena& arena);

}  // namespace temblor::render
