// Recursive subdivision as in render/alias/subdivide_triangles.cpp, for triangles that may reach out of the
// target, and with light that is split like texels. Parts of triangles outside of the target are not split
// any further. Triangles with sides of more than 1024 pixels are drawn by scan lines.
#pragma once

#include "render/alias/prepare_alias.h"
#include "render/frame_buffer.h"

namespace temblor::lab {

struct SplitRules {
  render::PixelFormat format;
  bool splits_light;  // false: a triangle has the light of its first vertex
  // All vertices lie inside the target's columns. Otherwise only those of front faces are drawn: others may
  // be behind the eye.
  bool inside_screen;
};

void split_triangles(const render::TriangleJob& job, const SplitRules& rules,
                     const render::TriangleTarget& target);

// The rows of a prepared model in a frame. Empty if row_begin >= row_end.
render::TriangleTarget make_model_target(const render::PreparedAlias& alias, render::RowRange rows,
                                         render::FrameBuffer& io_frame);

}  // namespace temblor::lab
