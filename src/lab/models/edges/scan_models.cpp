#include "lab/models/edges/scan_models.h"

#include <algorithm>
#include <array>

#include "lab/models/edges/model_edges.h"

namespace temblor::lab {

namespace {

using render::ScreenVertex;

struct ScannedTriangle {
  render::TriangleGradients gradients;
  std::uint32_t model;
  std::int32_t inside;  // leading edges that were passed, less trailing ones
};

std::int32_t first_pixel(std::int32_t steps) {
  return (steps + (render::kSubpixels - 1)) >> 8;
}

// The triangles and edges of a band, with the edges by the row in which they begin.
class BandEdges {
 public:
  BandEdges(std::span<const render::PreparedAlias> models, render::RowRange rows, int width,
            base::Arena& arena)
      : rows_(rows), width_(width), triangles_(arena, 1024), edges_(arena, 4096), first_rows_(arena, 4096) {
    for (std::size_t model = 0; model < models.size(); ++model) {
      const render::PreparedAlias& alias = models[model];
      if (alias.row_end <= rows.first || alias.first_row >= rows.end) continue;
      for (std::size_t i = 0; i < alias.job.triangle_count; ++i)
        add(alias.job, i, static_cast<std::uint32_t>(model));
    }
    sort_by_rows(arena);
  }

  std::span<ScannedTriangle> triangles() { return triangles_.view(); }
  std::span<ModelEdge> edges() { return edges_.view(); }
  std::span<const std::uint32_t> begin_in(int row) const {
    const auto number = static_cast<std::size_t>(row - rows_.first);
    return order_.subspan(begin_[number], begin_[number + 1] - begin_[number]);
  }

 private:
  void add(const render::TriangleJob& job, std::size_t number, std::uint32_t model) {
    const std::uint32_t* index = job.triangles + number * 3;
    const std::array<const ScreenVertex*, 3> corner{job.vertices + index[0], job.vertices + index[1],
                                                    job.vertices + index[2]};
    const std::int64_t cross =
        (std::int64_t{corner[1]->x} - corner[0]->x) * (std::int64_t{corner[2]->y} - corner[0]->y) -
        (std::int64_t{corner[2]->x} - corner[0]->x) * (std::int64_t{corner[1]->y} - corner[0]->y);
    if (cross <= 0) return;
    const auto [top, bottom] = std::minmax({corner[0]->y, corner[1]->y, corner[2]->y});
    const auto [left, right] = std::minmax({corner[0]->x, corner[1]->x, corner[2]->x});
    if (std::max(first_pixel(top), rows_.first) >= std::min(first_pixel(bottom), rows_.end)) return;
    if (std::max(first_pixel(left), 0) >= std::min(first_pixel(right), width_)) return;
    const std::array<const render::TexelPoint*, 3> texel{job.texels + index[0], job.texels + index[1],
                                                         job.texels + index[2]};
    const bool perspective = job.perspective && render::needs_perspective(corner.data(), texel.data());
    const auto triangle = static_cast<std::uint32_t>(triangles_.size());
    triangles_.push_back(
        {render::triangle_gradients(corner.data(), texel.data(), static_cast<double>(cross), perspective),
         model, 0});
    for (std::size_t side = 0; side < 3; ++side) add_edge(*corner[side], *corner[(side + 1) % 3], triangle);
  }

  // Corners are clockwise, so the triangle is to the right of a side that goes up.
  void add_edge(const ScreenVertex& from, const ScreenVertex& to, std::uint32_t triangle) {
    const bool goes_up = to.y < from.y;
    const ScreenVertex &upper = goes_up ? to : from, &lower = goes_up ? from : to;
    const std::int32_t first = std::max(first_pixel(upper.y), rows_.first);
    const std::int32_t end = std::min(first_pixel(lower.y), rows_.end);
    if (first >= end) return;
    ModelEdge edge{render::EdgeColumns(upper, lower, first), 0, end, triangle, goes_up};
    edge.column = edge.columns.next(width_);
    edges_.push_back(edge);
    first_rows_.push_back(first);
  }

  void sort_by_rows(base::Arena& arena) {
    const auto rows = static_cast<std::size_t>(rows_.end - rows_.first);
    begin_ = arena.allocate_filled<std::uint32_t>(rows + 2, 0);
    for (const std::int32_t row : first_rows_) ++begin_[static_cast<std::size_t>(row - rows_.first) + 2];
    for (std::size_t i = 2; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    order_ = arena.allocate<std::uint32_t>(edges_.size());
    for (std::size_t i = 0; i < edges_.size(); ++i)
      order_[begin_[static_cast<std::size_t>(first_rows_[i] - rows_.first) + 1]++] =
          static_cast<std::uint32_t>(i);
  }

  const render::RowRange rows_;
  const int width_;
  base::ArenaVector<ScannedTriangle> triangles_;
  base::ArenaVector<ModelEdge> edges_;
  base::ArenaVector<std::int32_t> first_rows_;  // by edge
  std::span<std::uint32_t> begin_, order_;      // by row of the band; numbers of edges
};

template <typename Active>
class BandScan {
 public:
  BandScan(BandEdges& io_edges, int width, base::Arena& arena)
      : band_(io_edges),
        triangles_(io_edges.triangles()),
        edges_(io_edges.edges()),
        width_(width),
        active_(edges_, arena),
        covering_(arena, 64),
        spans_(arena, 4096) {}

  void scan_row(int row) {
    active_.advance(row, width_);
    active_.add(band_.begin_in(row));
    int begin = 0;
    row_begin_ = spans_.size();
    for (std::uint32_t number = active_.first(); number != kNoEdge; number = active_.next(number)) {
      const ModelEdge& edge = edges_[number];
      if (edge.column > begin && !covering_.empty()) add_span(begin, edge.column, row);
      begin = edge.column;
      pass(edge);
    }
  }

  ModelScan result() const {
    return {spans_.view(), {.spans_sorted = spans_.size(), .comparisons = active_.steps() + comparisons_}};
  }

 private:
  void pass(const ModelEdge& edge) {
    std::int32_t& inside = triangles_[edge.triangle].inside;
    if (edge.is_leading && ++inside == 1) covering_.push_back(edge.triangle);
    if (!edge.is_leading && --inside == 0) {
      *std::find(covering_.begin(), covering_.end(), edge.triangle) = covering_.back();
      covering_.pop_back();
    }
  }

  // At equal depth, the later triangle is in front, as if each were drawn over those before it.
  void add_span(int begin, int end, int row) {
    std::uint32_t nearest = kNoEdge;
    double most = 0;
    for (const std::uint32_t triangle : covering_) {
      const render::TriangleGradients& own = triangles_[triangle].gradients;
      const double depth =
          own.depth.at_corner + own.depth.dx * (begin - own.corner_x) + own.depth.dy * (row - own.corner_y);
      if (nearest != kNoEdge && (depth < most || (depth == most && triangle < nearest))) continue;
      nearest = triangle;
      most = depth;
    }
    comparisons_ += covering_.size() - 1;
    if (spans_.size() > row_begin_ && last_ == nearest) {
      render::TriangleSpan& before = spans_.back().span;
      if (before.x + before.count == begin) {
        before.count += end - begin;
        return;
      }
    }
    last_ = nearest;
    const ScannedTriangle& triangle = triangles_[nearest];
    spans_.push_back({triangle.model, render::span_at(triangle.gradients, begin, row, end - begin)});
  }

  const BandEdges& band_;
  const std::span<ScannedTriangle> triangles_;
  const std::span<ModelEdge> edges_;
  const int width_;
  Active active_;
  base::ArenaVector<std::uint32_t> covering_;  // the current pixel
  base::ArenaVector<ModelSpan> spans_;
  std::size_t row_begin_ = 0;     // of the row's spans
  std::uint32_t last_ = kNoEdge;  // the triangle of the last span
  std::uint64_t comparisons_ = 0;
};

template <typename Active>
ModelScan scan(BandEdges& io_edges, render::RowRange rows, int width, base::Arena& arena) {
  BandScan<Active> scan(io_edges, width, arena);
  for (int row = rows.first; row < rows.end; ++row) scan.scan_row(row);
  return scan.result();
}

}  // namespace

ModelScan scan_models(std::span<const render::PreparedAlias> models, render::RowRange rows, int width,
                      bool uses_tree, base::Arena& arena) {
  BandEdges edges(models, rows, width, arena);
  return uses_tree ? scan<EdgeTree>(edges, rows, width, arena) : scan<EdgeList>(edges, rows, width, arena);
}

}  // namespace temblor::lab
