// The words of plans, in families, and what their readers share.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "artgen/level_script/plan.h"
#include "artgen/level_script/plan_line.h"
#include "artgen/scripts/script.h"
#include "base/result.h"

namespace temblor::artgen {

struct PlanWord {
  std::string_view name;
  base::Status (*read)(const ScriptLine& line, const Scope& scope, Plan& io_plan);
};
std::span<const PlanWord> space_words();  // rooms, passages, openings, groups
std::span<const PlanWord> solid_words();  // blocks, stairs, pillars, arches, liquids
std::span<const PlanWord> rock_words();   // caves, boulders, crystals, bands along walls
std::span<const PlanWord> mover_words();  // doors, lifts, trains, buttons, triggers
std::span<const PlanWord> thing_words();  // lights, monsters, items, starts

// The groups among the level's own lines, which may stand below those that place them.
base::Status collect_groups(const std::vector<ScriptLine>& lines, Plan& io_plan);

// The lines of one scope, in order.
base::Status read_lines(const std::vector<ScriptLine>& lines, const Scope& scope, Plan& io_plan);

// The solid that these corners (of the scope) span.
Solid solid_of(const PlanLine& line, std::vector<Point> corners, const Looks& looks);
Solid solid_of(const PlanLine& line, const Box& box, const Looks& looks);

// Puts solids into the level as the line's as= says: world, detail, fence, ghost (seen, not felt) or wall (an
// entity). Unless it says, fences are of textures with holes, the world of liquids, and all else `otherwise`.
// Keys of light (_phong and so on) are taken from the line.
void put_solids(PlanLine& line, std::vector<Solid> solids, std::string_view otherwise, Plan& io_plan);

// Keys that all entities share: name= (targetname), target=, message=, wait= ... and those that begin with an
// underscore; skill=easy,normal,hard and dm=no become spawnflags, to which `flags` are added.
formats::Entity entity_of(PlanLine& line, std::string_view classname, int flags = 0);
void set_key(formats::Entity& io_entity, std::string_view key, std::string_view value);
void set_key(formats::Entity& io_entity, std::string_view key, Point place);
void set_key(formats::Entity& io_entity, std::string_view key, double value);

// An entity of brushes: it keeps its place in the plan.
void put_body(formats::Entity fields, std::vector<Solid> solids, Plan& io_plan);

// The key "angle" of what moves that way: -1 up, -2 down.
double move_angle(const PlanLine& line, Side way);

}  // namespace temblor::artgen
