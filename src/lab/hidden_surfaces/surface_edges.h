// The edges of every opaque surface, for techniques that scan one surface at a time. (The engine's table
// stores an edge between two neighbors once.)
#pragma once

#include <cstdint>
#include <span>

#include "render/edges/edge_table.h"

namespace temblor::lab {

// One side of an edge: of the surface that begins there, or of the one that ends there.
struct EdgeSide {
  std::uint32_t edge;
  bool is_leading;
};

struct SurfaceEdges {
  std::span<const std::uint32_t> begin;  // by SurfaceIndex, into `sides`; one more at the end
  std::span<const EdgeSide> sides;
  std::span<const render::RowRange> rows;  // by SurfaceIndex: those that its edges cross

  std::span<const EdgeSide> surface_sides(std::size_t surface) const {
    return sides.subspan(begin[surface], begin[surface + 1] - begin[surface]);
  }
};

// Results live in the frame's arena.
SurfaceEdges group_edges(const render::FrameContext& context, const render::EdgeTable& table);

// The pixels `first` to `end` - 1 of a row.
struct RowSpan {
  std::int32_t first, end;
};

// Scans one surface as if it were alone. Faces are convex, so on every row it covers one span.
class SurfaceScan {
 public:
  // For surfaces in `rows`.
  SurfaceScan(const render::EdgeTable& table, const SurfaceEdges& edges, render::RowRange rows, int width,
              base::Arena& arena);

  // Returns the rows of the surface within the band; span_at() is then valid for these. Empty spans have
  // first >= end.
  render::RowRange scan(std::size_t surface);
  RowSpan span_at(int row) const { return spans_[static_cast<std::size_t>(row - rows_.first)]; }

 private:
  const render::EdgeTable& table_;
  const SurfaceEdges& edges_;
  render::RowRange rows_;
  int width_;
  std::span<RowSpan> spans_;  // by row of the band
};

}  // namespace temblor::lab
