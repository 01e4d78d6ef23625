// Hot loops. From one row to the next, most edges neither begin nor end, and few change places. So for every
// row the crossings are computed and the order is checked; only edges that are out of order are moved.
#include "render/edges/active_edges.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "render/edges/edge_crossing.h"

namespace temblor::render {

namespace {

constexpr std::size_t kUsualCount = 512;
constexpr std::int32_t kNever = std::numeric_limits<std::int32_t>::max();

// A total order, so that it does not matter in which row scanning began. Among edges at the same place, the
// one with the larger number comes first: it usually belongs to the farther surface, and a nearer surface
// then goes on top of the stack.
bool before(double x, std::uint32_t number, double other_x, std::uint32_t other_number) {
  return x < other_x || (x == other_x && number > other_number);
}

}  // namespace

ActiveEdges::ActiveEdges(const EdgeTable& table, int first_row, base::Arena& arena)
    : table_(table),
      x_(arena, kUsualCount),
      x_first_(arena, kUsualCount),
      step_(arena, kUsualCount),
      first_row_(arena, kUsualCount),
      records_(arena, kUsualCount),
      earliest_end_(kNever),
      new_edges_(arena, kUsualCount) {
  // Edges that began above the band.
  const std::span<const Edge> edges = table.edges;
  for (const std::uint32_t number : table.order.first(table.row_begin[static_cast<std::size_t>(first_row)]))
    if (edges[number].last_row >= first_row) add_new_edge(number, first_row);
}

bool ActiveEdges::advance_to(int row) {
  bool same = !std::exchange(is_first_row_, false);
  if (row > earliest_end_) {
    remove_ended(row);
    same = false;
  }
  compute_crossings(row);
  if (!restore_order()) same = false;
  const std::size_t row_number = static_cast<std::size_t>(row);
  for (std::uint32_t i = table_.row_begin[row_number]; i < table_.row_begin[row_number + 1]; ++i)
    add_new_edge(table_.order[i], row);
  if (new_edges_.empty()) return same;
  merge_new_edges();
  return false;
}

void ActiveEdges::add_new_edge(std::uint32_t number, int row) {
  const Edge& edge = table_.edges[number];
  new_edges_.push_back({crossing(edge.x_first, edge.step, row - edge.first_row), number});
}

// Compacts the arrays in place. Called only if some edge has ended, so the first loop always stops.
void ActiveEdges::remove_ended(int row) {
  const std::size_t count = size();
  const EdgeRecord* const records = records_.data();
  std::int32_t earliest_end = kNever;
  std::size_t kept = 0;  // up to the first that has ended: there is one
  for (; records[kept].last_row >= row; ++kept) earliest_end = std::min(earliest_end, records[kept].last_row);
  for (std::size_t i = kept + 1; i < count; ++i) {
    if (records[i].last_row < row) continue;
    earliest_end = std::min(earliest_end, records[i].last_row);
    copy(i, kept++);
  }
  earliest_end_ = earliest_end;
  resize(kept);
}

void ActiveEdges::compute_crossings(int row) {
  const double row_number = row;
  const std::size_t count = size();
  double* const x = x_.data();
  const double* const x_first = x_first_.data();
  const double* const step = step_.data();
  const double* const first_row = first_row_.data();
  for (std::size_t i = 0; i < count; ++i) x[i] = crossing(x_first[i], step[i], row_number - first_row[i]);
}

// An insertion sort, which is fast on nearly sorted lists. Returns whether the list was in order already.
bool ActiveEdges::restore_order() {
  const std::size_t count = size();
  const double* const x = x_.data();
  bool was_in_order = true;
  for (std::size_t i = 1; i < count; ++i) {
    if (x[i - 1] < x[i]) [[likely]]
      continue;
    if (before(x[i - 1], records_[i - 1].number, x[i], records_[i].number)) continue;
    move_left(i);
    was_in_order = false;
  }
  return was_in_order;
}

void ActiveEdges::move_left(std::size_t from) {
  const NewEdge moved{x_[from], records_[from].number};
  std::size_t place = from;
  for (; place > 0 && before(moved.x, moved.number, x_[place - 1], records_[place - 1].number); --place)
    copy(place - 1, place);
  set(place, moved);
}

// Merges from the right, so that each edge moves at most once.
void ActiveEdges::merge_new_edges() {
  std::sort(new_edges_.begin(), new_edges_.end(),
            [](const NewEdge& a, const NewEdge& b) { return before(a.x, a.number, b.x, b.number); });
  std::size_t old = size();
  std::size_t place = old + new_edges_.size();
  resize(place);
  for (; !new_edges_.empty(); new_edges_.pop_back()) {
    const NewEdge new_edge = new_edges_.back();
    while (old > 0 && before(new_edge.x, new_edge.number, x_[old - 1], records_[old - 1].number))
      copy(--old, --place);
    set(--place, new_edge);
    earliest_end_ = std::min(earliest_end_, records_[place].last_row);
  }
}

void ActiveEdges::set(std::size_t place, const NewEdge& new_edge) {
  const Edge& edge = table_.edges[new_edge.number];
  x_[place] = new_edge.x;
  x_first_[place] = edge.x_first;
  step_[place] = edge.step;
  first_row_[place] = edge.first_row;
  records_[place] = {edge.leading, edge.trailing, new_edge.number, edge.last_row};
}

void ActiveEdges::resize(std::size_t count) {
  x_.resize(count);
  x_first_.resize(count);
  step_.resize(count);
  first_row_.resize(count);
  records_.resize(count);
}

}  // namespace temblor::render
