#include "artgen/level_script/level_script_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "artgen/level_script/carve.h"
#include "artgen/level_script/keywords.h"
#include "artgen/level_script/rock.h"
#include "base/text.h"

namespace temblor::artgen {
namespace {

// The directions in which a texture's s and t grow.
struct TextureAxes {
  math::Vec3d s, t;
};

// To the right and down as seen from the front. On floors and ceilings: to the east and to the south.
TextureAxes find_texture_axes(Side side) {
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

// Valve 220 texturing, with the lower left corner of the picture at the lower left corner of the anchor's
// side.
formats::MapTexturing make_texturing(const Look& look, Side side) {
  const TextureAxes axes = find_texture_axes(side);
  double left = std::numeric_limits<double>::max(), bottom = std::numeric_limits<double>::lowest();
  for (const Point& corner : list_corners(look.anchor)) {
    left = std::min(left, glm::dot(math::Vec3d(corner), axes.s));
    bottom = std::max(bottom, glm::dot(math::Vec3d(corner), axes.t));
  }
  formats::MapTexturing texturing;
  texturing.alignment = formats::MapAlignment::kValve;
  texturing.s_axis = axes.s;
  texturing.t_axis = axes.t;
  texturing.scale = look.scale;
  // Offsets are reduced modulo a common multiple of texture sizes. Equal offsets share a texinfo, of which a
  // level has at most 4096.
  constexpr double kTurn = 768;
  const math::Vec2d offset(look.shift.x - left / look.scale.x, look.shift.y - bottom / look.scale.y);
  texturing.offset = {offset.x - kTurn * std::floor(offset.x / kTurn),
                      offset.y - kTurn * std::floor(offset.y / kTurn)};
  return texturing;
}

// Each side of the hull gets the look of the axial direction that it is closest to.
formats::MapBrush make_brush(const Solid& solid) {
  formats::MapBrush brush;
  for (const HullSide& side : make_hull(solid.corners)) {
    const Side like = find_closest_side(side.normal);
    const Look& look = solid.looks[side_index(like)];
    formats::MapSide out;
    for (std::size_t i = 0; i < 3; ++i) out.points_world[i] = math::Vec3d(side.points[i]);
    out.texture = look.texture;
    out.texturing = make_texturing(look, like);
    brush.sides.push_back(std::move(out));
  }
  return brush;
}

// Leaves out solids without a volume.
formats::MapEntity make_map_entity(formats::Entity fields, const std::vector<Solid>& solids) {
  formats::MapEntity entity{std::move(fields), {}};
  for (const Solid& solid : solids) {
    formats::MapBrush brush = make_brush(solid);
    if (!brush.sides.empty()) entity.brushes.push_back(std::move(brush));
  }
  return entity;
}

// Needs the final list of spaces.
std::vector<Solid> make_all_rock(const LevelScript& script) {
  std::vector<Solid> rock;
  for (const RockFace& face : script.rock_faces)
    for (Solid& solid : make_rock(face, script.spaces)) rock.push_back(std::move(solid));
  return rock;
}

std::vector<Solid> make_all_bands(const LevelScript& script) {
  std::vector<Solid> bands;
  for (const Band& band : script.bands)
    for (Solid& solid : make_band(band, script.spaces)) bands.push_back(std::move(solid));
  return bands;
}

formats::Entity make_detail_entity(std::string_view key, std::string_view value) {
  formats::Entity entity;
  set_key(entity, "classname", "func_detail");
  if (!key.empty()) set_key(entity, key, value);
  return entity;
}

// Reads the level's own line: its name, the default textures (into out_scope), and the keys of worldspawn.
base::Status read_level_line(const ScriptLine& level, const Scope& outside, LevelScript& io_script,
                             Scope& out_scope) {
  LevelScriptLine line(level, outside);
  io_script.name = line.next_text();
  set_key(io_script.world, "classname", "worldspawn");
  set_key(io_script.world, "mapversion", "220");
  if (const std::optional<std::string> title = line.next_text_if_present())
    set_key(io_script.world, "message", std::string_view(*title));
  out_scope.surfaces = line.surfaces({});
  if (line.has("music")) set_key(io_script.world, "sounds", line.integer("music", 0, 0, 255));
  for (const auto& [key, value] : level.settings) {
    constexpr std::array<std::string_view, 10> kKnown = {
        "light", "worldtype", "fog", "sky", "wad", "wateralpha", "speed", "gravity", "peace", "par"};
    if (key.starts_with('_') || std::find(kKnown.begin(), kKnown.end(), key) != kKnown.end())
      set_key(io_script.world, key, line.text(key, ""));
  }
  const bool good =
      !io_script.name.empty() && io_script.name.size() <= 32 &&
      io_script.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
  if (!good) line.set_error("a level's name is up to 32 lower case letters, digits and _");
  return line.finish();
}

// A solid, prepared for the test against point entities.
struct Obstacle {
  std::vector<HullSide> hull;
  Box bounds;
  std::int32_t line = 0;
  std::string texture;
};

// Triggers and illusions do not block entities; trains and lifts move away.
bool is_in_the_way(const BrushEntity& body) {
  const std::string_view classname = body.fields.classname();
  return !classname.starts_with("trigger") && classname != "func_detail_illusionary" &&
         classname != "func_illusionary" && classname != "func_plat" && classname != "func_train";
}

// Liquids are no obstacles.
std::vector<Obstacle> list_obstacles(const LevelScript& script) {
  std::vector<Obstacle> obstacles;
  const auto add = [&](const std::vector<Solid>& solids) {
    for (const Solid& solid : solids) {
      const std::string& texture = solid.looks.front().texture;
      if (texture.starts_with('*') || solid.corners.empty()) continue;
      obstacles.push_back({make_hull(solid.corners), find_bounds(solid.corners), solid.line, texture});
    }
  };
  add(script.structure);
  add(make_all_rock(script));
  for (const BrushEntity& body : script.brush_entities)
    if (is_in_the_way(body)) add(body.solids);
  return obstacles;
}

// Why an entity cannot be where it is; empty if it can.
std::string find_placement_error(const PointEntity& thing, const std::vector<Space>& spaces,
                                 const std::vector<Obstacle>& obstacles) {
  const Box clearance =
      thing.clearance.has_volume() ? thing.clearance : Box{thing.origin - 1, thing.origin + 1};
  std::string fault;
  if (!is_open(spaces, clearance)) fault = "is in solid rock";
  for (const Obstacle& obstacle : obstacles)
    // Clip brushes stop creatures and items, but not lights and other entities without a clearance.
    if (fault.empty() && (obstacle.texture != "clip" || thing.clearance.has_volume()) &&
        intersect(obstacle.bounds, clearance).has_volume() && overlap(obstacle.hull, clearance))
      fault =
          fmt::format("is inside the solid of line {} ({})", obstacle.line, base::quotable(obstacle.texture));
  if (fault.empty()) return fault;
  return fmt::format("line {}: {} {}: at {},{},{} {}", thing.line, thing.keyword, thing.fields.classname(),
                     thing.origin.x, thing.origin.y, thing.origin.z, fault);
}

}  // namespace

base::Result<LevelScript> read_level_script(const ScriptLine& level) {
  LevelScript script;
  const Scope outside;
  Scope scope;
  TRY_STATUS(read_level_line(level, outside, script, scope));
  TRY_STATUS(collect_groups(level.below, script));
  TRY_STATUS(read_lines(level.below, scope, script));
  // A script without rooms may still describe a brush model for an item, such as a box of ammunition.
  if (script.spaces.empty() && script.structure.empty() && script.brush_entities.empty())
    return script_error(level, "the level has no room");
  return script;
}

formats::Map make_map(const LevelScript& script) {
  // The order of entities is fixed: world, rock, bands, brush entities, point entities.
  formats::Map map;
  std::vector<Solid> world;
  if (!script.spaces.empty()) world = carve_shell(script.spaces);
  world.insert(world.end(), script.structure.begin(), script.structure.end());
  map.entities.push_back(make_map_entity(script.world, world));
  if (const std::vector<Solid> rock = make_all_rock(script); !rock.empty())
    map.entities.push_back(make_map_entity(make_detail_entity("_phong_angle", "50"), rock));
  if (const std::vector<Solid> bands = make_all_bands(script); !bands.empty())
    map.entities.push_back(make_map_entity(make_detail_entity("", ""), bands));
  for (const BrushEntity& body : script.brush_entities)
    map.entities.push_back(make_map_entity(body.fields, body.solids));
  for (const PointEntity& thing : script.point_entities) {
    formats::MapEntity entity{thing.fields, {}};
    set_key(entity.fields, "origin", thing.origin);
    map.entities.push_back(std::move(entity));
  }
  return map;
}

base::Status check_level_script(const LevelScript& script) {
  constexpr int kMaxListed = 8;
  const std::vector<Obstacle> obstacles = list_obstacles(script);
  std::string faults;
  int count = 0;
  for (const PointEntity& thing : script.point_entities) {
    if (thing.line < 0) continue;
    const std::string fault = find_placement_error(thing, script.spaces, obstacles);
    if (fault.empty() || ++count > kMaxListed) continue;
    faults += fmt::format("{}{}", faults.empty() ? "" : "; ", fault);
  }
  if (count > kMaxListed) faults += fmt::format("; and {} more", count - kMaxListed);
  if (count > 0) return base::malformed("{}", faults);
  return base::Ok{};
}

}  // namespace temblor::artgen
