// Brushes as solids: the planes of their sides, the windings on those planes, and what fills them.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/bsp/planes.h"
#include "compiler/bsp/winding.h"
#include "compiler/report.h"
#include "formats/levels/map.h"

namespace temblor::compiler {

// The contents of a brush, from weak to strong: where two brushes overlap, the stronger one wins.
enum class Fill : std::uint8_t {
  kEmpty,        // air, and hint brushes
  kIllusionary,  // drawn, but not solid
  kVisBlocker,   // the same, and opaque to visibility
  kWater,
  kSlime,
  kLava,
  kFence,  // solid, but one sees through it
  kSky,
  kDetailWall,  // as kDetail, but does not cut the faces of others
  kDetail,      // solid, but it neither seals the level nor blocks visibility
  kSolid,
};
constexpr bool is_liquid(Fill fill) {
  return fill == Fill::kWater || fill == Fill::kSlime || fill == Fill::kLava;
}
// Solid: nothing can be inside it, and it makes no leaf of the level.
constexpr bool is_blocked(Fill fill) {
  return fill == Fill::kFence || fill == Fill::kDetailWall || fill == Fill::kDetail || fill == Fill::kSolid;
}
// Blocks visibility and the flood from outside.
constexpr bool is_opaque(Fill fill) {
  return fill == Fill::kSolid || fill == Fill::kSky;
}

// A side that is not drawn.
constexpr std::uint32_t kNoSurface = std::numeric_limits<std::uint32_t>::max();

// A side of a brush: a plane, and the polygon that the brush covers in it.
struct BrushSide {
  PlaneIndex plane;  // the brush is behind it
  // The surface to draw on it (LevelBrushes::surfaces); kNoSurface: none.
  std::uint32_t surface = kNoSurface;
  bool splits = true;  // false: makes no node (bevels, the other sides of hint brushes)
  bool is_seen_from_inside = false;
  Winding winding{};
};

// Bits of Brush::hulls. Hull 0 is drawn and stops points, hull 1 stops players, hull 2 stops large monsters.
constexpr std::uint8_t kDrawnHull = 1, kAllHulls = 7;
constexpr std::uint8_t hull_bit(std::size_t hull) {
  return static_cast<std::uint8_t>(1u << hull);
}

// A convex solid: everything that is behind all of its sides.
struct Brush {
  std::vector<BrushSide> sides;
  Box box;
  Fill fill = Fill::kSolid;
  bool is_detail = false;  // neither seals the level nor bounds a cluster
  // _noclipfaces: its faces are drawn also where other brushes with the same fill cover them.
  bool keeps_inner_faces = false;
  std::uint8_t hulls = kAllHulls;
  std::int32_t chop_order = 0;  // _chop_order: of two overlapping brushes, the higher one is drawn
};

// Where a brush is in the map's text, for messages.
struct BrushPlace {
  std::size_t entity = 0, brush = 0;  // from 0
  std::uint32_t line = 0;
};
// "entity 0, brush 12, line 345".
std::string describe(const BrushPlace& place);

// The planes and windings of a brush.
struct BrushSolid {
  std::vector<BrushSide> sides;
  std::vector<std::size_t> side_of;  // by side: its number in the map's brush
  Box box;
};
// Makes the solid of a brush, moved by `-origin_world`. Sides keep their order. Sides without area and
// duplicate sides are left out with a warning, sides that touch nothing without one. Returns nothing, with a
// warning, for a brush that has no volume or that is not closed.
std::optional<BrushSolid> make_solid(const formats::MapBrush& brush, const BrushPlace& place,
                                     const math::Vec3d& origin_world, PlaneSet& io_planes,
                                     Warnings& io_warnings);

// Makes windings from planes. Returns false if nothing is left between the planes or if the brush is not
// closed. Sides that touch nothing get an empty winding.
bool make_windings(std::span<BrushSide> io_sides, const PlaneSet& planes, Box& out_box);

}  // namespace temblor::compiler
