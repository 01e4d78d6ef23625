#include "compiler/bsp/outside/fill_outside.h"

#include <algorithm>

#include "compiler/bsp/outside/flood.h"

namespace temblor::compiler {
namespace {

// No player fits through a narrower opening, and no light is seen through it. Nearly parallel sides of
// brushes leave such wedges between them. Pieces of brushes that are thinner than 0.1 units get lost when the
// tree is built; measured at an angle, their gaps are a little wider.
constexpr double kMinOpening = 0.12;  // units

// The mean of its corners.
math::Vec3d compute_portal_center(const Winding& winding) {
  math::Vec3d sum(0.0);
  for (const math::Vec3d& point : winding) sum += point;
  return sum / static_cast<double>(winding.size());
}

// The point of an exit that is nearest to a point: straight ahead, or on its edge.
math::Vec3d find_nearest_point(const LeafExit& exit, const math::Vec3d& from_world) {
  math::Vec3d ahead = from_world, nearest = exit.winding[0];
  ahead[exit.axis] = nearest[exit.axis];
  bool has_left = false, has_right = false;
  for (std::size_t i = 0; i < exit.winding.size(); ++i) {
    const math::Vec3d& begin = exit.winding[i];
    const math::Vec3d edge = exit.winding[(i + 1) % exit.winding.size()] - begin;
    const double side = glm::cross(edge, ahead - begin)[exit.axis];
    has_left |= side > 0;
    has_right |= side < 0;
    const double along = glm::dot(ahead - begin, edge) / glm::dot(edge, edge);
    const math::Vec3d on_edge = begin + std::clamp(along, 0.0, 1.0) * edge;
    if (glm::distance(on_edge, ahead) < glm::distance(nearest, ahead)) nearest = on_edge;
  }
  return has_left && has_right ? nearest : ahead;
}

Flood flood_from_outside(const Tree& tree, const PlaneSet& planes, const LeafPortals& portals) {
  std::vector<std::uint32_t> outermost;
  for (std::uint32_t leaf = 0; leaf < tree.leaves.size(); ++leaf)
    if (portals.is_outermost[leaf]) outermost.push_back(leaf);
  return flood_leaves(tree, planes, portals, outermost, kMinOpening);
}

std::vector<std::uint32_t> find_leaves_around(const math::Vec3d& point_world, double distance_units,
                                              const Tree& tree, const PlaneSet& planes) {
  return tree.leaves_touching({point_world - distance_units, point_world + distance_units}, planes);
}

// An occupant this near to a leaf may be in it.
constexpr double kNear = 1;  // units

// Where an occupant is.
enum class Place {
  kInside,  // the flood did not get there, or it is in a brush
  kBorder,  // on the side of a brush that is outside
  kOutside,
};

// An occupant on the border of two leaves may belong to either one.
Place find_place(const math::Vec3d& occupant_world, const Tree& tree, const PlaneSet& planes,
                 const Flood& flood) {
  bool is_reached = false, is_on_brush = false;
  for (const std::uint32_t leaf : find_leaves_around(occupant_world, kOnPlaneEpsilon, tree, planes)) {
    is_reached |= flood.reached[leaf];
    is_on_brush |= is_sealed(tree.leaves[leaf]);
  }
  if (!is_reached) return Place::kInside;
  const auto is_inside = [&](std::uint32_t leaf) {
    return !flood.reached[leaf] && !is_sealed(tree.leaves[leaf]);
  };
  if (std::ranges::any_of(find_leaves_around(occupant_world, kNear, tree, planes), is_inside))
    return Place::kInside;
  return is_on_brush ? Place::kBorder : Place::kOutside;
}

// The occupant through which a level leaks: the first one outside, as more of them would only repeat the
// message. One on the border counts only if none is inside.
std::optional<std::size_t> find_leaking_occupant(std::span<const math::Vec3d> occupants, const Tree& tree,
                                                 const PlaneSet& planes, const Flood& flood) {
  std::optional<std::size_t> on_border;
  bool has_inside = false;
  for (std::size_t i = 0; i < occupants.size(); ++i) {
    const Place place = find_place(occupants[i], tree, planes, flood);
    if (place == Place::kOutside) return i;
    if (place == Place::kBorder && !on_border) on_border = i;
    has_inside |= place == Place::kInside;
  }
  return has_inside ? std::nullopt : on_border;
}

// The point at which the way from a point in the box to one outside leaves it.
math::Vec3d find_border(const Box& box, const math::Vec3d& inside, const math::Vec3d& outside) {
  double fraction = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double end = std::clamp(outside[axis], box.mins[axis], box.maxs[axis]);
    if (end != outside[axis])
      fraction = std::min(fraction, (end - inside[axis]) / (outside[axis] - inside[axis]));
  }
  return inside + fraction * (outside - inside);
}

// The way from a point in a leaf out of the box of all brushes. The last leaf may be a large part of the
// level, if a whole wall is missing, so the way goes on to the nearest place where that leaf touches the
// edge.
std::vector<math::Vec3d> find_way_out(const math::Vec3d& from_world, std::uint32_t leaf, const Tree& tree,
                                      const LeafPortals& portals, const Flood& flood) {
  std::vector<math::Vec3d> way_world = {from_world};
  for (std::uint32_t portal = flood.through[leaf]; portal != kNoPortal; portal = flood.through[leaf]) {
    const LeafPortal& door = portals.portals[portal];
    way_world.push_back(compute_portal_center(door.winding));
    leaf = door.leaves[0] == leaf ? door.leaves[1] : door.leaves[0];
  }
  const math::Vec3d last_world = way_world.back();
  const Box brushes{tree.box.mins + kRoomAround, tree.box.maxs - kRoomAround};
  if (glm::clamp(last_world, brushes.mins, brushes.maxs) != last_world) return way_world;
  std::optional<math::Vec3d> end_world;
  for (const LeafExit& exit : portals.exits) {
    if (exit.leaf != leaf) continue;
    const math::Vec3d point_world = find_nearest_point(exit, last_world);
    if (!end_world || glm::distance(point_world, last_world) < glm::distance(*end_world, last_world))
      end_world = point_world;
  }
  if (end_world) end_world = find_border(brushes, last_world, *end_world);
  if (end_world && *end_world != last_world) way_world.push_back(*end_world);
  return way_world;
}

}  // namespace

std::optional<Leak> fill_outside(Tree& io_tree, const PlaneSet& planes, const LeafPortals& portals,
                                 std::span<const math::Vec3d> occupants) {
  const Flood found = flood_from_outside(io_tree, planes, portals);
  if (const auto occupant = find_leaking_occupant(occupants, io_tree, planes, found)) {
    const math::Vec3d& from_world = occupants[*occupant];
    const auto leaves = find_leaves_around(from_world, kOnPlaneEpsilon, io_tree, planes);
    const std::uint32_t leaf =
        *std::ranges::find_if(leaves, [&](std::uint32_t near) { return bool{found.reached[near]}; });
    return Leak{*occupant, find_way_out(from_world, leaf, io_tree, portals, found)};
  }
  if (occupants.empty()) return std::nullopt;  // an ammunition box, for example, is all outside
  for (std::size_t leaf = 0; leaf < io_tree.leaves.size(); ++leaf)
    if (found.reached[leaf]) io_tree.leaves[leaf] = {Fill::kSolid, Fill::kSolid, {}};
  return std::nullopt;
}

void fill_pockets(Tree& io_tree, const PlaneSet& planes, const LeafPortals& portals,
                  std::span<const math::Vec3d> occupants, std::span<const Box> entity_brushes) {
  std::vector<std::uint32_t> first_leaves;
  const auto add = [&](const std::vector<std::uint32_t>& leaves) {
    first_leaves.insert(first_leaves.end(), leaves.begin(), leaves.end());
  };
  for (const math::Vec3d& occupant : occupants) add(find_leaves_around(occupant, kNear, io_tree, planes));
  for (const Box& box : entity_brushes) add(io_tree.leaves_touching(box, planes));
  const auto is_open = [&](std::uint32_t leaf) { return !is_sealed(io_tree.leaves[leaf]); };
  if (std::ranges::none_of(first_leaves, is_open)) return;
  const Flood found = flood_leaves(io_tree, planes, portals, first_leaves, 0);
  for (std::size_t leaf = 0; leaf < io_tree.leaves.size(); ++leaf)
    if (!found.reached[leaf] && !is_sealed(io_tree.leaves[leaf]))
      io_tree.leaves[leaf] = {Fill::kSolid, Fill::kSolid, {}};
}

}  // namespace temblor::compiler
