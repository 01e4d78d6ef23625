// .map: the text that level editors write, entities with their brushes. Standard, Valve 220 and
// brush-primitive texture alignment, also mixed; as QuakeEd, Worldcraft, TrenchBroom, J.A.C.K. and
// (Net)Radiant write them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "formats/levels/entities.h"
#include "math/vec.h"

namespace temblor::formats {

enum class MapAlignment : std::uint8_t { kStandard, kValve, kBrushPrimitive };

// How a texture lies on a side: what the text says, not yet texture axes.
struct MapTexturing {
  MapAlignment alignment = MapAlignment::kStandard;
  math::Vec2d offset{0.0};               // texels
  double rotation_deg = 0;               // Valve: the axes are turned already
  math::Vec2d scale{1.0};                // units a texel; 0 in a file means 1
  math::Vec3d s_axis{0.0}, t_axis{0.0};  // Valve
  std::array<std::array<double, 3>, 2>
      matrix{};  // brush primitives: s and t, of the side's own two axes and 1
  bool operator==(const MapTexturing&) const = default;
};

// Contents, surface flags and value, which some dialects write behind a side.
using MapSideFlags = std::array<std::int32_t, 3>;

// The brush lies behind the plane through three points, which run clockwise seen from in front of it: its
// normal points along cross(points[0] - points[1], points[2] - points[1]). Whether they span a plane is not
// looked at here.
struct MapSide {
  std::array<math::Vec3d, 3> points_world{};
  std::string texture;
  MapTexturing texturing;
  std::optional<MapSideFlags> flags{};
  std::uint32_t line = 0;  // in the text, from 1
  bool operator==(const MapSide&) const = default;
};

struct MapBrush {
  std::vector<MapSide> sides;
  std::uint32_t line = 0;  // of its opening brace
  bool operator==(const MapBrush&) const = default;
};

struct MapEntity {
  Entity fields;
  std::vector<MapBrush> brushes;
  std::uint32_t line = 0;  // of its opening brace
  bool operator==(const MapEntity&) const = default;
};

struct Map {
  std::vector<MapEntity> entities;  // in file order; the first is worldspawn in whatever editors write
  bool operator==(const Map&) const = default;
};

// Comments (// and ;) run to the end of the line; lines end as they like; the text ends at its first zero
// byte. Every number is finite and every coordinate within +-kMapMaxCoordinate. Patches (patchDef2,
// patchDef3) are read over. A \" within an entity's value becomes ', because no level's entity text can hold
// a quote. Errors name entity and brush, counted from 0 as in the comments that editors write, and line.
constexpr double kMapMaxCoordinate = 1 << 24;
base::Result<Map> read_map(std::string_view text);

// Reads back equal, but for lines, where keys, values and names hold no quote, line break or zero byte, and
// every number is finite.
std::string write_map(const Map& map);

}  // namespace temblor::formats
