// Method: the tree is cut off where detail begins, and the portals of what is left are made as for any tree.
// A leaf of the shortened tree is opaque only if all structural leaves in it are.
#include "compiler/bsp/cluster_portals.h"

#include <algorithm>

namespace temblor::compiler {
namespace {

// The structural part of a tree: its leaves are the clusters.
struct CoarseTree {
  Tree tree;
  std::vector<std::uint32_t> coarse_leaf;  // by leaf of the whole tree: its leaf in `tree`
};

// Copies a tree without its detail nodes. All leaves of the copy count as opaque until an open one is found
// in them.
class Coarsener {
 public:
  explicit Coarsener(const Tree& tree) : whole_(tree) {
    out_.tree.box = tree.box;
    out_.coarse_leaf.assign(tree.leaves.size(), 0);
  }

  CoarseTree make() {
    out_.tree.root = add(whole_.root);
    return std::move(out_);
  }

 private:
  std::int32_t add(std::int32_t child) {
    if (child < 0 || whole_.nodes[static_cast<std::size_t>(child)].is_detail) {
      out_.tree.leaves.push_back({Fill::kSky, Fill::kSky, {}});
      gather(child, out_.tree.leaves.size() - 1);
      return ~static_cast<std::int32_t>(out_.tree.leaves.size() - 1);
    }
    const TreeNode& from = whole_.nodes[static_cast<std::size_t>(child)];
    const std::size_t index = out_.tree.nodes.size();
    out_.tree.nodes.push_back({from.plane, {}, false});
    const std::int32_t front = add(from.children[0]), back = add(from.children[1]);
    out_.tree.nodes[index].children = {front, back};
    return static_cast<std::int32_t>(index);
  }

  // Collects the leaves of a subtree in one coarse leaf. It is open if any of them is.
  void gather(std::int32_t child, std::size_t into) {
    if (child >= 0) {
      for (const std::int32_t below : whole_.nodes[static_cast<std::size_t>(child)].children)
        gather(below, into);
      return;
    }
    const auto leaf = static_cast<std::size_t>(~child);
    out_.coarse_leaf[leaf] = static_cast<std::uint32_t>(into);
    Fill& structure = out_.tree.leaves[into].structure;
    if (!is_opaque(whole_.leaves[leaf].structure)) structure = whole_.leaves[leaf].structure;
  }

  const Tree& whole_;
  CoarseTree out_;
};

// Whether one can see through the portal between two structural fills.
bool is_open(Fill a, Fill b, bool water_is_transparent) {
  if (is_opaque(a) || is_opaque(b)) return false;
  if (a != b && (a == Fill::kVisBlocker || b == Fill::kVisBlocker)) return false;
  return water_is_transparent || a == b || (!is_liquid(a) && !is_liquid(b));
}

}  // namespace

// A cluster without any leaf of the level is solid; it has no number, and no portal leads to it.
PortalSet make_cluster_portals(const Tree& tree, const PlaneSet& planes,
                               std::span<const std::uint32_t> leaf_numbers, std::size_t leaf_count,
                               bool water_is_transparent) {
  const CoarseTree coarse = Coarsener(tree).make();
  PortalSet set;
  set.cluster_of_leaf.assign(leaf_count, kNoCluster);
  // Clusters are numbered in the order of the level's leaves.
  std::vector<std::uint32_t> leaf_of_number(leaf_count, 0);
  for (std::uint32_t leaf = 0; leaf < leaf_numbers.size(); ++leaf) leaf_of_number[leaf_numbers[leaf]] = leaf;
  std::vector<std::uint32_t> cluster(coarse.tree.leaves.size(), kNoCluster);
  const std::uint32_t last = *std::max_element(leaf_numbers.begin(), leaf_numbers.end());
  for (std::uint32_t number = 1; number <= last; ++number) {
    std::uint32_t& of_coarse = cluster[coarse.coarse_leaf[leaf_of_number[number]]];
    if (of_coarse == kNoCluster) of_coarse = set.cluster_count++;
    set.cluster_of_leaf[number] = of_coarse;
  }
  for (LeafPortal& portal : make_leaf_portals(coarse.tree, planes).portals) {
    const auto [front, back] = portal.leaves;
    if (cluster[front] == kNoCluster || cluster[back] == kNoCluster) continue;
    if (!is_open(coarse.tree.leaves[front].structure, coarse.tree.leaves[back].structure,
                 water_is_transparent))
      continue;
    const Plane& plane = planes[coarse.tree.nodes[portal.node].plane];
    set.portals.push_back(
        {std::move(portal.winding), plane.normal, plane.distance, {cluster[front], cluster[back]}});
  }
  return set;
}

}  // namespace temblor::compiler
