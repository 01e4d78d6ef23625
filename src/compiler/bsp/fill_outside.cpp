#include "compiler/bsp/fill_outside.h"

#include <deque>
#include <limits>

namespace temblor::compiler {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// The mean of its corners.
math::Vec3d compute_portal_center(const Winding& winding) {
  math::Vec3d sum(0.0);
  for (const math::Vec3d& point : winding) sum += point;
  return sum / static_cast<double>(winding.size());
}

// A breadth-first search from the outside, so that the path of a leak is a short one.
struct Flood {
  std::vector<bool> reached;  // by leaf
  // By leaf: the portal through which it was reached; kNone: from outside.
  std::vector<std::uint32_t> through;
};

// Floods from the leaves at the edge of the tree's box through all leaves that are not opaque.
Flood flood(const Tree& tree, const LeafPortals& portals) {
  std::vector<std::vector<std::uint32_t>> portals_at(tree.leaves.size());
  for (std::size_t i = 0; i < portals.portals.size(); ++i)
    for (const std::uint32_t leaf : portals.portals[i].leaves)
      portals_at[leaf].push_back(static_cast<std::uint32_t>(i));
  Flood flood{std::vector<bool>(tree.leaves.size(), false),
              std::vector<std::uint32_t>(tree.leaves.size(), kNone)};
  std::deque<std::uint32_t> next;
  const auto reach = [&](std::uint32_t leaf, std::uint32_t portal) {
    if (flood.reached[leaf] || is_opaque(tree.leaves[leaf].fill)) return;
    flood.reached[leaf] = true;
    flood.through[leaf] = portal;
    next.push_back(leaf);
  };
  for (std::uint32_t leaf = 0; leaf < tree.leaves.size(); ++leaf)
    if (portals.is_outermost[leaf]) reach(leaf, kNone);
  while (!next.empty()) {
    const std::uint32_t leaf = next.front();
    next.pop_front();
    for (const std::uint32_t portal : portals_at[leaf]) {
      const auto& sides = portals.portals[portal].leaves;
      reach(sides[0] == leaf ? sides[1] : sides[0], portal);
    }
  }
  return flood;
}

}  // namespace

std::optional<Leak> fill_outside(Tree& io_tree, const PlaneSet& planes, const LeafPortals& portals,
                                 std::span<const math::Vec3d> occupants) {
  const Flood found = flood(io_tree, portals);
  for (std::size_t i = 0; i < occupants.size(); ++i) {
    std::uint32_t leaf = io_tree.leaf_at(occupants[i], planes);
    // The first occupant that is reached; more of them would only repeat the message.
    if (!found.reached[leaf]) continue;
    Leak leak{i, {occupants[i]}};
    for (std::uint32_t portal = found.through[leaf]; portal != kNone; portal = found.through[leaf]) {
      const LeafPortal& door = portals.portals[portal];
      leak.path_world.push_back(compute_portal_center(door.winding));
      leaf = door.leaves[0] == leaf ? door.leaves[1] : door.leaves[0];
    }
    return leak;
  }
  if (occupants.empty()) return std::nullopt;  // an ammunition box, for example, is all outside
  for (std::size_t leaf = 0; leaf < io_tree.leaves.size(); ++leaf)
    if (found.reached[leaf]) io_tree.leaves[leaf] = {Fill::kSolid, Fill::kSolid, {}};
  return std::nullopt;
}

}  // namespace temblor::compiler
