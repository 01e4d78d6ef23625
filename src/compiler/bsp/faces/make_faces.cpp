#include <algorithm>

#include "compiler/bsp/faces/faces.h"

namespace temblor::compiler {
namespace {

const BrushSide* find_side_in(const Brush& brush, PlaneIndex plane) {
  for (const BrushSide& side : brush.sides)
    if (side.plane == plane) return &side;
  return nullptr;
}

// The side of the brush whose texture shows in a leaf; null if none of its sides is in the plane.
const BrushSide* find_shown_side(const TreeLeaf& filled, PlaneIndex plane, std::span<const Brush> brushes) {
  for (const std::uint32_t number : filled.brushes) {
    if (brushes[number].fill != filled.fill) continue;
    if (const BrushSide* const side = find_side_in(brushes[number], plane)) return side;
  }
  return nullptr;
}

bool has_fill(const TreeLeaf& leaf, Fill fill, std::span<const Brush> brushes) {
  return std::ranges::any_of(leaf.brushes,
                             [&](std::uint32_t number) { return brushes[number].fill == fill; });
}

// The side of a brush that begins between two leaves with the same fill and is still visible: because of
// _noclipfaces, or because it is illusionary and inside a liquid.
const BrushSide* find_inner_side(const TreeLeaf& here, const TreeLeaf& there, PlaneIndex toward_viewer,
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
    if (const BrushSide* const side = find_side_in(brush, toward_viewer)) return side;
  }
  return nullptr;
}

const BrushSide* keep_if_seen_from_inside(const BrushSide* side) {
  return side != nullptr && side->is_seen_from_inside ? side : nullptr;
}

// Whether one can look out of a leaf. Nothing looks out of solid or sky. One can look through the holes of a
// fence; and what a detail wall covers gets a face like the rest, so that both become one face.
bool has_viewers(Fill fill) {
  return fill == Fill::kFence || fill == Fill::kDetailWall || (!is_blocked(fill) && fill != Fill::kSky);
}

}  // namespace

// The stronger fill shows its side. If the weaker one is on the far side, it shows its back, but only if it
// is drawn from the inside (liquids, _mirrorinside).
std::uint32_t find_surface_between(const TreeLeaf& here, const TreeLeaf& there, PlaneIndex toward_viewer,
                                   std::span<const Brush> brushes) {
  if (!has_viewers(here.fill)) return kNoSurface;
  const PlaneIndex away = flipped(toward_viewer);
  const BrushSide* side = nullptr;
  if (here.fill == there.fill) {
    side = find_inner_side(here, there, toward_viewer, brushes);
    if (side == nullptr) side = keep_if_seen_from_inside(find_inner_side(there, here, away, brushes));
  } else if (there.fill > here.fill) {
    side = find_shown_side(there, toward_viewer, brushes);
  } else {
    side = keep_if_seen_from_inside(find_shown_side(here, away, brushes));
  }
  return side != nullptr ? side->surface : kNoSurface;
}

// Both directions of a portal may show something: liquids are seen from above and from below.
std::vector<TreeFace> make_faces(const Tree& tree, std::span<const LeafPortal> portals,
                                 std::span<const Brush> brushes) {
  std::vector<TreeFace> faces;
  for (const LeafPortal& portal : portals) {
    const PlaneIndex plane = tree.nodes[portal.node].plane;
    for (const bool from_behind : {false, true}) {
      const std::uint32_t viewer = portal.leaves[from_behind ? 1 : 0],
                          seen = portal.leaves[from_behind ? 0 : 1];
      const PlaneIndex toward_viewer = from_behind ? flipped(plane) : plane;
      const std::uint32_t surface =
          find_surface_between(tree.leaves[viewer], tree.leaves[seen], toward_viewer, brushes);
      if (surface == kNoSurface) continue;
      Winding winding = portal.winding;
      if (from_behind) winding.assign(portal.winding.rbegin(), portal.winding.rend());
      faces.push_back({std::move(winding), toward_viewer, surface, portal.node, {viewer}});
    }
  }
  return faces;
}

}  // namespace temblor::compiler
