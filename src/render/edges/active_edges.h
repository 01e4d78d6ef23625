// The edges that cross the row being scanned, from left to right.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/arena.h"
#include "render/edges/edge_table.h"

namespace temblor::render {

// What of an active edge does not bear on where it crosses a row.
struct EdgeMarks {
  SurfaceIndex leading, trailing;
  std::uint32_t number;
  std::int32_t last_row;
};

class ActiveEdges {
 public:
  // Ready for `first_row` to be advanced to. The table and the arena must outlive it.
  ActiveEdges(const EdgeTable& table, int first_row, base::Arena& arena);

  // Moves on to `row`: the first one, or the next below the last. Returns whether the same edges cross it in
  // the same order as the row above; never true of the first.
  bool advance_to(int row);

  std::size_t size() const { return x_.size(); }
  // By place: where an edge crosses the row; 0 when left of the screen.
  std::span<const double> x() const { return x_.view(); }
  std::span<const EdgeMarks> marks() const { return marks_.view(); }

 private:
  // An edge that is still to be put in its place.
  struct Newcomer {
    double x;
    std::uint32_t number;
  };

  void announce(std::uint32_t number, int row);
  void drop_ended(int row);
  void compute_crossings(int row);
  bool put_in_order();
  void move_left(std::size_t from);
  void merge_newcomers();
  void set(std::size_t place, const Newcomer& newcomer);
  void copy(std::size_t from, std::size_t to) {
    x_[to] = x_[from];
    x_first_[to] = x_first_[from];
    step_[to] = step_[from];
    first_row_[to] = first_row_[from];
    marks_[to] = marks_[from];
  }
  void resize(std::size_t count);

  const EdgeTable& table_;
  // By place. Apart from one another, since computing where edges cross takes the numbers alone.
  base::ArenaVector<double> x_, x_first_, step_, first_row_;
  base::ArenaVector<EdgeMarks> marks_;
  std::int32_t earliest_end_;  // the smallest last row
  base::ArenaVector<Newcomer> newcomers_;
  bool is_first_row_ = true;
};

}  // namespace temblor::render
