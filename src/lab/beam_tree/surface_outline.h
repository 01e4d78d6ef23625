// The outlines of surfaces as straight lines, for the beam tree: a surface is the pixels at the right of some
// lines and at the left of others. The lines are the surface's edges, made longer, and its first and last
// row.
//
//      left line \   / right line      Rounding may put the extension of an edge one pixel into the surface,
//                 \_/                  next to a corner. Then the surface is cut at this row into two pieces,
//      row line  -----                 so that the lines of each piece bound exactly its pixels.
#pragma once

#include <span>

#include "lab/beam_tree/pixel_region.h"
#include "lab/hidden_surfaces/surface_edges.h"

namespace temblor::lab {

// Not an edge: the border of the screen, or a line between two rows.
constexpr std::uint32_t kNoEdge = 0xffffffff;

// A line, and the side on which the surface lies.
struct Bound {
  Line line;
  std::uint32_t edge;
  bool is_inside_right;
};

// The groups `begin` to `end` - 1 of a tree.
struct GroupRange {
  int begin = 0, end = 0;
};

// The lines of edges and rows. Rows count from the first one of `rows`. Lines of edges are computed for the
// groups that were asked for, because most edges are short, and few leaves have many rows.
class LineTable {
 public:
  LineTable(const render::EdgeTable& table, render::RowRange rows, int width, base::Arena& arena);

  // Valid in `groups`, and in all groups that were asked for before. Always at the same address.
  Line edge_line(std::uint32_t edge, GroupRange groups);
  // Pixels above `row` are at its left, all others at its right.
  Line row_line(int row);
  int group_count() const { return groups_; }
  std::size_t bytes() const { return bytes_; }

 private:
  struct EdgeLine {
    GroupPixels* pixels = nullptr;
    GroupRange known;
  };
  void compute(const render::Edge& edge, GroupRange groups, GroupPixels* out_line) const;

  const render::EdgeTable& table_;
  render::RowRange rows_;
  double width_;
  int groups_;
  base::Arena& arena_;
  std::span<EdgeLine> edge_lines_;  // by edge
  std::span<Line> row_lines_;       // by row; null: not made yet
  std::size_t bytes_;
};

// The pieces of one surface at a time.
class SurfaceOutline {
 public:
  SurfaceOutline(const render::EdgeTable& table, const SurfaceEdges& edges, render::RowRange rows, int width,
                 base::Arena& arena);

  // Begins with the first piece of `surface`. Afterwards, next_piece() returns whether there is a piece with
  // pixels; bounds() and pixels() describe it until the next call.
  void begin(std::uint32_t surface);
  bool next_piece();

  std::span<const Bound> bounds() const { return bounds_.view(); }
  PixelRegion pixels() const { return pixels_; }
  LineTable& lines() { return lines_; }
  const LineTable& lines() const { return lines_; }

 private:
  // On one row: the pixels of the surface, and the edges that bound it (kNoEdge: the border of the screen).
  struct OutlineRow {
    std::int32_t first, end;
    std::uint32_t left_edge, right_edge;
    bool has_pixels() const { return first < end; }
  };

  void scan_edges(std::uint32_t surface);
  // Whether a line at the left or right of the surface has some of its pixels on the wrong side.
  static bool cuts_off(Line line, int row, const OutlineRow& outline, bool is_left);
  // Whether the lines of the piece keep all pixels of `row`, and whether the lines of that row keep all
  // pixels of the piece, which begins at `first_row`. If so, adds the lines.
  bool add_row(int first_row, int row);
  bool add_bound(int first_row, int row, std::uint32_t edge, bool is_leading);
  void make_pixels(int first_row, int end_row);

  const render::EdgeTable& table_;
  const SurfaceEdges& edges_;
  render::RowRange rows_;
  int width_;
  LineTable lines_;
  std::span<OutlineRow> outline_;  // by row, from the first one of rows_
  int next_row_ = 0, end_row_ = 0;
  base::ArenaVector<Bound> bounds_;
  std::span<RowGroup> groups_;
  PixelRegion pixels_;
};

}  // namespace temblor::lab
