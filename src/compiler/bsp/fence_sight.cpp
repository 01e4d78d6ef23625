#include "compiler/bsp/fence_sight.h"

#include <algorithm>
#include <set>

namespace temblor::compiler {
namespace {

class FenceSight {
 public:
  FenceSight(const Tree& tree, std::span<const LeafPortal> portals) : tree_(tree) {
    neighbours_.resize(tree.leafs.size());
    for (const LeafPortal& portal : portals)
      for (const int side : {0, 1})
        if (is_fence(portal.leafs[static_cast<std::size_t>(side)]))
          neighbours_[portal.leafs[static_cast<std::size_t>(side)]].push_back(
              portal.leafs[static_cast<std::size_t>(1 - side)]);
  }

  bool is_fence(std::uint32_t leaf) const { return tree_.leafs[leaf].fill == Fill::kFence; }

  // Those around the fence that one of `leafs` is a part of.
  std::vector<std::uint32_t> around(std::span<const std::uint32_t> leafs) const {
    std::set<std::uint32_t> fence, found;
    std::vector<std::uint32_t> next(leafs.begin(), leafs.end());
    while (!next.empty()) {
      const std::uint32_t leaf = next.back();
      next.pop_back();
      if (!is_fence(leaf)) {
        if (!is_blocked(tree_.leafs[leaf].fill)) found.insert(leaf);
      } else if (fence.insert(leaf).second) {
        next.insert(next.end(), neighbours_[leaf].begin(), neighbours_[leaf].end());
      }
    }
    return {found.begin(), found.end()};
  }

 private:
  const Tree& tree_;
  std::vector<std::vector<std::uint32_t>> neighbours_;  // by leaf; of fences alone
};

}  // namespace

void mark_around_fences(std::span<TreeFace> io_faces, const Tree& tree, std::span<const LeafPortal> portals) {
  const FenceSight sight(tree, portals);
  for (TreeFace& face : io_faces) {
    const bool any_fence =
        std::ranges::any_of(face.leafs, [&](std::uint32_t leaf) { return sight.is_fence(leaf); });
    const bool any_open = std::ranges::any_of(
        face.leafs, [&](std::uint32_t leaf) { return !is_blocked(tree.leafs[leaf].fill); });
    if (any_fence && !any_open) face.leafs = sight.around(face.leafs);
  }
}

}  // namespace temblor::compiler
