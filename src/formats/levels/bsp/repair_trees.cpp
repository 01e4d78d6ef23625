#include "formats/levels/bsp/repair_trees.h"

#include <algorithm>
#include <vector>

#include "formats/levels/bsp_validate.h"

namespace temblor::formats::bsp_file {
namespace {

constexpr std::int32_t kOpenContents = -1;
constexpr std::int32_t kLeafZero = ~0;

struct Branch {
  std::size_t node;
  std::uint32_t depth;
};

// Walks one tree, and marks the nodes that it reaches.
std::size_t cut_branches(std::size_t head, std::vector<BspNode>& io_nodes, std::vector<bool>& io_reached) {
  std::size_t changed = 0;
  std::vector<Branch> to_visit{{head, 1}};
  io_reached[head] = true;
  while (!to_visit.empty()) {
    const Branch branch = to_visit.back();
    to_visit.pop_back();
    for (std::int32_t& child : io_nodes[branch.node].children) {
      if (child < 0) continue;
      const auto node = static_cast<std::size_t>(child);
      if (io_reached[node] || branch.depth == kBspMaxTreeDepth) {
        child = kLeafZero;
        ++changed;
        continue;
      }
      io_reached[node] = true;
      to_visit.push_back({node, branch.depth + 1});
    }
  }
  return changed;
}

}  // namespace

std::int32_t find_empty_leaf(const Bsp& bsp) {
  const auto found = std::ranges::find(bsp.leaves, kOpenContents, &BspLeaf::contents);
  return found == bsp.leaves.end() ? kLeafZero : ~static_cast<std::int32_t>(found - bsp.leaves.begin());
}

std::size_t repair_node_trees(Bsp& io_bsp) {
  std::size_t changed = 0;
  std::vector<bool> reached(io_bsp.nodes.size()), is_walked_head(io_bsp.nodes.size());
  for (BspModel& model : io_bsp.models) {
    const auto node = static_cast<std::size_t>(model.head_nodes[0]);
    if (model.head_nodes[0] < 0 || node >= io_bsp.nodes.size() || is_walked_head[node]) continue;
    if (reached[node]) {
      model.head_nodes[0] = find_empty_leaf(io_bsp);
      ++changed;
      continue;
    }
    is_walked_head[node] = true;
    changed += cut_branches(node, io_bsp.nodes, reached);
  }
  return changed;
}

}  // namespace temblor::formats::bsp_file
