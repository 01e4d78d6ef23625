#include "compiler/bsp/faces.h"

namespace temblor::compiler {
namespace {

// What is seen of `filled` through its plane's front; `plane` faces the viewer.
std::uint32_t surface_of(const TreeLeaf& filled, PlaneIndex plane, std::span<const Brush> brushes) {
  for (const std::uint32_t number : filled.brushes) {
    const Brush& brush = brushes[number];
    if (brush.fill != filled.fill) continue;
    for (const BrushSide& side : brush.sides)
      if (side.plane == plane) return side.surface;
  }
  return kNoSurface;
}

// Nobody looks out of what is solid or sky. Of a fence somebody may look through its holes.
bool has_viewers(Fill fill) {
  return fill == Fill::kFence || (!is_blocked(fill) && fill != Fill::kSky);
}

}  // namespace

std::vector<TreeFace> make_faces(const Tree& tree, std::span<const LeafPortal> portals,
                                 std::span<const Brush> brushes) {
  std::vector<TreeFace> faces;
  for (const LeafPortal& portal : portals) {
    const PlaneIndex plane = tree.nodes[portal.node].plane;
    for (const bool from_behind : {false, true}) {
      const std::uint32_t viewer = portal.leafs[from_behind ? 1 : 0],
                          seen = portal.leafs[from_behind ? 0 : 1];
      const TreeLeaf &here = tree.leafs[viewer], &there = tree.leafs[seen];
      if (here.fill == there.fill || !has_viewers(here.fill)) continue;
      const PlaneIndex towards_viewer = from_behind ? turned(plane) : plane;
      std::uint32_t surface = kNoSurface;
      if (there.fill > here.fill)
        surface = surface_of(there, towards_viewer, brushes);
      else if (is_liquid(here.fill))
        surface = surface_of(here, turned(towards_viewer), brushes);  // the same face, from inside
      if (surface == kNoSurface) continue;
      Winding winding = portal.winding;
      if (from_behind) winding.assign(portal.winding.rbegin(), portal.winding.rend());
      faces.push_back({std::move(winding), towards_viewer, surface, portal.node, {viewer}});
    }
  }
  return faces;
}

}  // namespace temblor::compiler
