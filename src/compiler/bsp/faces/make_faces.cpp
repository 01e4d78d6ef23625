#include <algorithm>

#include "compiler/bsp/faces/faces.h"

namespace temblor::compiler {
namespace {

const BrushSide* side_in(const Brush& brush, PlaneIndex plane) {
  for (const BrushSide& side : brush.sides)
    if (side.plane == plane) return &side;
  return nullptr;
}

// Of the brush that shows in a leaf; null where none of its sides lies in the plane.
const BrushSide* shown_side(const TreeLeaf& filled, PlaneIndex plane, std::span<const Brush> brushes) {
  for (const std::uint32_t number : filled.brushes) {
    if (brushes[number].fill != filled.fill) continue;
    if (const BrushSide* const side = side_in(brushes[number], plane)) return side;
  }
  return nullptr;
}

bool has_fill(const TreeLeaf& leaf, Fill fill, std::span<const Brush> brushes) {
  return std::ranges::any_of(leaf.brushes,
                             [&](std::uint32_t number) { return brushes[number].fill == fill; });
}

// Of a brush that begins between two leaves of one fill and shows there all the same: it asks to, or it is
// illusionary, in a liquid.
const BrushSide* inner_side(const TreeLeaf& here, const TreeLeaf& there, PlaneIndex towards_viewer,
                            std::span<const Brush> brushes) {
  for (const std::uint32_t number : there.brushes) {
    const Brush& brush = brushes[number];
    const bool asks = brush.keeps_inner_faces && brush.fill == there.fill;
    const bool is_sunk = brush.fill == Fill::kIllusionary && is_liquid(there.fill);
    if (!asks && !is_sunk) continue;
    const bool goes_on = brush.keeps_inner_faces
                             ? std::ranges::find(here.brushes, number) != here.brushes.end()
                             : has_fill(here, brush.fill, brushes);
    if (goes_on) continue;
    if (const BrushSide* const side = side_in(brush, towards_viewer)) return side;
  }
  return nullptr;
}

const BrushSide* if_seen_from_inside(const BrushSide* side) {
  return side != nullptr && side->is_seen_from_inside ? side : nullptr;
}

// Nobody looks out of what is solid or sky. Of a fence somebody may look through its holes; and what a detail
// wall covers is made like the rest, so that it is one face with it.
bool has_viewers(Fill fill) {
  return fill == Fill::kFence || fill == Fill::kDetailWall || (!is_blocked(fill) && fill != Fill::kSky);
}

}  // namespace

std::uint32_t surface_between(const TreeLeaf& here, const TreeLeaf& there, PlaneIndex towards_viewer,
                              std::span<const Brush> brushes) {
  if (!has_viewers(here.fill)) return kNoSurface;
  const PlaneIndex away = turned(towards_viewer);
  const BrushSide* side = nullptr;
  if (here.fill == there.fill) {
    side = inner_side(here, there, towards_viewer, brushes);
    if (side == nullptr) side = if_seen_from_inside(inner_side(there, here, away, brushes));
  } else if (there.fill > here.fill) {
    side = shown_side(there, towards_viewer, brushes);
  } else {
    side = if_seen_from_inside(shown_side(here, away, brushes));
  }
  return side != nullptr ? side->surface : kNoSurface;
}

std::vector<TreeFace> make_faces(const Tree& tree, std::span<const LeafPortal> portals,
                                 std::span<const Brush> brushes) {
  std::vector<TreeFace> faces;
  for (const LeafPortal& portal : portals) {
    const PlaneIndex plane = tree.nodes[portal.node].plane;
    for (const bool from_behind : {false, true}) {
      const std::uint32_t viewer = portal.leaves[from_behind ? 1 : 0],
                          seen = portal.leaves[from_behind ? 0 : 1];
      const PlaneIndex towards_viewer = from_behind ? turned(plane) : plane;
      const std::uint32_t surface =
          surface_between(tree.leaves[viewer], tree.leaves[seen], towards_viewer, brushes);
      if (surface == kNoSurface) continue;
      Winding winding = portal.winding;
      if (from_behind) winding.assign(portal.winding.rbegin(), portal.winding.rend());
      faces.push_back({std::move(winding), towards_viewer, surface, portal.node, {viewer}});
    }
  }
  return faces;
}

}  // namespace temblor::compiler
