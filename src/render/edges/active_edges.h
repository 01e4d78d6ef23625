// The active edge list: the edges that cross the row being scanned, from left to right.
//
// Stock Quake keeps a linked list. Here each field has an array of its own, so that the crossings of all
// edges with the next row are computed with SIMD; the list is then repaired where the order has changed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/arena.h"
#include "render/edges/edge_table.h"

namespace temblor::render {

// The fields of an active edge that do not affect where it crosses a row.
struct EdgeRecord {
  SurfaceIndex leading, trailing;
  std::uint32_t number;
  std::int32_t last_row;
};

class ActiveEdges {
 public:
  // Ready to be advanced to `first_row`. The table and the arena must outlive the object.
  ActiveEdges(const EdgeTable& table, int first_row, base::Arena& arena);

  // Moves to `row`: the first row, or the row below the previous one. Returns whether the same edges cross it
  // in the same order as the row above; false for the first row.
  bool advance_to(int row);

  std::size_t size() const { return x_.size(); }
  // By position: where the edge crosses the row; 0 if that is left of the screen.
  std::span<const double> x() const { return x_.view(); }
  std::span<const EdgeRecord> records() const { return records_.view(); }

 private:
  // An edge that begins on this row and is not in the list yet.
  struct NewEdge {
    double x;
    std::uint32_t number;
  };

  void add_new_edge(std::uint32_t number, int row);
  void remove_ended(int row);
  void compute_crossings(int row);
  bool restore_order();
  void move_left(std::size_t from);
  void merge_new_edges();
  void set(std::size_t place, const NewEdge& new_edge);
  void copy(std::size_t from, std::size_t to) {
    x_[to] = x_[from];
    x_first_[to] = x_first_[from];
    step_[to] = step_[from];
    first_row_[to] = first_row_[from];
    records_[to] = records_[from];
  }
  void resize(std::size_t count);

  const EdgeTable& table_;
  // By position. Separate arrays, because computing the crossings reads only the numbers.
  base::ArenaVector<double> x_, x_first_, step_, first_row_;
  base::ArenaVector<EdgeRecord> records_;
  // The smallest last_row in the list: rows up to it need no removal.
  std::int32_t earliest_end_;
  base::ArenaVector<NewEdge> new_edges_;
  bool is_first_row_ = true;
};

}  // namespace temblor::render
