// The scan for surfaces that may intersect: they are compared at every interval between two edges, and spans
// are split where surfaces cross. The others compare a surface once, where it begins (stack_scan.h).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "lab/hidden_surfaces/stack_scan.h"

namespace temblor::lab {

// Compares all surfaces that cover an interval between two edges, and splits the interval where they cross.
class IntersectingScan {
 public:
  IntersectingScan(const render::EdgeTable& table, std::span<const render::ScreenPlane> depths, int first_row,
                   int width, base::Arena& arena)
      : depths_(depths),
        edges_(table, first_row, arena),
        passed_(arena.allocate_filled<Passed>(depths.size(), {-1, 0})),
        covering_(arena, 64),
        spans_(table, width, arena) {}

  void scan_row(int row) {
    edges_.advance_to(row);
    const std::span<const double> x = edges_.x();
    const std::size_t count = count_on_screen(x, spans_.width());
    covering_.clear();
    spans_.begin_row(row);
    int begin = 0;
    for (std::size_t place = 0; place < count; ++place) {
      const int end = render::first_pixel(x[place]);
      if (end > begin) add_interval(begin, end, row);
      begin = std::max(begin, end);
      pass(edges_.records()[place], row);
    }
    add_interval(begin, spans_.width(), row);
  }
  std::span<const render::DrawSpan> spans() const { return spans_.all(); }
  std::uint64_t comparisons() const { return comparisons_; }

 private:
  struct Passed {
    std::int32_t row, inside;
  };

  std::int32_t& inside(render::SurfaceIndex surface, int row) {
    Passed& found = passed_[base::to_size(surface)];
    if (found.row != row) found = {row, 0};
    return found.inside;
  }

  void pass(const render::EdgeRecord& record, int row) {
    if (record.trailing != render::kBackground && --inside(record.trailing, row) == 0) {
      *std::find(covering_.begin(), covering_.end(), record.trailing) = covering_.back();
      covering_.pop_back();
    }
    if (record.leading != render::kBackground && ++inside(record.leading, row) == 1)
      covering_.push_back(record.leading);
  }

  // Depths are compared at pixel centers. Equal depths are decided by the gradient, and equal gradients by
  // the surface's number.
  bool is_nearer(render::SurfaceIndex a, render::SurfaceIndex b, int x, int row) {
    ++comparisons_;
    const render::ScreenPlane &plane = depths_[base::to_size(a)], &other = depths_[base::to_size(b)];
    const double depth = plane.at(x, row), other_depth = other.at(x, row);
    if (depth != other_depth) return depth > other_depth;
    return plane.dx != other.dx ? plane.dx > other.dx : a < b;
  }

  void add_interval(int begin, int end, int row) {
    while (begin < end) {
      render::SurfaceIndex front = render::kBackground;
      for (const render::SurfaceIndex surface : covering_)
        if (front == render::kBackground || is_nearer(surface, front, begin, row)) front = surface;
      int next = end;
      const render::ScreenPlane& plane = depths_[base::to_size(front)];
      for (const render::SurfaceIndex surface : covering_)
        next = std::min(next, find_crossing(plane, surface, {begin, next}, row));
      spans_.add(front, next);
      begin = next;
    }
  }

  // The first pixel after range.first at which the surface is nearer than `plane`; range.end if there is
  // none.
  struct Range {
    int first, end;
  };
  int find_crossing(const render::ScreenPlane& plane, render::SurfaceIndex surface, Range range,
                    int row) const {
    const render::ScreenPlane& other = depths_[base::to_size(surface)];
    const double gain = other.dx - plane.dx;
    if (!(gain > 0)) return range.end;
    const double behind = plane.at(range.first, row) - other.at(range.first, row);
    const double pixels = std::floor(behind / gain) + 1;
    return pixels < range.end - range.first ? range.first + std::max(1, static_cast<int>(pixels)) : range.end;
  }

  std::span<const render::ScreenPlane> depths_;
  render::ActiveEdges edges_;
  std::span<Passed> passed_;                          // by surface
  base::ArenaVector<render::SurfaceIndex> covering_;  // the current pixel
  RowSpans spans_;
  std::uint64_t comparisons_ = 0;
};

}  // namespace temblor::lab
