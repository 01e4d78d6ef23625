// Hot loop. It finds rows, which the engine's kernels draw.
#include "lab/models/deltas/walk_painter.h"

#include <algorithm>
#include <array>

namespace temblor::lab {

namespace {

// The first pixel that is not left of the edge, for rows `first` up to `end`.
struct EdgeRows {
  const std::int32_t* columns = nullptr;  // null: not computed yet
  std::int32_t first = 0, end = 0;
};

std::int32_t first_pixel(std::int32_t subpixels) {
  return (subpixels + (render::kSubpixels - 1)) >> 8;
}

class WalkPainter {
 public:
  WalkPainter(const WalkedModel& model, const render::TriangleTarget& target, RowPainter& io_painter,
              base::Arena& arena)
      : job_(*model.job),
        neighbors_(*model.neighbors),
        target_(target),
        painter_(io_painter),
        arena_(arena),
        edges_(arena.allocate_filled(neighbors_.edge_count(), EdgeRows{})) {}

  void draw(std::uint32_t number) {
    const std::uint32_t* const index = job_.triangles + 3 * std::size_t{number};
    const render::ScreenVertex* const corner[3] = {job_.vertices + index[0], job_.vertices + index[1],
                                                   job_.vertices + index[2]};
    const auto [top, bottom] = std::minmax({corner[0]->y, corner[1]->y, corner[2]->y});
    const std::int32_t first = bound(first_pixel(top)), end = bound(first_pixel(bottom));
    const auto [left, right] = std::minmax({corner[0]->x, corner[1]->x, corner[2]->x});
    if (first >= end || first_pixel(left) >= first_pixel(right)) return;
    const std::int64_t cross =
        (std::int64_t{corner[1]->x} - corner[0]->x) * (std::int64_t{corner[2]->y} - corner[0]->y) -
        (std::int64_t{corner[2]->x} - corner[0]->x) * (std::int64_t{corner[1]->y} - corner[0]->y);
    const render::TexelPoint* const texel[3] = {job_.texels + index[0], job_.texels + index[1],
                                                job_.texels + index[2]};
    const bool perspective =
        job_.perspective && (job_.always_perspective || render::needs_perspective(corner, texel));
    const render::TriangleGradients gradients =
        render::triangle_gradients(corner, texel, static_cast<double>(cross), perspective);
    // Corners are clockwise, so edges that go down are on the right.
    const EdgeRows *lefts[3], *rights[3];
    std::size_t left_count = 0, right_count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const render::ScreenVertex &from = *corner[i], &to = *corner[(i + 1) % 3];
      if (from.y == to.y) continue;
      const EdgeRows& rows =
          find_rows(neighbors_.sides(number)[i].edge, from.y < to.y ? from : to, from.y < to.y ? to : from);
      if (from.y < to.y)
        rights[right_count++] = &rows;
      else
        lefts[left_count++] = &rows;
    }
    for (std::int32_t y = first; y < end; ++y) {
      const std::int32_t begin_x = column_at(lefts, left_count, y), end_x = column_at(rights, right_count, y);
      if (begin_x < end_x) painter_.add(render::span_at(gradients, begin_x, y, end_x - begin_x));
    }
  }

 private:
  std::int32_t bound(std::int32_t row) const { return std::clamp(row, target_.row_begin, target_.row_end); }

  const EdgeRows& find_rows(std::uint32_t edge, const render::ScreenVertex& upper,
                            const render::ScreenVertex& lower) {
    EdgeRows& io_rows = edges_[edge];
    if (io_rows.columns != nullptr) return io_rows;
    io_rows.first = bound(first_pixel(upper.y));
    io_rows.end = bound(first_pixel(lower.y));
    const auto count = static_cast<std::size_t>(std::max(io_rows.end - io_rows.first, 0));
    const std::span<std::int32_t> columns = arena_.allocate<std::int32_t>(count + 1);
    render::EdgeColumns steps(upper, lower, io_rows.first);
    for (std::size_t i = 0; i < count; ++i) columns[i] = steps.next(target_.width);
    io_rows.columns = columns.data();
    return io_rows;
  }

  static std::int32_t column_at(const EdgeRows* const (&edges)[3], std::size_t count, std::int32_t y) {
    for (std::size_t i = 0; i < count; ++i)
      if (y >= edges[i]->first && y < edges[i]->end) return edges[i]->columns[y - edges[i]->first];
    return 0;
  }

  const render::TriangleJob& job_;
  const MeshNeighbors& neighbors_;
  const render::TriangleTarget& target_;
  RowPainter& painter_;
  base::Arena& arena_;
  std::span<EdgeRows> edges_;
};

}  // namespace

void draw_walk(const WalkedModel& model, const render::TriangleTarget& target, RowPainter& io_painter,
               base::Arena& arena) {
  io_painter.begin_model(*model.job);
  WalkPainter painter(model, target, io_painter, arena);
  for (const std::uint32_t triangle : model.walk.triangles) painter.draw(triangle);
}

}  // namespace temblor::lab
