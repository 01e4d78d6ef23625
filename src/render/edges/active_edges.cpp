// Hot loops. From one row to the next most edges neither begin nor end, and few change places: for every row
// it is computed where the edges cross it and checked whether they are still in order; only what has changed
// is moved.
#include "render/edges/active_edges.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "render/edges/edge_crossing.h"

namespace temblor::render {

namespace {

constexpr std::size_t kUsualCount = 512;
constexpr std::int32_t kNever = std::numeric_limits<std::int32_t>::max();

// A total order, so that it does not matter where a band began. Of edges in one place the last made comes
// first: it is most often the farthest surface's, and what begins nearer goes on top of the stack.
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
      marks_(arena, kUsualCount),
      earliest_end_(kNever),
      newcomers_(arena, kUsualCount) {
  // Edges that began above the band.
  const std::span<const Edge> edges = table.edges;
  for (const std::uint32_t number : table.order.first(table.row_begin[static_cast<std::size_t>(first_row)]))
    if (edges[number].last_row >= first_row) announce(number, first_row);
}

bool ActiveEdges::advance_to(int row) {
  bool same = !std::exchange(is_first_row_, false);
  if (row > earliest_end_) {
    drop_ended(row);
    same = false;
  }
  compute_crossings(row);
  if (!put_in_order()) same = false;
  const std::size_t row_number = static_cast<std::size_t>(row);
  for (std::uint32_t i = table_.row_begin[row_number]; i < table_.row_begin[row_number + 1]; ++i)
    announce(table_.order[i], row);
  if (newcomers_.empty()) return same;
  merge_newcomers();
  return false;
}

void ActiveEdges::announce(std::uint32_t number, int row) {
  const Edge& edge = table_.edges[number];
  newcomers_.push_back({crossing(edge.x_first, edge.step, row - edge.first_row), number});
}

void ActiveEdges::drop_ended(int row) {
  const std::size_t count = size();
  const EdgeMarks* const marks = marks_.data();
  std::int32_t earliest_end = kNever;
  std::size_t kept = 0;  // up to the first that has ended: there is one
  for (; marks[kept].last_row >= row; ++kept) earliest_end = std::min(earliest_end, marks[kept].last_row);
  for (std::size_t i = kept + 1; i < count; ++i) {
    if (marks[i].last_row < row) continue;
    earliest_end = std::min(earliest_end, marks[i].last_row);
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

// Insertion sort. Returns whether there was nothing to do.
bool ActiveEdges::put_in_order() {
  const std::size_t count = size();
  const double* const x = x_.data();
  bool was_in_order = true;
  for (std::size_t i = 1; i < count; ++i) {
    if (x[i - 1] < x[i]) [[likely]]
      continue;
    if (before(x[i - 1], marks_[i - 1].number, x[i], marks_[i].number)) continue;
    move_left(i);
    was_in_order = false;
  }
  return was_in_order;
}

void ActiveEdges::move_left(std::size_t from) {
  const Newcomer moved{x_[from], marks_[from].number};
  std::size_t place = from;
  for (; place > 0 && before(moved.x, moved.number, x_[place - 1], marks_[place - 1].number); --place)
    copy(place - 1, place);
  set(place, moved);
}

// From the right, so that each edge moves once.
void ActiveEdges::merge_newcomers() {
  std::sort(newcomers_.begin(), newcomers_.end(),
            [](const Newcomer& a, const Newcomer& b) { return before(a.x, a.number, b.x, b.number); });
  std::size_t old = size();
  std::size_t place = old + newcomers_.size();
  resize(place);
  for (; !newcomers_.empty(); newcomers_.pop_back()) {
    const Newcomer newcomer = newcomers_.back();
    while (old > 0 && before(newcomer.x, newcomer.number, x_[old - 1], marks_[old - 1].number))
      copy(--old, --place);
    set(--place, newcomer);
    earliest_end_ = std::min(earliest_end_, marks_[place].last_row);
  }
}

void ActiveEdges::set(std::size_t place, const Newcomer& newcomer) {
  const Edge& edge = table_.edges[newcomer.number];
  x_[place] = newcomer.x;
  x_first_[place] = edge.x_first;
  step_[place] = edge.step;
  first_row_[place] = edge.first_row;
  marks_[place] = {edge.leading, edge.trailing, newcomer.number, edge.last_row};
}

void ActiveEdges::resize(std::size_t count) {
  x_.resize(count);
  x_first_.resize(count);
  step_.resize(count);
  first_row_.resize(count);
  marks_.resize(count);
}

}  // namespace temblor::render
