// Draws the triangles of a walk. The first pixel on each row of an edge is computed once for both of its
// triangles.
#pragma once

#include "lab/models/deltas/mesh_neighbors.h"
#include "lab/models/edges/row_painter.h"

namespace temblor::lab {

struct WalkedModel {
  const render::TriangleJob* job;
  const MeshNeighbors* neighbors;
  VisibleWalk walk;
};

// Draws the rows of `target`. The result is that of draw_affine_triangle (affine_triangle.h).
void draw_walk(const WalkedModel& model, const render::TriangleTarget& target, RowPainter& io_painter,
               base::Arena& arena);

}  // namespace temblor::lab
