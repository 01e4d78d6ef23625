// Method: a node's plane, clipped to the node's volume, is the opening between the node's two sides. Pushed
// down both subtrees, it falls into one piece for each pair of leaves that touch there.
#include "compiler/bsp/tree_portals.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "compiler/bsp/winding.h"

namespace temblor::compiler {

namespace {

using math::Vec3d;

constexpr std::int32_t kTreeSolid = -2;
constexpr std::int32_t kTreeSky = -6;
constexpr int kNoAxis = 3;

Plane to_plane(const formats::BspPlane& plane) {
  const Vec3d normal(plane.normal);
  // Portals need normals of length 1 in double precision; the level's are rounded to float.
  const double length = glm::length(normal);
  return {normal / length, double{plane.distance} / length, kNoAxis};
}

// Visits the nodes of a finished level.
class TreeWalk {
 public:
  TreeWalk(const formats::Bsp& bsp, const TreePortalSettings& settings, PortalSet& io_set)
      : bsp_(bsp), settings_(settings), set_(io_set) {}

  // Returns false if there are too many portals.
  bool visit(std::int32_t child) {
    if (child < 0) return true;
    const formats::BspNode& node = bsp_.nodes[static_cast<std::size_t>(child)];
    const Plane plane = to_plane(bsp_.planes[node.plane]);
    if (!join_sides(node, plane, inside_cell(plane))) return false;
    cell_.push_back(plane);
    const bool fits_front = visit(node.children[0]);
    cell_.back() = {-plane.normal, -plane.distance, kNoAxis};
    const bool fits = fits_front && visit(node.children[1]);
    cell_.pop_back();
    return fits;
  }

 private:
  // The part of a plane that is inside the volume of the current node.
  Winding inside_cell(const Plane& plane) const {
    Winding winding = make_base_winding(plane);
    for (std::size_t i = cell_.size(); i-- > 0 && !winding.empty();)
      winding = split(winding, cell_[i], kTreePortalEpsilon).front;
    return winding;
  }

  // Makes the portals between the leaves on both sides of a node's plane.
  bool join_sides(const formats::BspNode& node, const Plane& plane, Winding winding) {
    if (winding.empty()) return true;
    std::vector<std::pair<std::uint32_t, Winding>> fronts, backs;
    push_down(node.children[0], plane.normal, std::move(winding), fronts);
    for (auto& [front_leaf, front_winding] : fronts) {
      backs.clear();
      push_down(node.children[1], -plane.normal, std::move(front_winding), backs);
      for (auto& [back_leaf, back_winding] : backs)
        if (!add(front_leaf, back_leaf, plane, std::move(back_winding))) return false;
    }
    return true;
  }

  // Splits a winding on the surface of a subtree's volume into the pieces that each leaf touches. `inward`
  // points into the volume.
  void push_down(std::int32_t child, const Vec3d& inward, Winding winding,
                 std::vector<std::pair<std::uint32_t, Winding>>& out_pieces) const {
    if (child < 0) {
      const auto leaf = static_cast<std::uint32_t>(-(child + 1));
      if (set_.cluster_of_leaf[leaf] != kNoCluster) out_pieces.emplace_back(leaf, std::move(winding));
      return;
    }
    const formats::BspNode& node = bsp_.nodes[static_cast<std::size_t>(child)];
    const Plane plane = to_plane(bsp_.planes[node.plane]);
    WindingParts pieces = split(winding, plane, kTreePortalEpsilon);
    if (pieces.front.empty() && pieces.back.empty()) {
      const bool front = glm::dot(plane.normal, inward) > 0;
      push_down(node.children[front ? 0 : 1], inward, std::move(winding), out_pieces);
      return;
    }
    if (!pieces.front.empty()) push_down(node.children[0], inward, std::move(pieces.front), out_pieces);
    if (!pieces.back.empty()) push_down(node.children[1], inward, std::move(pieces.back), out_pieces);
  }

  bool add(std::uint32_t front_leaf, std::uint32_t back_leaf, const Plane& plane, Winding winding) {
    if (!can_see_through(bsp_.leaves[front_leaf].contents, bsp_.leaves[back_leaf].contents,
                         settings_.liquids_see_through))
      return true;
    if (set_.portals.size() >= kMaxTreePortals) return false;
    set_.portals.push_back({std::move(winding), plane.normal, plane.distance, {front_leaf, back_leaf}});
    return true;
  }

  const formats::Bsp& bsp_;
  const TreePortalSettings& settings_;
  PortalSet& set_;
  std::vector<Plane> cell_;  // the planes of all ancestors, with the current node in front
};

// Marks the open leaves of the world.
void mark_leaves(const formats::Bsp& bsp, std::int32_t child, PortalSet& io_set) {
  if (child >= 0) {
    for (const std::int32_t below : bsp.nodes[static_cast<std::size_t>(child)].children)
      mark_leaves(bsp, below, io_set);
    return;
  }
  const auto leaf = static_cast<std::size_t>(-(child + 1));
  if (bsp.leaves[leaf].contents != kTreeSolid)
    io_set.cluster_of_leaf[leaf] = static_cast<std::uint32_t>(leaf);  // a placeholder until number_clusters()
}

// Union-find with path halving: the lowest leaf of the group that contains a leaf.
std::uint32_t find_group(std::vector<std::uint32_t>& io_groups, std::uint32_t leaf) {
  while (io_groups[leaf] != leaf) leaf = io_groups[leaf] = io_groups[io_groups[leaf]];
  return leaf;
}

// Until here portals lead from leaf to leaf, afterwards from cluster to cluster.
void number_clusters(const formats::Bsp& bsp, Clusters clusters, PortalSet& io_set) {
  std::vector<std::uint32_t> groups(bsp.leaves.size());
  std::iota(groups.begin(), groups.end(), 0u);
  const auto offset = [&](std::uint32_t leaf) { return bsp.leaves[leaf].visibility_offset; };
  if (clusters == Clusters::kSharedVisibility) {
    for (const Portal& portal : io_set.portals) {
      const auto [a, b] = portal.clusters;
      if (offset(a) < 0 || offset(a) != offset(b)) continue;
      const auto [low, high] = std::minmax({find_group(groups, a), find_group(groups, b)});
      groups[high] = low;
    }
  }
  for (std::uint32_t leaf = 0; leaf < groups.size(); ++leaf) {
    if (io_set.cluster_of_leaf[leaf] == kNoCluster) continue;
    const std::uint32_t group = find_group(groups, leaf);
    io_set.cluster_of_leaf[leaf] = group == leaf ? io_set.cluster_count++ : io_set.cluster_of_leaf[group];
  }
  for (Portal& portal : io_set.portals)
    for (std::uint32_t& cluster : portal.clusters) cluster = io_set.cluster_of_leaf[cluster];
  std::erase_if(io_set.portals,
                [](const Portal& portal) { return portal.clusters[0] == portal.clusters[1]; });
}

bool is_liquid(std::int32_t contents) {
  // Currents (-9 to -14) are water that flows.
  return (contents <= -3 && contents >= -5) || (contents <= -9 && contents >= -14);
}

}  // namespace

bool can_see_through(std::int32_t from, std::int32_t to, bool liquids_see_through) {
  if (from == kTreeSolid || to == kTreeSolid) return false;
  if ((from == kTreeSky) != (to == kTreeSky)) return false;
  return liquids_see_through || is_liquid(from) == is_liquid(to);
}

base::Result<PortalSet> make_tree_portals(const formats::Bsp& bsp, const TreePortalSettings& settings) {
  PortalSet set;
  set.cluster_of_leaf.assign(bsp.leaves.size(), kNoCluster);
  mark_leaves(bsp, bsp.models[0].head_nodes[0], set);
  if (!TreeWalk(bsp, settings, set).visit(bsp.models[0].head_nodes[0]))
    return base::error(base::ErrorCode::kTooLarge,
                       "the level's tree has more than {} portals: visibility cannot be computed",
                       kMaxTreePortals);
  number_clusters(bsp, settings.clusters, set);
  return set;
}

}  // namespace temblor::compiler
