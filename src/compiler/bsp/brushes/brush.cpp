// Method: each side starts as a huge square in its plane and is clipped by the planes of all other sides.
// The rest of it is the side's winding. A brush is not closed if a winding still reaches the end of the
// world.
#include "compiler/bsp/brushes/brush.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace temblor::compiler {
namespace {

// Corners this near to whole coordinates are snapped to them.
constexpr double kSnapDistance = 0.002;

constexpr const char* kNoVolume =
    "brush without volume, or not closed, or more than 2^20 units from the origin";

// Editors and rounding leave corners slightly off the grid, which would make different planes and vertices of
// equal ones.
void snap(Winding& io_winding) {
  for (math::Vec3d& point : io_winding)
    for (int axis = 0; axis < 3; ++axis) {
      const double whole = std::round(point[axis]);
      if (std::abs(point[axis] - whole) < kSnapDistance) point[axis] = whole;
    }
}

}  // namespace

std::string describe(const BrushPlace& place) {
  return fmt::format("entity {}, brush {}, line {}", place.entity, place.brush, place.line);
}

bool make_windings(std::span<BrushSide> io_sides, const PlaneSet& planes, Box& out_box) {
  out_box = {};
  for (BrushSide& side : io_sides) {
    side.winding = make_base_winding(planes[side.plane]);
    for (const BrushSide& other : io_sides) {
      if (other.plane == side.plane) continue;
      cut_to_back(side.winding, planes[other.plane], false, 1e-6);
      if (side.winding.empty()) break;
    }
    if (is_tiny(side.winding)) side.winding.clear();
    snap(side.winding);
    out_box.add(side.winding);
  }
  if (out_box.is_empty()) return false;
  const double farthest = std::max(glm::length(out_box.mins), glm::length(out_box.maxs));
  return farthest < kWorldExtent;
}

std::optional<BrushSolid> make_solid(const formats::MapBrush& brush, const BrushPlace& place,
                                     const math::Vec3d& origin_world, PlaneSet& io_planes,
                                     Warnings& io_warnings) {
  BrushSolid solid;
  for (std::size_t i = 0; i < brush.sides.size(); ++i) {
    const auto& points = brush.sides[i].points_world;
    const math::Vec3d cross = glm::cross(points[0] - points[1], points[2] - points[1]);
    const double length = glm::length(cross);
    if (!(length > 1e-6)) {
      io_warnings.push_back(
          {"side without area, ignored",
           fmt::format("{}, side {}: its three points are on one line", describe(place), i)});
      continue;
    }
    const math::Vec3d normal = cross / length;
    const PlaneIndex plane = io_planes.find_or_add(normal, glm::dot(points[1] - origin_world, normal));
    const auto known = [&](const BrushSide& side) { return side.plane == plane; };
    if (std::any_of(solid.sides.begin(), solid.sides.end(), known)) {
      io_warnings.push_back({"duplicate side, ignored", fmt::format("{}, side {}", describe(place), i)});
      continue;
    }
    solid.sides.push_back({plane});
    solid.side_of.push_back(i);
  }
  if (solid.sides.size() < 4 || !make_windings(solid.sides, io_planes, solid.box)) {
    io_warnings.push_back({kNoVolume, describe(place)});
    return std::nullopt;
  }
  // Remove sides that touch nothing: redundant planes from the editor.
  std::size_t kept = 0;
  for (std::size_t i = 0; i < solid.sides.size(); ++i) {
    if (solid.sides[i].winding.empty()) continue;
    if (kept != i) {
      solid.sides[kept] = std::move(solid.sides[i]);
      solid.side_of[kept] = solid.side_of[i];
    }
    ++kept;
  }
  solid.sides.resize(kept);
  solid.side_of.resize(kept);
  if (kept < 4) {
    io_warnings.push_back({kNoVolume, describe(place)});
    return std::nullopt;
  }
  return solid;
}

}  // namespace temblor::compiler
