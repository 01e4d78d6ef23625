#include "compiler/bsp/flood.h"

#include <algorithm>
#include <deque>
#include <utility>

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
        is_thin_(tree.leaves.size(), false),
        windows_(2 * portals.portals.size()) {
    for (std::size_t i = 0; i < portals.portals.size(); ++i)
      for (const std::uint32_t leaf : portals.portals[i].leaves)
        portals_at_[leaf].push_back(static_cast<std::uint32_t>(i));
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
  // A leaf, and the portal through which the flood came into it.
  struct Entry {
    std::uint32_t leaf, portal;
    Winding window;  // the part of the portal through which it came, if the leaf is thin
  };

  const LeafPortal& portal(std::uint32_t number) const { return portals_.portals[number]; }
  const Plane& portal_plane(std::uint32_t number) const {
    return planes_[tree_.nodes[portal(number).node].plane];
  }

  // A thin leaf is entered through each window that is not in an earlier one, another leaf only once. `side`:
  // the leaf's place in the portal's pair.
  void enter(std::uint32_t leaf, std::uint32_t through, std::size_t side, Winding window) {
    if (!flood_.reached[leaf]) {
      flood_.reached[leaf] = true;
      flood_.through[leaf] = through;
      is_thin_[leaf] = find_whether_thin(leaf);
    } else if (!is_thin_[leaf]) {
      return;
    }
    if (is_thin_[leaf] && through != kNoPortal) {
      std::vector<Winding>& earlier = windows_[2 * through + side];
      if (std::ranges::any_of(earlier, [&](const Winding& other) {
            return is_inside(window, make_side_planes(other, portal_plane(through).normal));
          }))
        return;
      earlier.push_back(window);
    }
    entries_.push_back({leaf, through, std::move(window)});
  }

  void leave(const Entry& entry) {
    for (const std::uint32_t number : portals_at_[entry.leaf]) {
      const std::size_t side = portal(number).leaves[0] == entry.leaf ? 1 : 0;
      const std::uint32_t next = portal(number).leaves[side];
      if (is_sealed(tree_.leaves[next])) continue;
      Winding window = portal(number).winding;
      if (is_thin_[entry.leaf] && entry.portal != kNoPortal) window = find_window(entry, number);
      if (compute_width(window) < min_opening_) continue;
      enter(next, number, side, std::move(window));
    }
  }

  // Whether two parallel planes with less than the opening between them enclose a leaf. Leaves at the edge of
  // the tree's box have no portals there.
  bool find_whether_thin(std::uint32_t leaf) const {
    if (portals_.is_outermost[leaf]) return false;
    return std::ranges::any_of(portals_at_[leaf], [&](std::uint32_t number) {
      const math::Vec3d& normal = portal_plane(number).normal;
      double nearest = std::numeric_limits<double>::max(), farthest = -nearest;
      for (const std::uint32_t other : portals_at_[leaf])
        for (const math::Vec3d& point : portal(other).winding) {
          nearest = std::min(nearest, glm::dot(normal, point));
          farthest = std::max(farthest, glm::dot(normal, point));
        }
      return farthest - nearest < min_opening_;
    });
  }

  // The part of a thin leaf's portal that is opposite the window through which the flood came; empty if both
  // are in one plane.
  Winding find_window(const Entry& entry, std::uint32_t to) const {
    if (portal(entry.portal).node == portal(to).node) return {};
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
  std::vector<std::vector<std::uint32_t>> portals_at_;  // by leaf
  std::vector<bool> is_thin_;  // by leaf that was reached: it is an opening that is too narrow
  // By portal and side: the windows through which the flood went to a thin leaf on that side.
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
