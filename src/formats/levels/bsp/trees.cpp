#include "formats/levels/bsp/trees.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace temblor::formats::bsp_file {
namespace {

BspFault make_depth_fault(BspLump lump, std::size_t node) {
  return {lump, node, fmt::format("the tree is deeper than {} nodes", kBspMaxTreeDepth)};
}

struct Visit {
  std::int32_t node;
  std::uint32_t depth;
};

// Walks one tree of hull 0, and marks the nodes that it reaches.
std::optional<BspFault> check_node_tree(const Bsp& bsp, std::int32_t head, std::vector<bool>& io_reached) {
  std::vector<Visit> to_visit{{head, 1}};
  while (!to_visit.empty()) {
    const Visit visit = to_visit.back();
    to_visit.pop_back();
    if (visit.node < 0) continue;
    const auto node = static_cast<std::size_t>(visit.node);
    if (io_reached[node]) return BspFault{BspLump::kNodes, node, "it is reached twice"};
    if (visit.depth > kBspMaxTreeDepth) return make_depth_fault(BspLump::kNodes, node);
    io_reached[node] = true;
    for (const std::int32_t child : bsp.nodes[node].children) to_visit.push_back({child, visit.depth + 1});
  }
  return std::nullopt;
}

// Measures clipnode trees. Compilers let them share parts, so each clipnode is visited only once for all
// heads together; its height is remembered. Depth first with an explicit stack, the path from the head: a
// child that is on the path closes a cycle.
class ClipnodeWalk {
 public:
  explicit ClipnodeWalk(const std::vector<BspClipnode>& clipnodes)
      : clipnodes_(clipnodes), height_(clipnodes.size(), kUnknown) {}

  std::optional<BspFault> check(std::int32_t head) {
    if (auto fault = enter(head)) return fault;
    while (!path_.empty()) {
      Step& step = path_.back();
      const BspClipnode& clipnode = clipnodes_[step.clipnode];
      if (step.next_child < clipnode.children.size()) {
        if (auto fault = enter(clipnode.children[step.next_child++])) return fault;
      } else if (auto fault = leave()) {
        return fault;
      }
    }
    return std::nullopt;
  }

 private:
  static constexpr std::uint32_t kUnknown = 0;
  static constexpr std::uint32_t kOnPath = ~0u;
  struct Step {
    std::size_t clipnode;
    std::size_t next_child;
  };

  std::optional<BspFault> enter(std::int32_t child) {
    if (child < 0) return std::nullopt;
    const auto clipnode = static_cast<std::size_t>(child);
    if (height_[clipnode] == kOnPath)
      return BspFault{BspLump::kClipnodes, clipnode, "a path from it comes back to it"};
    if (height_[clipnode] != kUnknown) return std::nullopt;
    if (path_.size() >= kBspMaxTreeDepth) return make_depth_fault(BspLump::kClipnodes, clipnode);
    height_[clipnode] = kOnPath;
    path_.push_back({clipnode, 0});
    return std::nullopt;
  }

  std::optional<BspFault> leave() {
    const std::size_t clipnode = path_.back().clipnode;
    path_.pop_back();
    std::uint32_t height = 1;
    for (const std::int32_t child : clipnodes_[clipnode].children)
      if (child >= 0) height = std::max(height, height_[static_cast<std::size_t>(child)] + 1);
    if (height > kBspMaxTreeDepth) return make_depth_fault(BspLump::kClipnodes, clipnode);
    height_[clipnode] = height;
    return std::nullopt;
  }

  const std::vector<BspClipnode>& clipnodes_;
  // Nodes on the longest path down from each clipnode; or kUnknown, or kOnPath while it is visited.
  std::vector<std::uint32_t> height_;
  std::vector<Step> path_;
};

}  // namespace

std::optional<BspFault> check_node_trees(const Bsp& bsp) {
  std::vector<bool> reached(bsp.nodes.size()), is_checked_head(bsp.nodes.size());
  for (const BspModel& model : bsp.models) {
    const std::int32_t head = model.head_nodes[0];
    if (head < 0) continue;
    if (is_checked_head[static_cast<std::size_t>(head)]) continue;
    if (auto fault = check_node_tree(bsp, head, reached)) return fault;
    is_checked_head[static_cast<std::size_t>(head)] = true;
  }
  return std::nullopt;
}

std::optional<BspFault> check_clipnode_trees(const Bsp& bsp) {
  ClipnodeWalk walk(bsp.clipnodes);
  for (const BspModel& model : bsp.models)
    for (std::size_t hull = 1; hull < model.head_nodes.size(); ++hull)
      if (auto fault = walk.check(model.head_nodes[hull])) return fault;
  return std::nullopt;
}

}  // namespace temblor::formats::bsp_file
