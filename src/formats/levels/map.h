// Level sources (.map), the text of level editors: entities with their brushes. A brush is the solid behind
// all of its sides; a side is a plane through three points, with a texture. Reads the three kinds of texture
// alignment, also mixed, as QuakeEd, Worldcraft, TrenchBroom, J.A.C.K., and (Net)Radiant write them:
//
//   {
//   "classname" "worldspawn"
//   {                                                    a brush: one line for each side
//   POINT POINT POINT TEXTURE s_offset t_offset rotation s_scale t_scale                    standard
//   POINT POINT POINT TEXTURE [ S_AXIS s_offset ] [ T_AXIS t_offset ] rotation s_scale t_scale
//   }                                                                                       Valve 220
//   {
//   brushDef
//   {
//   POINT POINT POINT ( ( sx sy s0 ) ( tx ty t0 ) ) TEXTURE                                 brush primitives
//   }
//   }
//   }                                                    POINT: ( x y z )      AXIS: x y z
//
// Some dialects append three numbers to a side: contents, surface flags, and a value.
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

// How a side's texture is aligned: which fields of MapTexturing count.
enum class MapAlignment : std::uint8_t { kStandard, kValve, kBrushPrimitive };

// Texture alignment of a side, as in the text; the compiler computes texture axes from it.
struct MapTexturing {
  MapAlignment alignment = MapAlignment::kStandard;
  math::Vec2d offset{0.0};               // texels
  double rotation_deg = 0;               // Valve: the axes include the rotation
  math::Vec2d scale{1.0};                // units per texel; 0 in a file means 1
  math::Vec3d s_axis{0.0}, t_axis{0.0};  // Valve
  // Brush primitives: rows s and t, applied to (x, y, 1) on the side.
  std::array<std::array<double, 3>, 2> matrix{};
  bool operator==(const MapTexturing&) const = default;
};

// Contents, surface flags, and value, which some dialects append to a side.
using MapSideFlags = std::array<std::int32_t, 3>;

// A half space. The brush is behind the plane through three points, which are in clockwise order seen from
// the front: the normal is along cross(points[0] - points[1], points[2] - points[1]). The points may be
// collinear; the compiler checks that.
struct MapSide {
  std::array<math::Vec3d, 3> points_world{};
  std::string texture;
  MapTexturing texturing;
  std::optional<MapSideFlags> flags{};
  std::uint32_t line = 0;  // in the text, from 1
  bool operator==(const MapSide&) const = default;
};

// A convex solid, or the volume of a trigger or door.
struct MapBrush {
  std::vector<MapSide> sides;
  std::uint32_t line = 0;  // of its opening brace
  bool operator==(const MapBrush&) const = default;
};

// An entity; one with brushes is the world, or becomes a brush model.
struct MapEntity {
  Entity fields;
  std::vector<MapBrush> brushes;
  std::uint32_t line = 0;  // of its opening brace
  bool operator==(const MapEntity&) const = default;
};

struct Map {
  std::vector<MapEntity> entities;  // in file order; editors write worldspawn first
  bool operator==(const Map&) const = default;
};

// Parses a .map text. Comments (// and ;) run to the end of the line; all line ends are accepted; the text
// ends at its first zero byte. All numbers are finite, and coordinates within +-kMapMaxCoordinate. Skips
// patches (patchDef2, patchDef3). Replaces \" inside of an entity's value with ', because the entity text of
// a level cannot contain quotes. Errors name the line, and the entity and brush counted from 0, as in the
// comments of editors.
constexpr double kMapMaxCoordinate = 1 << 24;
base::Result<Map> read_map(std::string_view text);

// Writes a map that reads back equal, except for line numbers. Keys, values, and names must not contain
// quotes, line breaks, or zero bytes, and all numbers must be finite.
std::string write_map(const Map& map);

}  // namespace temblor::formats
