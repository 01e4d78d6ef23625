#include "compiler/bsp/outside/flood.h"

#include <algorithm>
#include <deque>
#include <optional>
#include <utility>

#include "compiler/bsp/outside/wedge.h"

namespace temblor::compiler {
namespace {

// Planes through the sides of a convex polygon and along a direction, facing outward.
std::vector<Plane> make_side_planes(const Winding& polygon, const math::Vec3d& direction) {
  math::Vec3d inside(0.0);
  for (const math::Vec3d& point : polygon) inside += point / static_cast<double>(polygon.size());
  std::vector<Plane> planes;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const math::Vec3d side = polygon[i + 1 < polygon.size() ? i + 1 : 0] - polygon[i];
    if (glm::length(side) < kOnPlaneEpsilon) continue;
    Plane& plane = planes.emplace_back();
    plane.normal = glm::normalize(glm::cross(side, direction));
    plane.distance = glm::dot(plane.normal, polygon[i]);
    if (plane.distance_to(inside) <= 0) continue;
    plane.normal = -plane.normal;
    plane.distance = -plane.distance;
  }
  return planes;
}

class LeafFlood {
 public:
  LeafFlood(const Tree& tree, const PlaneSet& planes, const LeafPortals& portals, double min_opening_units)
      : tree_(tree),
        planes_(planes),
        portals_(portals),
        min_opening_(min_opening_units),
        portals_at_(tree.leaves.size()),
        exits_at_(tree.leaves.size()),
        shapes_(tree.leaves.size()),
        windows_(2 * portals.portals.size()) {
    for (std::size_t i = 0; i < portals.portals.size(); ++i)
      for (const std::uint32_t leaf : portals.portals[i].leaves)
        portals_at_[leaf].push_back(static_cast<std::uint32_t>(i));
    for (std::size_t i = 0; i < portals.exits.size(); ++i)
      exits_at_[portals.exits[i].leaf].push_back(static_cast<std::uint32_t>(i));
    flood_.reached.assign(tree.leaves.size(), false);
    flood_.through.assign(tree.leaves.size(), kNoPortal);
  }

  Flood run(std::span<const std::uint32_t> first_leaves) {
    for (const std::uint32_t leaf : first_leaves)
      if (!is_sealed(tree_.leaves[leaf])) enter(leaf, kNoPortal, 0, {});
    while (!entries_.empty()) {
      const Entry entry = entries_.front();
      entries_.pop_front();
      leave(entry);
    }
    return std::move(flood_);
  }

 private:
  // Where a flood can move freely.
  enum class Room {
    kEverywhere,
    kNowhere,      // the leaf is thin: two parallel planes with less than the opening between them enclose it
    kBehindLimit,  // the leaf is a wedge
  };
  struct Shape {
    Room room = Room::kEverywhere;
    Wedge wedge{};
    bool has_filled_room = false;  // the flood has been where it can move freely
  };

  // A leaf, and the portal through which the flood came into it.
  struct Entry {
    std::uint32_t leaf, portal;
    // The flood crosses a narrow place, opposite this part of the portal. Empty: it fills the leaf's room.
    Winding window;
  };

  const LeafPortal& portal(std::uint32_t number) const { return portals_.portals[number]; }
  const Plane& portal_plane(std::uint32_t number) const {
    return planes_[tree_.nodes[portal(number).node].plane];
  }

  // The room of a leaf is entered once, a narrow place through each window that is not in an earlier one.
  // `side`: the leaf's place in the portal's pair.
  void enter(std::uint32_t leaf, std::uint32_t through, std::size_t side, Winding window) {
    if (!shapes_[leaf]) {
      shapes_[leaf] = find_shape(leaf);
      flood_.through[leaf] = through;
    }
    Shape& shape = *shapes_[leaf];
    if (!shape.has_filled_room &&
        (through == kNoPortal ? can_begin_in_room(leaf) : is_in_room(shape, window))) {
      shape.has_filled_room = true;
      entries_.push_back({leaf, through, {}});
    }
    // The wide part of a wedge may be inside, although the narrow part was crossed.
    flood_.reached[leaf] = flood_.reached[leaf] || shape.has_filled_room || shape.room == Room::kNowhere;
    if (through == kNoPortal || shape.room == Room::kEverywhere) return;
    std::vector<Winding>& earlier = windows_[2 * through + side];
    if (std::ranges::any_of(earlier, [&](const Winding& other) {
          return is_inside(window, make_side_planes(other, portal_plane(through).normal));
        }))
      return;
    earlier.push_back(window);
    entries_.push_back({leaf, through, std::move(window)});
  }

  void leave(const Entry& entry) {
    for (const std::uint32_t number : portals_at_[entry.leaf]) {
      const std::size_t side = portal(number).leaves[0] == entry.leaf ? 1 : 0;
      const std::uint32_t next = portal(number).leaves[side];
      if (is_sealed(tree_.leaves[next])) continue;
      Winding window = entry.window.empty() ? find_exit(entry.leaf, number) : find_window(entry, number);
      if (compute_width(window) < min_opening_) continue;
      enter(next, number, side, std::move(window));
    }
  }

  // Whether an opening leads to where the flood can move freely.
  bool is_in_room(const Shape& shape, Winding window) const {
    if (shape.room == Room::kBehindLimit) cut_to_back(window, shape.wedge.limit, false);
    return shape.room != Room::kNowhere && compute_width(window) >= min_opening_;
  }

  // Whether a flood that begins in a leaf can move freely there. One from outside comes in at the edge of the
  // tree's box.
  bool can_begin_in_room(std::uint32_t leaf) const {
    return exits_at_[leaf].empty() || std::ranges::any_of(exits_at_[leaf], [&](std::uint32_t exit) {
             return is_in_room(*shapes_[leaf], portals_.exits[exit].winding);
           });
  }

  Shape find_shape(std::uint32_t leaf) const {
    std::vector<LeafPlane> leaf_planes;
    std::vector<math::Vec3d> corners;
    for (const std::uint32_t number : portals_at_[leaf]) {
      const Winding& winding = portal(number).winding;
      corners.insert(corners.end(), winding.begin(), winding.end());
      const std::uint32_t node = portal(number).node;
      if (std::ranges::find(leaf_planes, node, &LeafPlane::node) != leaf_planes.end()) continue;
      const PlaneIndex plane = tree_.nodes[node].plane;
      leaf_planes.push_back({planes_[portal(number).leaves[0] == leaf ? flipped(plane) : plane], node});
    }
    for (const std::uint32_t number : exits_at_[leaf]) {
      const Winding& winding = portals_.exits[number].winding;
      corners.insert(corners.end(), winding.begin(), winding.end());
    }
    const auto is_thin_along = [&](const LeafPlane& side) {
      return std::ranges::all_of(
          corners, [&](const math::Vec3d& corner) { return -side.plane.distance_to(corner) < min_opening_; });
    };
    if (std::ranges::any_of(leaf_planes, is_thin_along)) return {.room = Room::kNowhere};
    if (const auto wedge = find_wedge(leaf_planes, corners, min_opening_))
      return {.room = Room::kBehindLimit, .wedge = *wedge};
    return {};
  }

  // The part of a portal through which the flood leaves the room of a leaf.
  Winding find_exit(std::uint32_t leaf, std::uint32_t to) const {
    Winding exit = portal(to).winding;
    if (shapes_[leaf]->room == Room::kBehindLimit) cut_to_back(exit, shapes_[leaf]->wedge.limit, false);
    return exit;
  }

  // The part of a portal that is opposite the window through which the flood came into a narrow place; empty
  // if the two are not on opposite sides of it.
  Winding find_window(const Entry& entry, std::uint32_t to) const {
    const std::uint32_t from_node = portal(entry.portal).node, to_node = portal(to).node;
    if (from_node == to_node) return {};
    const Shape& shape = *shapes_[entry.leaf];
    const auto is_side = [&](std::uint32_t node) {
      return node == shape.wedge.nodes[0] || node == shape.wedge.nodes[1];
    };
    if (shape.room == Room::kBehindLimit && (!is_side(from_node) || !is_side(to_node))) return {};
    Winding shared = portal(to).winding;
    for (const Plane& side : make_side_planes(entry.window, portal_plane(entry.portal).normal)) {
      if (shared.empty()) break;
      cut_to_back(shared, side, true);
    }
    return shared;
  }

  static bool is_inside(const Winding& window, const std::vector<Plane>& sides) {
    return std::ranges::all_of(window, [&](const math::Vec3d& point) {
      return std::ranges::all_of(
          sides, [&](const Plane& side) { return side.distance_to(point) <= kOnPlaneEpsilon; });
    });
  }

  const Tree& tree_;
  const PlaneSet& planes_;
  const LeafPortals& portals_;
  double min_opening_;
  std::vector<std::vector<std::uint32_t>> portals_at_, exits_at_;  // by leaf
  std::vector<std::optional<Shape>> shapes_;  // by leaf; known once the flood comes to it
  // By portal and side: the windows through which the flood went to a narrow place on that side.
  std::vector<std::vector<Winding>> windows_;
  std::deque<Entry> entries_;
  Flood flood_;
};

}  // namespace

Flood flood_leaves(const Tree& tree, const PlaneSet& planes, const LeafPortals& portals,
                   std::span<const std::uint32_t> first_leaves, double min_opening_units) {
  return LeafFlood(tree, planes, portals, min_opening_units).run(first_leaves);
}

}  // namespace temblor::compiler
