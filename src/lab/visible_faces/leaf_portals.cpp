#include "lab/visible_faces/leaf_portals.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

namespace temblor::lab {

namespace {

using Corners = std::vector<math::Vec3d>;

// Units. A corner nearer to a plane is on it. Narrower openings are lost, but neighbors of a portal are found
// within a pixel, which is much more.
constexpr double kOnPlane = 1e-5;
// Cuts of polygons, each of which takes about 100 ns.
constexpr std::uint64_t kMaxCuts = 30'000'000;
constexpr double kMinExtent = 1 << 20;
constexpr world::LeafIndex kOutside{0};  // solid, whatever its contents

struct Cut {
  math::Vec3d normal;
  double distance;

  double height(const math::Vec3d& point) const { return glm::dot(normal, point) - distance; }
};

Cut find_cut(const world::Level& level, const world::Node& node) {
  const world::Plane& plane = level.planes[node.plane];
  return {math::Vec3d(plane.normal), double{plane.distance}};
}

// The parts in front of and behind a plane. Both are empty if the polygon lies in the plane.
struct Parts {
  Corners front, back;
};
Parts split(Corners corners, const Cut& cut) {
  bool has_front = false, has_back = false;
  for (const math::Vec3d& corner : corners) {
    has_front |= cut.height(corner) > kOnPlane;
    has_back |= cut.height(corner) < -kOnPlane;
  }
  Parts parts;
  if (has_front && !has_back) parts.front = std::move(corners);
  if (has_back && !has_front) parts.back = std::move(corners);
  if (!has_front || !has_back) return parts;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const math::Vec3d &here = corners[i], &next = corners[(i + 1) % corners.size()];
    const double here_height = cut.height(here), next_height = cut.height(next);
    if (here_height >= -kOnPlane) parts.front.push_back(here);
    if (here_height <= kOnPlane) parts.back.push_back(here);
    if ((here_height > kOnPlane && next_height < -kOnPlane) ||
        (here_height < -kOnPlane && next_height > kOnPlane)) {
      const math::Vec3d crossing = here + (next - here) * (here_height / (here_height - next_height));
      parts.front.push_back(crossing);
      parts.back.push_back(crossing);
    }
  }
  return parts;
}

// A square in the plane that contains all of its points within `extent` of the origin along each axis. Empty
// if the plane has no direction.
Corners make_square(const Cut& cut, double extent) {
  const double length = glm::length(cut.normal);
  if (!(length > 0)) return {};
  const math::Vec3d normal = cut.normal / length;
  const math::Vec3d along = std::abs(normal.z) < 0.7 ? math::Vec3d(0, 0, 1) : math::Vec3d(1, 0, 0);
  const math::Vec3d side = glm::normalize(glm::cross(normal, along)) * (2 * extent);
  const math::Vec3d up = glm::cross(normal, side);
  const math::Vec3d middle = normal * (cut.distance / length);
  return {middle + side + up, middle + side - up, middle - side - up, middle - side + up};
}

class PortalMaker {
 public:
  PortalMaker(const world::Level& level, std::size_t max_portals) : level_(level), max_portals_(max_portals) {
    const math::Bounds& bounds = level.world().bounds;
    made_.extent = kMinExtent;
    for (int axis = 0; axis < 3; ++axis)
      made_.extent =
          std::max({made_.extent, 4.0 * std::abs(bounds.mins[axis]), 4.0 * std::abs(bounds.maxs[axis])});
  }

  // Returns false if there is too much to do.
  bool make_all() {
    std::vector<Visit> open = {{level_.world().head, kNoStep}};
    while (!open.empty()) {
      const Visit visit = open.back();
      open.pop_back();
      if (visit.child.is_leaf()) continue;
      const world::Node& node = level_.node(visit.child.node());
      const Cut cut = find_cut(level_, node);
      if (!join_sides(node, cut, find_opening(cut, visit.last_step))) return false;
      for (int side = 0; side < 2; ++side) {
        steps_.push_back({node.plane, side, visit.last_step});
        open.push_back(
            {node.children[static_cast<std::size_t>(side)], static_cast<std::uint32_t>(steps_.size() - 1)});
      }
    }
    list_by_leaf();
    return true;
  }

  LevelPortals take() { return std::move(made_); }
  std::size_t portal_count() const { return made_.portals.size(); }

 private:
  // A step from a node to one of its sides, on the way from the root.
  static constexpr std::uint32_t kNoStep = 0xffffffff;
  struct Step {
    std::uint32_t plane;
    int side;
    std::uint32_t step_before;
  };
  struct Visit {
    world::Child child;
    std::uint32_t last_step;
  };
  struct Piece {
    std::uint32_t leaf;
    Corners corners;
  };

  // The part of a node's plane that is inside the node's volume.
  Corners find_opening(const Cut& cut, std::uint32_t step) {
    Corners corners = make_square(cut, made_.extent);
    for (; step != kNoStep && !corners.empty(); step = steps_[step].step_before) {
      const world::Plane& plane = level_.planes[steps_[step].plane];
      Parts parts = split(std::move(corners), {math::Vec3d(plane.normal), double{plane.distance}});
      corners = std::move(steps_[step].side == 0 ? parts.front : parts.back);
      ++cuts_;
    }
    return corners;
  }

  bool join_sides(const world::Node& node, const Cut& cut, Corners opening) {
    if (opening.empty()) return cuts_ < kMaxCuts;
    std::vector<Piece> fronts, backs;
    push_down(node.children[0], cut.normal, std::move(opening), fronts);
    for (Piece& front : fronts) {
      backs.clear();
      push_down(node.children[1], -cut.normal, std::move(front.corners), backs);
      for (const Piece& back : backs) add(cut, {front.leaf, back.leaf}, back.corners);
    }
    return cuts_ < kMaxCuts && made_.portals.size() <= max_portals_;
  }

  // Cuts a polygon on the surface of a subtree's volume into a piece for each open leaf that touches it.
  // `inward` points into the volume.
  void push_down(world::Child subtree, const math::Vec3d& inward, Corners corners,
                 std::vector<Piece>& io_pieces) {
    std::vector<std::pair<world::Child, Corners>> open;
    open.emplace_back(subtree, std::move(corners));
    while (!open.empty() && cuts_ < kMaxCuts) {
      auto [child, part] = std::move(open.back());
      open.pop_back();
      if (child.is_leaf()) {
        if (child.leaf() != kOutside && level_.leaf(child.leaf()).contents != world::Contents::kSolid)
          io_pieces.push_back({static_cast<std::uint32_t>(child.leaf()), std::move(part)});
        continue;
      }
      ++cuts_;
      const world::Node& node = level_.node(child.node());
      const Cut cut = find_cut(level_, node);
      const bool is_in_plane = std::ranges::all_of(
          part, [&](const auto& corner) { return std::abs(cut.height(corner)) <= kOnPlane; });
      if (is_in_plane) {
        open.emplace_back(node.children[glm::dot(cut.normal, inward) > 0 ? 0 : 1], std::move(part));
        continue;
      }
      Parts parts = split(std::move(part), cut);
      if (!parts.front.empty()) open.emplace_back(node.children[0], std::move(parts.front));
      if (!parts.back.empty()) open.emplace_back(node.children[1], std::move(parts.back));
    }
  }

  void add(const Cut& cut, const std::array<std::uint32_t, 2>& leaves, const Corners& corners) {
    Portal portal{cut.normal,
                  cut.distance,
                  corners[0],
                  corners[0],
                  leaves,
                  static_cast<std::uint32_t>(made_.corners.size()),
                  static_cast<std::uint32_t>(corners.size())};
    for (const math::Vec3d& corner : corners) {
      portal.mins = glm::min(portal.mins, corner);
      portal.maxs = glm::max(portal.maxs, corner);
    }
    made_.corners.insert(made_.corners.end(), corners.begin(), corners.end());
    made_.portals.push_back(portal);
  }

  void list_by_leaf() {
    made_.leaf_begin.assign(level_.leaves.size() + 1, 0);
    for (const Portal& portal : made_.portals)
      for (const std::uint32_t leaf : portal.leaves) ++made_.leaf_begin[leaf];
    // From counts to positions: of the last portal first, because adding one moves the position down.
    std::uint32_t before = 0;
    for (std::uint32_t& count : made_.leaf_begin) before = count += before;
    made_.portal_numbers.resize(before);
    for (std::size_t number = made_.portals.size(); number-- > 0;)
      for (const std::uint32_t leaf : made_.portals[number].leaves)
        made_.portal_numbers[--made_.leaf_begin[leaf]] = static_cast<std::uint32_t>(number);
  }

  const world::Level& level_;
  const std::size_t max_portals_;
  LevelPortals made_;
  std::vector<Step> steps_;
  std::uint64_t cuts_ = 0;
};

}  // namespace

std::size_t LevelPortals::size_bytes() const {
  return portals.size() * sizeof(Portal) + corners.size() * sizeof(math::Vec3d) +
         (leaf_begin.size() + portal_numbers.size()) * sizeof(std::uint32_t);
}

base::Result<LevelPortals> make_level_portals(const world::Level& level, std::size_t max_portals) {
  PortalMaker maker(level, max_portals);
  if (maker.make_all()) return maker.take();
  if (maker.portal_count() > max_portals)
    return base::error(base::ErrorCode::kTooLarge,
                       "level {} has more than {} portals, so portals cannot draw it", level.name,
                       max_portals);
  return base::error(base::ErrorCode::kTooLarge,
                     "the BSP tree of level {} is too deep, so portals cannot draw it", level.name);
}

}  // namespace temblor::lab
