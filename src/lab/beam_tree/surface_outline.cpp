#include "lab/beam_tree/surface_outline.h"

#include <algorithm>

#include "render/edges/edge_crossing.h"

namespace temblor::lab {

namespace {

constexpr std::int32_t kNoRightEdge = -1;

// The groups that contain rows `first` to `end` - 1.
GroupRange find_groups(int first, int end) {
  return {first / kGroupRows, (end + kGroupRows - 1) / kGroupRows};
}

int pixel_at(Line line, int row) {
  return line[row / kGroupRows][static_cast<std::size_t>(row % kGroupRows)];
}

}  // namespace

LineTable::LineTable(const render::EdgeTable& table, render::RowRange rows, int width, base::Arena& arena)
    : table_(table),
      rows_(rows),
      width_(width),
      groups_((rows.end - rows.first + kGroupRows - 1) / kGroupRows),
      arena_(arena),
      edge_lines_(arena.allocate_filled<EdgeLine>(table.edges.size(), {})),
      row_lines_(arena.allocate_filled<Line>(static_cast<std::size_t>(rows.end - rows.first) + 1, nullptr)),
      bytes_(edge_lines_.size_bytes() + row_lines_.size_bytes()) {}

Line LineTable::edge_line(std::uint32_t number, GroupRange groups) {
  EdgeLine& line = edge_lines_[number];
  const render::Edge& edge = table_.edges[number];
  if (line.pixels == nullptr) {
    const std::span<GroupPixels> pixels = arena_.allocate<GroupPixels>(static_cast<std::size_t>(groups_));
    bytes_ += pixels.size_bytes();
    line = {pixels.data(), {groups.begin, groups.begin}};
  }
  if (groups.begin < line.known.begin) {
    compute(edge, {groups.begin, line.known.begin}, line.pixels);
    line.known.begin = groups.begin;
  }
  if (groups.end > line.known.end) {
    compute(edge, {line.known.end, groups.end}, line.pixels);
    line.known.end = groups.end;
  }
  return line.pixels;
}

void LineTable::compute(const render::Edge& edge, GroupRange groups, GroupPixels* out_line) const {
  int row = rows_.first + groups.begin * kGroupRows - edge.first_row;
  for (int group = groups.begin; group < groups.end; ++group) {
    for (std::int16_t& pixel : out_line[group]) {
      const double x = std::min(render::crossing(edge.x_first, edge.step, row++), width_);
      pixel = static_cast<std::int16_t>(render::first_pixel(x));
    }
  }
}

Line LineTable::row_line(int row) {
  Line& known = row_lines_[static_cast<std::size_t>(row)];
  if (known != nullptr) return known;
  const std::span<GroupPixels> line = arena_.allocate<GroupPixels>(static_cast<std::size_t>(groups_));
  bytes_ += line.size_bytes();
  int here = 0;
  for (GroupPixels& group : line)
    for (std::int16_t& pixel : group) pixel = here++ < row ? kNoFirst : std::int16_t{0};
  return known = line.data();
}

SurfaceOutline::SurfaceOutline(const render::EdgeTable& table, const SurfaceEdges& edges,
                               render::RowRange rows, int width, base::Arena& arena)
    : table_(table),
      edges_(edges),
      rows_(rows),
      width_(width),
      lines_(table, rows, width, arena),
      outline_(arena.allocate<OutlineRow>(static_cast<std::size_t>(rows.end - rows.first))),
      bounds_(arena),
      groups_(arena.allocate<RowGroup>(static_cast<std::size_t>(lines_.group_count()))) {}

void SurfaceOutline::begin(std::uint32_t surface) {
  const render::RowRange rows = edges_.rows[surface];
  next_row_ = std::max(rows.first, rows_.first) - rows_.first;
  end_row_ = std::min(rows.end, rows_.end) - rows_.first;
  if (next_row_ < end_row_) scan_edges(surface);
}

void SurfaceOutline::scan_edges(std::uint32_t surface) {
  std::fill(outline_.begin() + next_row_, outline_.begin() + end_row_,
            OutlineRow{width_, kNoRightEdge, kNoEdge, kNoEdge});
  for (const EdgeSide side : edges_.surface_sides(surface)) {
    const render::Edge& edge = table_.edges[side.edge];
    const int first = std::max(edge.first_row - rows_.first, next_row_);
    const int end = std::min(edge.last_row + 1 - rows_.first, end_row_);
    if (first >= end) continue;
    const Line line = lines_.edge_line(side.edge, find_groups(first, end));
    for (int row = first; row < end; ++row) {
      OutlineRow& here = outline_[static_cast<std::size_t>(row)];
      const int pixel = pixel_at(line, row);
      if (side.is_leading && pixel < here.first) {
        here.first = pixel;
        here.left_edge = side.edge;
      } else if (!side.is_leading && pixel > here.end) {
        here.end = pixel;
        here.right_edge = side.edge;
      }
    }
  }
  for (int row = next_row_; row < end_row_; ++row) {
    OutlineRow& here = outline_[static_cast<std::size_t>(row)];
    if (here.right_edge == kNoEdge) here.end = width_;
  }
}

bool SurfaceOutline::next_piece() {
  const auto has_pixels = [&](int row) { return outline_[static_cast<std::size_t>(row)].has_pixels(); };
  while (next_row_ < end_row_ && !has_pixels(next_row_)) ++next_row_;
  if (next_row_ >= end_row_) return false;
  const int first_row = next_row_;
  bounds_.clear();
  while (next_row_ < end_row_ && add_row(first_row, next_row_)) ++next_row_;
  // Rows last: the edges often exclude everything above and below.
  if (first_row > 0) bounds_.push_back({lines_.row_line(first_row), kNoEdge, true});
  if (next_row_ < rows_.end - rows_.first) bounds_.push_back({lines_.row_line(next_row_), kNoEdge, false});
  make_pixels(first_row, next_row_);
  return true;
}

bool SurfaceOutline::cuts_off(Line line, int row, const OutlineRow& outline, bool is_left) {
  const int pixel = pixel_at(line, row);
  return is_left ? pixel > outline.first : pixel < outline.end;
}

bool SurfaceOutline::add_row(int first_row, int row) {
  const OutlineRow& here = outline_[static_cast<std::size_t>(row)];
  // A row without pixels between two edges is excluded by these edges, whatever the other lines do.
  if (!here.has_pixels() && here.left_edge == kNoEdge) return false;
  for (const Bound& bound : bounds_)
    if (here.has_pixels() && cuts_off(bound.line, row, here, bound.is_inside_right)) return false;
  const std::size_t bounds = bounds_.size();
  if (add_bound(first_row, row, here.left_edge, true) && add_bound(first_row, row, here.right_edge, false))
    return true;
  bounds_.shrink(bounds);
  return false;
}

bool SurfaceOutline::add_bound(int first_row, int row, std::uint32_t edge, bool is_leading) {
  if (edge == kNoEdge) return true;
  if (row > first_row) {
    const OutlineRow& above = outline_[static_cast<std::size_t>(row - 1)];
    if ((is_leading ? above.left_edge : above.right_edge) == edge) return true;
  }
  const Line line = lines_.edge_line(edge, find_groups(first_row, end_row_));
  for (int i = first_row; i < row; ++i) {
    const OutlineRow& other = outline_[static_cast<std::size_t>(i)];
    if (other.has_pixels() && cuts_off(line, i, other, is_leading)) return false;
  }
  bounds_.push_back({line, edge, is_leading});
  return true;
}

void SurfaceOutline::make_pixels(int first_row, int end_row) {
  const GroupRange range = find_groups(first_row, end_row);
  pixels_ = {range.begin, range.end, groups_.data()};
  const std::size_t count = static_cast<std::size_t>(pixels_.size());
  std::ranges::fill(groups_.first(count), kNoPixels);
  for (int row = first_row; row < end_row; ++row) {
    const OutlineRow& here = outline_[static_cast<std::size_t>(row)];
    if (!here.has_pixels()) continue;
    RowGroup& group = pixels_.groups[row / kGroupRows - pixels_.begin];
    const auto lane = static_cast<std::size_t>(row % kGroupRows);
    group.first[lane] = static_cast<std::int16_t>(here.first);
    group.end[lane] = static_cast<std::int16_t>(here.end);
  }
}

}  // namespace temblor::lab
