// Method: a flood fill through the leaves of one fence, whose open neighbors are the leaves that get the
// faces.
#include "compiler/bsp/fence_sight.h"

#include <algorithm>
#include <set>

namespace temblor::compiler {
namespace {

// Walks through fences from leaf to leaf.
class FenceSight {
 public:
  // Lists neighbors for fences only: nothing walks on from an open leaf.
  FenceSight(const Tree& tree, std::span<const LeafPortal> portals) : tree_(tree) {
    neighbors_.resize(tree.leaves.size());
    for (const LeafPortal& portal : portals)
      for (const int side : {0, 1})
        if (is_fence(portal.leaves[static_cast<std::size_t>(side)]))
          neighbors_[portal.leaves[static_cast<std::size_t>(side)]].push_back(
              portal.leaves[static_cast<std::size_t>(1 - side)]);
  }

  bool is_fence(std::uint32_t leaf) const { return tree_.leaves[leaf].fill == Fill::kFence; }

  // The open leaves around the fence that contains any of `leaves`.
  std::vector<std::uint32_t> around(std::span<const std::uint32_t> leaves) const {
    std::set<std::uint32_t> fence, found;
    std::vector<std::uint32_t> next(leaves.begin(), leaves.end());
    while (!next.empty()) {
      const std::uint32_t leaf = next.back();
      next.pop_back();
      if (!is_fence(leaf)) {
        if (!is_blocked(tree_.leaves[leaf].fill)) found.insert(leaf);
      } else if (fence.insert(leaf).second) {
        next.insert(next.end(), neighbors_[leaf].begin(), neighbors_[leaf].end());
      }
    }
    return {found.begin(), found.end()};
  }

 private:
  const Tree& tree_;
  std::vector<std::vector<std::uint32_t>> neighbors_;  // by leaf; only fences have any
};

}  // namespace

void mark_around_fences(std::span<TreeFace> io_faces, const Tree& tree, std::span<const LeafPortal> portals) {
  const FenceSight sight(tree, portals);
  for (TreeFace& face : io_faces) {
    const bool any_fence =
        std::ranges::any_of(face.leaves, [&](std::uint32_t leaf) { return sight.is_fence(leaf); });
    const bool any_open = std::ranges::any_of(
        face.leaves, [&](std::uint32_t leaf) { return !is_blocked(tree.leaves[leaf].fill); });
    if (any_fence && !any_open) face.leaves = sight.around(face.leaves);
  }
}

}  // namespace temblor::compiler
