// Draws a model from its stream of commands: transformed vertices exist only in the stack.
#pragma once

#include "base/arena.h"
#include "lab/models/stack/stack_mesh.h"
#include "render/alias/place_alias.h"
#include "render/alias/triangle_kernels.h"
#include "render/frame_buffer.h"

namespace temblor::lab {

// The rows of the triangles of a group, and those of it and of later groups that draw with its vertices.
// Without triangles that face front, `first` is above `end`.
struct GroupRows {
  render::TriangleRows drawn, needed;
};

// An instance in a frame. It refers to its mesh and to an arena.
struct StackInstance {
  const StackMesh* mesh;
  render::TriangleJob skin;     // without vertices and triangles
  render::VertexJob transform;  // with poses, without `count` and outputs; the other one has no poses
  render::WideVertexJob wide_transform;
  int first_row, row_end;  // the rows that it may touch
  // By group, for a model in many bands; otherwise empty.
  std::span<const GroupRows> group_rows;
};

struct StackKernels {
  render::PixelFormat format;
  bool simd;
};

// Transforms all groups once, so that each band needs to transform only some. Lives in `arena`.
std::span<const GroupRows> find_group_rows(const StackInstance& instance, bool simd, base::Arena& arena);

// Draws the rows of `target`, group by group. The result is that of scan lines with the triangles in the
// order of the stream.
void draw_groups(const StackInstance& instance, const StackKernels& kernels,
                 const render::TriangleTarget& target);

// The same, command by command: each push transforms one vertex, and each draw sets up one triangle. `arena`
// is for temporary memory.
void draw_commands(const StackInstance& instance, const StackKernels& kernels,
                   const render::TriangleTarget& target, base::Arena& arena);

}  // namespace temblor::lab
