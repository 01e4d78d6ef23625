// A plan as data: what its lines have put where, in the level's coordinates.
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

// How a texture lies on those sides of a solid that face one way. From the left end of the anchor's side and
// from its bottom, seen from in front.
struct Look {
  std::string texture;
  Box anchor;
  math::Vec2d scale{1.0};  // units a texel
  math::Vec2d shift{0.0};  // texels
  bool operator==(const Look&) const = default;
};
using Looks = std::array<Look, 6>;  // by Side

// Textures as seen from inside a space: by the side of it that they are on.
using Surfaces = std::array<std::string, 6>;

struct Solid {
  std::vector<Point> corners;  // their convex hull
  Looks looks;
  std::int32_t line = 0;
};

// An entity with the solids that are its brushes.
struct Body {
  formats::Entity fields;
  std::vector<Solid> solids;
};

// Air, cut out of endless rock.
struct Space {
  Box box;
  Looks walls;  // by the side of the space
  std::int32_t line = 0;
};

// Where lines stand: coordinates are the room's own, from its lower corner.
struct Scope {
  Placement placement;
  Point size{0};  // of the room; 0 at the level's own lines
  Surfaces surfaces;
  std::string copy;  // what stands for a $ in names

  Box whole() const { return {Point(0), size}; }
};

struct Room {
  Scope scope;
  Box box;  // in the level
};

// What has a place but no brushes, and the room that it needs there.
struct Thing {
  formats::Entity fields;
  Point origin{0};
  Box needs;  // without a volume: only the origin must be in the open
  std::int32_t line = 0;
  std::string word;
};

// Rock that bulges into a space; made when all openings are known.
struct RockFace {
  Box box;  // the space
  Side side = Side::kDown;
  std::string texture, ledge_texture;
  int cell = 64, rough = 48;
  double scale = 1;
  std::uint64_t seed = 0;
  std::int32_t line = 0;
};

// A strip along the walls of a space, left out where other spaces open.
struct Band {
  Box box;  // the space
  Side side = Side::kNorth;
  int low = 0, high = 0;  // of the level
  int depth = 4;
  std::string texture;
  std::int32_t line = 0;
};

struct Plan {
  std::string name;
  formats::Entity world;
  std::vector<Space> spaces;
  std::vector<Body> bodies;  // without worldspawn's: its solids are in `structure`
  std::vector<Solid> structure;
  std::vector<Thing> things;
  std::vector<RockFace> rock_faces;
  std::vector<Band> bands;
  std::map<std::string, Room> rooms;
  std::map<std::string, const ScriptLine*> groups;  // the script outlives the plan
  std::int32_t names_given = 0;                     // to what needs a name of its own
};

Looks looks_of(const Surfaces& surfaces, const Box& anchor);
Looks looks_all(std::string_view texture, const Box& anchor);
Surfaces surfaces_all(std::string_view texture);

}  // namespace temblor::artgen
