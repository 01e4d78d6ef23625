// Draws rows of triangles with the engine's kernels, for techniques that find the rows in another way.
#pragma once

#include "base/arena.h"
#include "render/alias/affine_triangle.h"
#include "render/alias/rows/row_list.h"
#include "render/frame_buffer.h"

namespace temblor::lab {

struct RowKernels {
  render::PixelFormat format;
  bool simd;
};

class RowPainter {
 public:
  // `arena` and `target` must outlive it.
  RowPainter(const RowKernels& kernels, const render::TriangleTarget& target, base::Arena& arena);

  // The rows that follow are of this model. Draws those before.
  void begin_model(const render::TriangleJob& job);
  // Rows are drawn in the order in which they are added, tested against depth.
  void add(const render::TriangleSpan& span);
  void draw();

 private:
  const RowKernels kernels_;
  const render::TriangleTarget& target_;
  render::TriangleJob job_{};
  render::RowList& rows_;
};

}  // namespace temblor::lab
