// A level script as data: what its lines placed where, in the level's coordinates.
//
//   level lines --read_level_script--> LevelScript --check_level_script--> --make_map--> formats::Map
//                                       |  spaces: air that is cut out of solid rock
//                                       |  structure, brush entities, rock, bands: solids in it
//                                       |  point entities
//
// A level script describes rooms as empty boxes, unlike a map, which consists of solid brushes; carve.h
// computes the brushes around the rooms. docs/level-scripts.md describes the language.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "artgen/level_script/shape.h"
#include "artgen/scripts/script.h"
#include "formats/levels/entities.h"
#include "math/vec.h"

namespace temblor::artgen {

// How a texture lies on the sides of a solid that face in one direction. It is aligned to the lower left
// corner of the anchor's side, as seen from the front.
struct Look {
  std::string texture;
  Box anchor;
  // Units per texel.
  math::Vec2d scale{1.0};
  // In texels.
  math::Vec2d shift{0.0};
  bool operator==(const Look&) const = default;
};
// Indexed by side_index.
using Looks = std::array<Look, 6>;

// The textures of a space as seen from inside, indexed by the side of the space that they are on.
using Surfaces = std::array<std::string, 6>;

// A convex solid, which becomes one brush.
struct Solid {
  // Its convex hull is the solid.
  std::vector<Point> corners;
  Looks looks;
  std::int32_t line = 0;
};

// An entity and the solids that become its brushes.
struct BrushEntity {
  formats::Entity fields;
  std::vector<Solid> solids;
};

// A box of air. Everything outside all spaces is solid rock.
struct Space {
  Box box;
  // Indexed by the side of the space.
  Looks walls;
  std::int32_t line = 0;
};

// The context of a line: coordinates are relative to the lower corner of the room, group, or opening around
// it.
struct Scope {
  Placement placement;
  // The size of the room; 0 for lines that are not in a room.
  Point size{0};
  // The textures that lines inherit.
  Surfaces surfaces;
  // Replaces each $ in names, so that copies of a group have different names.
  std::string copy;

  Box bounds() const { return {Point(0), size}; }
};

// A named room, for openings that refer to it.
struct Room {
  Scope scope;
  // In the level's coordinates.
  Box box;
};

// An entity without brushes, and the free space that it needs.
struct PointEntity {
  formats::Entity fields;
  Point origin{0};
  // Must be empty of solids. Without a volume: only the origin must be in the open.
  Box clearance;
  std::int32_t line = 0;
  std::string keyword;
};

// Rock that bulges into a space from one side. It is made after all spaces are known, because it leaves
// openings free.
struct RockFace {
  // The space.
  Box box;
  Side side = Side::kDown;
  std::string texture, ledge_texture;
  // The size of its facets and the largest bulge, in units.
  int cell = 64, rough = 48;
  // The height of layers, which alternate between the two textures and differ in how far they protrude; 0: no
  // layers.
  int layer_height = 0;
  std::string layer_texture;
  double scale = 1;
  std::uint64_t seed = 0;
  std::int32_t line = 0;
};

// A strip along a wall of a space, interrupted at openings.
struct Band {
  // The space.
  Box box;
  Side side = Side::kNorth;
  // Heights in the level's coordinates.
  int low = 0, high = 0;
  // How far it protrudes from the wall.
  int depth = 4;
  std::string texture;
  std::int32_t line = 0;
};

// Everything that a level's lines describe.
struct LevelScript {
  std::string name;
  formats::Entity world;
  std::vector<Space> spaces;
  // Without worldspawn, whose solids are in `structure`.
  std::vector<BrushEntity> brush_entities;
  std::vector<Solid> structure;
  std::vector<PointEntity> point_entities;
  std::vector<RockFace> rock_faces;
  std::vector<Band> bands;
  std::map<std::string, Room> rooms;
  // By name. The lines belong to the parsed script, which must outlive this.
  std::map<std::string, const ScriptLine*> groups;
  // The number of names made up so far, for entities that need unique ones.
  std::int32_t generated_names = 0;
};

// The look of each side, aligned to `anchor`.
Looks make_looks(const Surfaces& surfaces, const Box& anchor);
// The same texture on all sides.
Looks make_uniform_looks(std::string_view texture, const Box& anchor);
Surfaces make_uniform_surfaces(std::string_view texture);

}  // namespace temblor::artgen
