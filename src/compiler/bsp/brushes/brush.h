// Brushes as solids: planes, windings, and what fills them.
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

// From what gives way to what stays where two overlap.
enum class Fill : std::uint8_t {
  kEmpty,        // hint brushes, and no brush at all
  kIllusionary,  // drawn, but nothing to stand on
  kVisBlocker,   // the same, and sight ends at it
  kWater,
  kSlime,
  kLava,
  kFence,  // solid, but seen through
  kSky,
  kDetailWall,  // as kDetail, but cuts no faces of others
  kDetail,      // solid, but neither seals nor hides
  kSolid,
};
constexpr bool is_liquid(Fill fill) {
  return fill == Fill::kWater || fill == Fill::kSlime || fill == Fill::kLava;
}
// Nobody stands in it, and no leaf is made of it.
constexpr bool is_blocked(Fill fill) {
  return fill == Fill::kFence || fill == Fill::kDetailWall || fill == Fill::kDetail || fill == Fill::kSolid;
}
// What sight and a flood from outside end at.
constexpr bool is_opaque(Fill fill) {
  return fill == Fill::kSolid || fill == Fill::kSky;
}

constexpr std::uint32_t kNoSurface = std::numeric_limits<std::uint32_t>::max();

struct BrushSide {
  PlaneIndex plane;  // the brush lies behind it
  // What is drawn on it, as whoever makes faces numbers it; kNoSurface: nothing.
  std::uint32_t surface = kNoSurface;
  bool splits = true;  // false: no node is made for it (bevels, hint brushes' other sides)
  bool is_seen_from_inside = false;
  Winding winding{};
};

// Bits of Brush::hulls: what is drawn and stops points; what stops players; what stops large monsters.
constexpr std::uint8_t kDrawnHull = 1, kAllHulls = 7;
constexpr std::uint8_t hull_bit(std::size_t hull) {
  return static_cast<std::uint8_t>(1u << hull);
}

struct Brush {
  std::vector<BrushSide> sides;
  Box box;
  Fill fill = Fill::kSolid;
  bool is_detail = false;          // neither seals nor bounds what is seen together
  bool keeps_inner_faces = false;  // where another one of its fill touches it or reaches into it
  std::uint8_t hulls = kAllHulls;
  std::int32_t chop_order = 0;  // of two alike, the one with the higher shows
};

// Where a brush stands in the text, for warnings.
struct BrushPlace {
  std::size_t entity = 0, brush = 0;  // from 0
  std::uint32_t line = 0;
};
std::string describe(const BrushPlace& place);

// The planes and windings of a brush, moved by `-origin_world`; sides keep their order, and side_of says
// which of the map's each comes from. Nothing, and a warning, for one that has no volume or no end. Sides
// without area, double ones and those that touch nothing are left out.
struct BrushSolid {
  std::vector<BrushSide> sides;
  std::vector<std::size_t> side_of;
  Box box;
};
std::optional<BrushSolid> make_solid(const formats::MapBrush& brush, const BrushPlace& place,
                                     const math::Vec3d& origin_world, PlaneSet& io_planes,
                                     Warnings& io_warnings);

// Windings from planes; false when nothing is left between them, or when it has no end. Sides that touch
// nothing keep an empty winding.
bool make_windings(std::span<BrushSide> io_sides, const PlaneSet& planes, Box& out_box);

}  // namespace temblor::compiler
