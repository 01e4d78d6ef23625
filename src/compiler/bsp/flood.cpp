#include "compiler/bsp/flood.h"

#include <algorithm>
#include <deque>
#include <utility>

namespace temblor::compiler {
namespace {

class LeafFlood {
 public:
  LeafFlood(const Tree& tree, const PlaneSet& planes, const LeafPortals& portals, double min_opening_units)
      : tree_(tree),
        planes_(planes),
        portals_(portals),
        min_opening_(min_opening_units),
        portals_at_(tree.leaves.size()),
        is_thin_(tree.leaves.size(), false),
        crossed_(2 * portals.portals.size(), false) {
    for (std::size_t i = 0; i < portals.portals.size(); ++i)
      for (const std::uint32_t leaf : portals.portals[i].leaves)
        portals_at_[leaf].push_back(static_cast<std::uint32_t>(i));
    flood_.reached.assign(tree.leaves.size(), false);
    flood_.through.assign(tree.leaves.size(), kNoPortal);
  }

  Flood run(std::span<const std::uint32_t> first_leaves) {
    for (const std::uint32_t leaf : first_leaves)
      if (!is_sealed(tree_.leaves[leaf])) enter(leaf, kNoPortal);
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
  };

  const LeafPortal& portal(std::uint32_t number) const { return portals_.portals[number]; }
  const Plane& portal_plane(std::uint32_t number) const {
    return planes_[tree_.nodes[portal(number).node].plane];
  }

  // A thin leaf is entered through each of its portals, another one only once.
  void enter(std::uint32_t leaf, std::uint32_t through) {
    if (flood_.reached[leaf] && !is_thin_[leaf]) return;
    if (!flood_.reached[leaf]) {
      flood_.reached[leaf] = true;
      flood_.through[leaf] = through;
      is_thin_[leaf] = find_whether_thin(leaf);
    }
    entries_.push_back({leaf, through});
  }

  void leave(const Entry& entry) {
    for (const std::uint32_t number : portals_at_[entry.leaf]) {
      const std::size_t side = portal(number).leaves[0] == entry.leaf ? 1 : 0;
      const std::uint32_t next = portal(number).leaves[side];
      if (is_sealed(tree_.leaves[next]) || crossed_[2 * number + side]) continue;
      if (compute_width(portal(number).winding) < min_opening_) continue;
      if (is_thin_[entry.leaf] && entry.portal != kNoPortal && !can_cross(entry.portal, number)) continue;
      crossed_[2 * number + side] = true;
      enter(next, number);
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

  // Whether two portals of a thin leaf face each other, with an opening between them.
  bool can_cross(std::uint32_t from, std::uint32_t to) const {
    if (portal(from).node == portal(to).node) return false;
    const math::Vec3d& normal = portal_plane(to).normal;
    Winding shared = portal(from).winding;
    const Winding& frame = portal(to).winding;
    math::Vec3d inside(0.0);
    for (const math::Vec3d& point : frame) inside += point / static_cast<double>(frame.size());
    for (std::size_t i = 0; i < frame.size() && !shared.empty(); ++i) {
      const math::Vec3d side = frame[i + 1 < frame.size() ? i + 1 : 0] - frame[i];
      if (glm::length(side) < kOnPlaneEpsilon) continue;
      Plane wall;
      wall.normal = glm::normalize(glm::cross(side, normal));
      wall.distance = glm::dot(wall.normal, frame[i]);
      if (wall.distance_to(inside) > 0) {
        wall.normal = -wall.normal;
        wall.distance = -wall.distance;
      }
      cut_to_back(shared, wall, true);
    }
    return compute_width(shared) >= min_opening_;
  }

  const Tree& tree_;
  const PlaneSet& planes_;
  const LeafPortals& portals_;
  double min_opening_;
  std::vector<std::vector<std::uint32_t>> portals_at_;  // by leaf
  std::vector<bool> is_thin_;  // by leaf that was reached: it is an opening that is too narrow
  std::vector<bool> crossed_;  // by portal and side: the flood went to that side
  std::deque<Entry> entries_;
  Flood flood_;
};

}  // namespace

Flood flood_leaves(const Tree& tree, const PlaneSet& planes, const LeafPortals& portals,
                   std::span<const std::uint32_t> first_leaves, double min_opening_units) {
  return LeafFlood(tree, planes, portals, min_opening_units).run(first_leaves);
}

}  // namespace temblor::compiler
