#include "artgen/level_script/plan_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "artgen/level_script/carve.h"
#include "artgen/level_script/rock.h"
#include "artgen/level_script/words.h"
#include "base/text.h"

namespace temblor::artgen {
namespace {

struct TextureAxes {
  math::Vec3d s, t;
};

// To the right and down, seen from in front; on floors to the east and south, on ceilings too.
TextureAxes axes_seen(Side side) {
  switch (side) {
    case Side::kEast:
      return {{0, 1, 0}, {0, 0, -1}};
    case Side::kWest:
      return {{0, -1, 0}, {0, 0, -1}};
    case Side::kNorth:
      return {{-1, 0, 0}, {0, 0, -1}};
    case Side::kSouth:
      return {{1, 0, 0}, {0, 0, -1}};
    default:
      return {{1, 0, 0}, {0, -1, 0}};
  }
}

// The texel that lies at the anchor's left lower end is the picture's own.
formats::MapTexturing texturing_of(const Look& look, Side side) {
  const TextureAxes axes = axes_seen(side);
  double left = std::numeric_limits<double>::max(), bottom = std::numeric_limits<double>::lowest();
  for (const Point& corner : corners_of(look.anchor)) {
    left = std::min(left, glm::dot(math::Vec3d(corner), axes.s));
    bottom = std::max(bottom, glm::dot(math::Vec3d(corner), axes.t));
  }
  formats::MapTexturing texturing;
  texturing.alignment = formats::MapAlignment::kValve;
  texturing.s_axis = axes.s;
  texturing.t_axis = axes.t;
  texturing.scale = look.scale;
  // A common multiple of textures' sizes: fewer ways to lie, which levels can hold 4096 of.
  constexpr double kTurn = 768;
  const math::Vec2d offset(look.shift.x - left / look.scale.x, look.shift.y - bottom / look.scale.y);
  texturing.offset = {offset.x - kTurn * std::floor(offset.x / kTurn),
                      offset.y - kTurn * std::floor(offset.y / kTurn)};
  return texturing;
}

formats::MapBrush brush_of(const Solid& solid) {
  formats::MapBrush brush;
  for (const HullSide& side : hull_of(solid.corners)) {
    const Side like = side_like(side.normal);
    const Look& look = solid.looks[index_of(like)];
    formats::MapSide out;
    for (std::size_t i = 0; i < 3; ++i) out.points_world[i] = math::Vec3d(side.points[i]);
    out.texture = look.texture;
    out.texturing = texturing_of(look, like);
    brush.sides.push_back(std::move(out));
  }
  return brush;
}

formats::MapEntity entity_with(formats::Entity fields, const std::vector<Solid>& solids) {
  formats::MapEntity entity{std::move(fields), {}};
  for (const Solid& solid : solids) {
    formats::MapBrush brush = brush_of(solid);
    if (!brush.sides.empty()) entity.brushes.push_back(std::move(brush));
  }
  return entity;
}

std::vector<Solid> rock_of(const Plan& plan) {
  std::vector<Solid> rock;
  for (const RockFace& face : plan.rock_faces)
    for (Solid& solid : make_rock(face, plan.spaces)) rock.push_back(std::move(solid));
  return rock;
}

std::vector<Solid> bands_of(const Plan& plan) {
  std::vector<Solid> bands;
  for (const Band& band : plan.bands)
    for (Solid& solid : make_band(band, plan.spaces)) bands.push_back(std::move(solid));
  return bands;
}

formats::Entity detail_with(std::string_view key, std::string_view value) {
  formats::Entity entity;
  set_key(entity, "classname", "func_detail");
  if (!key.empty()) set_key(entity, key, value);
  return entity;
}

// Surfaces unless rooms say, and what the level as a whole is told.
base::Status read_level_line(const ScriptLine& level, const Scope& outside, Plan& io_plan, Scope& out_scope) {
  PlanLine line(level, outside);
  io_plan.name = line.word();
  set_key(io_plan.world, "classname", "worldspawn");
  set_key(io_plan.world, "mapversion", "220");
  if (const std::optional<std::string> title = line.word_if_there())
    set_key(io_plan.world, "message", std::string_view(*title));
  out_scope.surfaces = line.surfaces({});
  if (line.has("music")) set_key(io_plan.world, "sounds", line.whole("music", 0, 0, 255));
  for (const auto& [key, value] : level.settings) {
    constexpr std::array<std::string_view, 8> kKnown = {"light", "worldtype",  "fog",   "sky",
                                                        "wad",   "wateralpha", "speed", "gravity"};
    if (key.starts_with('_') || std::find(kKnown.begin(), kKnown.end(), key) != kKnown.end())
      set_key(io_plan.world, key, line.text(key, ""));
  }
  const bool good =
      !io_plan.name.empty() && io_plan.name.size() <= 32 &&
      io_plan.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
  if (!good) line.complain("a level's name is up to 32 small letters, digits and _");
  return line.finish();
}

// Solids as they are asked for by what stands among them.
struct Obstacle {
  std::vector<HullSide> hull;
  Box bounds;
  std::int32_t line = 0;
  std::string texture;
};

bool is_in_the_way(const Body& body) {
  const std::string_view classname = body.fields.classname();
  return !classname.starts_with("trigger") && classname != "func_detail_illusionary" &&
         classname != "func_illusionary" && classname != "func_plat" && classname != "func_train";
}

std::vector<Obstacle> obstacles_of(const Plan& plan) {
  std::vector<Obstacle> obstacles;
  const auto add = [&](const std::vector<Solid>& solids) {
    for (const Solid& solid : solids) {
      const std::string& texture = solid.looks.front().texture;
      if (texture.starts_with('*') || solid.corners.empty()) continue;
      obstacles.push_back({hull_of(solid.corners), bounds_of(solid.corners), solid.line, texture});
    }
  };
  add(plan.structure);
  add(rock_of(plan));
  for (const Body& body : plan.bodies)
    if (is_in_the_way(body)) add(body.solids);
  return obstacles;
}

// What is wrong with where a thing stands; empty when nothing is.
std::string standing_fault(const Thing& thing, const std::vector<Space>& spaces,
                           const std::vector<Obstacle>& obstacles) {
  const Box needs = thing.needs.has_volume() ? thing.needs : Box{thing.origin - 1, thing.origin + 1};
  std::string fault;
  if (!is_open(spaces, needs)) fault = "it reaches into the rock";
  for (const Obstacle& obstacle : obstacles)
    // Clip stops who walks, not light.
    if (fault.empty() && (obstacle.texture != "clip" || thing.needs.has_volume()) &&
        common(obstacle.bounds, needs).has_volume() && overlap(obstacle.hull, needs))
      fault = fmt::format("it is in what line {} puts there ({})", obstacle.line,
                          base::quotable(obstacle.texture));
  if (fault.empty()) return fault;
  return fmt::format("line {}: {} {}: at {},{},{} {}", thing.line, thing.word, thing.fields.classname(),
                     thing.origin.x, thing.origin.y, thing.origin.z, fault);
}

}  // namespace

base::Result<Plan> read_plan(const ScriptLine& level) {
  Plan plan;
  const Scope outside;
  Scope scope;
  TRY_STATUS(read_level_line(level, outside, plan, scope));
  TRY_STATUS(collect_groups(level.below, plan));
  TRY_STATUS(read_lines(level.below, scope, plan));
  // Without a room but with something in it, it is no place but a thing: a box of ammunition.
  if (plan.spaces.empty() && plan.structure.empty() && plan.bodies.empty())
    return script_error(level, "it has no room");
  return plan;
}

formats::Map map_of_plan(const Plan& plan) {
  formats::Map map;
  std::vector<Solid> world;
  if (!plan.spaces.empty()) world = carve_shell(plan.spaces);
  world.insert(world.end(), plan.structure.begin(), plan.structure.end());
  map.entities.push_back(entity_with(plan.world, world));
  if (const std::vector<Solid> rock = rock_of(plan); !rock.empty())
    map.entities.push_back(entity_with(detail_with("_phong_angle", "50"), rock));
  if (const std::vector<Solid> bands = bands_of(plan); !bands.empty())
    map.entities.push_back(entity_with(detail_with("", ""), bands));
  for (const Body& body : plan.bodies) map.entities.push_back(entity_with(body.fields, body.solids));
  for (const Thing& thing : plan.things) {
    formats::MapEntity entity{thing.fields, {}};
    set_key(entity.fields, "origin", thing.origin);
    map.entities.push_back(std::move(entity));
  }
  return map;
}

base::Status check_plan(const Plan& plan) {
  constexpr int kMaxTold = 8;
  const std::vector<Obstacle> obstacles = obstacles_of(plan);
  std::string faults;
  int count = 0;
  for (const Thing& thing : plan.things) {
    if (thing.line < 0) continue;
    const std::string fault = standing_fault(thing, plan.spaces, obstacles);
    if (fault.empty() || ++count > kMaxTold) continue;
    faults += fmt::format("{}{}", faults.empty() ? "" : "; ", fault);
  }
  if (count > kMaxTold) faults += fmt::format("; and {} more", count - kMaxTold);
  if (count > 0) return base::malformed("{}", faults);
  return base::Ok{};
}

}  // namespace temblor::artgen
