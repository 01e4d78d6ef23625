// Method: split at the plane on which the largest share of the cross-section changes its contents, which
// usually is a wall or a floor. Among similar planes prefer the middle one. Stop when a range has uniform
// contents.
#include "artgen/level/grid_tree.h"

#include <algorithm>
#include <optional>

#include "base/check.h"

namespace temblor::artgen {
namespace {

// How much a split in the middle counts, compared with the share of changes.
constexpr double kBalanceWeight = 0.3;

// A line of the grid that splits a range.
struct Split {
  std::size_t axis, line;
};

// The share of the range's cross-section at the plane on which the contents of its two sides differ.
double measure_change(const CellGrid& grid, const CellRange& range, std::size_t axis, std::size_t line) {
  const std::size_t u = (axis + 1) % 3;
  const std::size_t v = (axis + 2) % 3;
  std::size_t changing = 0;
  CellPosition above{}, below{};
  above[axis] = line;
  below[axis] = line - 1;
  for (std::size_t i = range.first[u]; i < range.last[u]; ++i) {
    for (std::size_t j = range.first[v]; j < range.last[v]; ++j) {
      above[u] = below[u] = i;
      above[v] = below[v] = j;
      if (grid.at(above).contents != grid.at(below).contents) ++changing;
    }
  }
  const std::size_t squares = (range.last[u] - range.first[u]) * (range.last[v] - range.first[v]);
  return static_cast<double>(changing) / static_cast<double>(squares);
}

// Returns nothing if no plane separates different contents, that is, if the range is uniform.
std::optional<Split> choose_split(const CellGrid& grid, const CellRange& range) {
  std::optional<Split> best;
  double best_score = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t first = range.first[axis];
    const std::size_t last = range.last[axis];
    for (std::size_t line = first + 1; line < last; ++line) {
      const double share = measure_change(grid, range, axis, line);
      if (share == 0) continue;
      const auto smaller_side = static_cast<double>(std::min(line - first, last - line));
      const double score = share + kBalanceWeight * smaller_side / static_cast<double>(last - first);
      if (!best || score > best_score) {
        best = Split{axis, line};
        best_score = score;
      }
    }
  }
  return best;
}

}  // namespace

GridTree build_grid_tree(const CellGrid& grid) {
  // A range that still needs a node or a leaf, and the child slot that will refer to it.
  struct Pending {
    CellRange range;
    std::size_t parent;
    std::size_t side;
  };
  GridTree tree;
  std::vector<Pending> pending = {{grid.all(), 0, 0}};
  bool is_root = true;
  while (!pending.empty()) {
    const Pending next = pending.back();
    pending.pop_back();
    const std::optional<Split> split = choose_split(grid, next.range);
    CHECK(split || !is_root, "a grid of one contents");
    const auto child =
        split ? static_cast<std::int32_t>(tree.nodes.size()) : ~static_cast<std::int32_t>(tree.leaves.size());
    if (!is_root) tree.nodes[next.parent].children[next.side] = child;
    is_root = false;
    if (!split) {
      tree.leaves.push_back({grid.at(next.range.first).contents, next.range});
      continue;
    }
    CellRange above = next.range;
    CellRange below = next.range;
    above.first[split->axis] = below.last[split->axis] = split->line;
    // The upper side is processed first, so that nodes and leaves are stored in depth-first order.
    pending.push_back({below, tree.nodes.size(), 1});
    pending.push_back({above, tree.nodes.size(), 0});
    tree.nodes.push_back({split->axis, split->line, next.range, {}});
  }
  return tree;
}

}  // namespace temblor::artgen
