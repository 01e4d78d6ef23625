// The keywords of level scripts, in families, and the functions that their readers share. A reader adds what
// its line describes to the level script; docs/level-scripts.md describes all keywords.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "artgen/level_script/level_script.h"
#include "artgen/level_script/level_script_line.h"
#include "artgen/scripts/script.h"
#include "base/result.h"

namespace temblor::artgen {

// A keyword and its reader. `scope` is the context of the line.
struct LevelKeyword {
  std::string_view name;
  base::Status (*read)(const ScriptLine& line, const Scope& scope, LevelScript& io_script);
};
// Rooms, hollows, passages, openings, groups.
std::span<const LevelKeyword> space_keywords();
// Blocks, stairs, pillars, arches, liquids.
std::span<const LevelKeyword> solid_keywords();
// Caves, boulders, crystals, bands along walls.
std::span<const LevelKeyword> rock_keywords();
// Doors, lifts, trains, buttons, triggers.
std::span<const LevelKeyword> mover_keywords();
// Lights, monsters, items, starts.
std::span<const LevelKeyword> entity_keywords();

// Registers the groups among the level's own lines, so that lines above a group can place it.
base::Status collect_groups(const std::vector<ScriptLine>& lines, LevelScript& io_script);

// Reads the lines of a scope in their order; stops at the first error.
base::Status read_lines(const std::vector<ScriptLine>& lines, const Scope& scope, LevelScript& io_script);

// The convex hull of corners in the line's scope, as a solid of the level.
Solid make_solid(const LevelScriptLine& line, std::vector<Point> corners, const Looks& looks);
Solid make_solid(const LevelScriptLine& line, const Box& box, const Looks& looks);

// Adds solids as the line's as= says: world, detail, fence, ghost (visible but not solid), or wall (an
// entity). Without as=, textures with holes make fences, liquids belong to the world, and everything else is
// `fallback`. The line's compiler keys, such as _phong, are copied.
void add_solids(LevelScriptLine& line, std::vector<Solid> solids, std::string_view fallback,
                LevelScript& io_script);

// Makes an entity with the settings that all entities accept: name= (targetname), target=, message=, wait=,
// and so on, and keys that begin with an underscore. skill=easy,normal,hard and dm=no become spawnflags, in
// addition to `flags`.
formats::Entity make_entity(LevelScriptLine& line, std::string_view classname, int flags = 0);
// Sets or replaces a key. Points are written as "X Y Z".
void set_key(formats::Entity& io_entity, std::string_view key, std::string_view value);
void set_key(formats::Entity& io_entity, std::string_view key, Point position);
void set_key(formats::Entity& io_entity, std::string_view key, double value);

// Adds a brush entity; entities keep the order of the script.
void add_brush_entity(formats::Entity fields, std::vector<Solid> solids, LevelScript& io_script);

// The value of the key "angle" for a movement: degrees, -1 for up, -2 for down.
double find_move_angle(const LevelScriptLine& line, Side direction);

}  // namespace temblor::artgen
