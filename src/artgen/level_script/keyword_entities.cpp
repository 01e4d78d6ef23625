// Keywords for entities without brushes: lights, monsters, items, starts, cameras.
#include <fmt/format.h>

#include <algorithm>

#include "artgen/level_script/keywords.h"
#include "base/text.h"

namespace temblor::artgen {
namespace {

// Where an entity's origin is relative to the center of its base, and the space that it needs there.
struct Fit {
  Point origin{0};
  Point low{0}, high{0};
};

// Ammunition and health are brush models whose origin is their lower corner.
constexpr Fit kBoxItem{{-16, -16, 0}, {-15, -15, 1}, {15, 15, 32}};
// Weapons and armor.
constexpr Fit kPickedUp{{0, 0, 0}, {-15, -15, 1}, {15, 15, 32}};
// Keys and artifacts.
constexpr Fit kHovering{{0, 0, 24}, {-15, -15, 1}, {15, 15, 48}};
// The size of a player.
constexpr Fit kSmall{{0, 0, 24}, {-16, -16, 1}, {16, 16, 56}};
// The size of an ogre.
constexpr Fit kLarge{{0, 0, 24}, {-32, -32, 1}, {32, 32, 88}};

// A name in scripts, its class, and the spawnflags that select the variant.
struct Kind {
  std::string_view name, classname;
  Fit fit;
  int flags = 0;
};

constexpr Kind kMonsters[] = {
    {"army", "monster_army", kSmall},         {"dog", "monster_dog", kLarge},
    {"knight", "monster_knight", kSmall},     {"hell_knight", "monster_hell_knight", kSmall},
    {"ogre", "monster_ogre", kLarge},         {"fiend", "monster_demon1", kLarge},
    {"wizard", "monster_wizard", kSmall},     {"zombie", "monster_zombie", kSmall},
    {"shambler", "monster_shambler", kLarge}, {"shalrath", "monster_shalrath", kLarge},
    {"enforcer", "monster_enforcer", kSmall}, {"tarbaby", "monster_tarbaby", kSmall},
    {"fish", "monster_fish", kSmall},         {"oldone", "monster_oldone", kLarge},
};

constexpr Kind kItems[] = {
    {"health", "item_health", kBoxItem},
    {"health_small", "item_health", kBoxItem, 1},
    {"health_mega", "item_health", kBoxItem, 2},
    {"shells", "item_shells", kBoxItem},
    {"shells_big", "item_shells", kBoxItem, 1},
    {"nails", "item_spikes", kBoxItem},
    {"nails_big", "item_spikes", kBoxItem, 1},
    {"rockets", "item_rockets", kBoxItem},
    {"rockets_big", "item_rockets", kBoxItem, 1},
    {"cells", "item_cells", kBoxItem},
    {"cells_big", "item_cells", kBoxItem, 1},
    {"armor_green", "item_armor1", kPickedUp},
    {"armor_yellow", "item_armor2", kPickedUp},
    {"armor_red", "item_armorInv", kPickedUp},
    {"super_shotgun", "weapon_supershotgun", kPickedUp},
    {"nailgun", "weapon_nailgun", kPickedUp},
    {"super_nailgun", "weapon_supernailgun", kPickedUp},
    {"grenade_launcher", "weapon_grenadelauncher", kPickedUp},
    {"rocket_launcher", "weapon_rocketlauncher", kPickedUp},
    {"lightning", "weapon_lightning", kPickedUp},
    {"tremor", "weapon_tremor", kPickedUp},
    {"key_silver", "item_key1", kHovering},
    {"key_gold", "item_key2", kHovering},
    {"quad", "item_artifact_super_damage", kHovering},
    {"pentagram", "item_artifact_invulnerability", kHovering},
    {"suit", "item_artifact_envirosuit", kHovering},
    {"ring", "item_artifact_invisibility", kHovering},
    {"barrel", "misc_explobox", kBoxItem},
    {"barrel_small", "misc_explobox2", kBoxItem},
};

constexpr Kind kStarts[] = {
    {"start", "info_player_start", kSmall},
    {"coop", "info_player_coop", kSmall},
    {"deathmatch", "info_player_deathmatch", kSmall},
};

// Null after recording a problem that lists all names.
const Kind* find_kind(LevelScriptLine& line, std::span<const Kind> kinds, const std::string& name) {
  const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return k.name == name; });
  if (kind != kinds.end()) return &*kind;
  std::string names;
  for (const Kind& known : kinds) names += fmt::format("{}{}", names.empty() ? "" : ", ", known.name);
  line.set_error(fmt::format("'{}' is not one of {}", base::quotable(name), names));
  return nullptr;
}

// `foot` is the center of the entity's base, in the scope's coordinates.
void add_point_entity(const LevelScriptLine& line, formats::Entity fields, Point foot, const Fit& fit,
                      LevelScript& io_script) {
  PointEntity thing;
  const Point foot_world = line.scope().placement.apply(foot);
  thing.origin = foot_world + fit.origin;
  if (fit.low != fit.high) thing.clearance = {foot_world + fit.low, foot_world + fit.high};
  thing.fields = std::move(fields);
  thing.line = line.line().number;
  thing.keyword = line.line().keyword;
  io_script.point_entities.push_back(std::move(thing));
}

// face= becomes the key "angle".
void read_facing_key(LevelScriptLine& line, formats::Entity& io_entity) {
  if (const std::optional<double> angle = line.facing("face")) set_key(io_entity, "angle", *angle);
}

// color=255,160,64 becomes "_color" with blanks.
void read_light_color(LevelScriptLine& line, formats::Entity& io_entity, std::string_view fallback = "") {
  std::string color = line.text("color", fallback);
  if (color.empty()) return;
  std::replace(color.begin(), color.end(), ',', ' ');
  formats::Entity parsed;
  set_key(parsed, "c", std::string_view(color));
  if (!parsed.find_vec3("c")) line.set_error("color= must be R,G,B, each from 0 to 255");
  set_key(io_entity, "_color", std::string_view(color));
}

// Scripts can switch a named light, because its name is a targetname; off=yes makes it start dark.
void read_light_keys(LevelScriptLine& line, formats::Entity& io_light, double bright) {
  set_key(io_light, "light", bright);
  read_light_color(line, io_light);
  if (line.flag("off")) set_key(io_light, "spawnflags", 1.0);
}

// aim=X,Y,Z makes a spotlight with a cone of cone= degrees. Quake's spotlights target an entity, so this adds
// an info_null.
void read_aim(LevelScriptLine& line, formats::Entity& io_light, LevelScript& io_script) {
  if (!line.has("aim")) return;
  const Point aim = line.position("aim", Point(0));
  const std::string name = fmt::format("aim{}", ++io_script.generated_names);
  set_key(io_light, "target", std::string_view(name));
  set_key(io_light, "angle", line.number("cone", 40, 1, 179));
  PointEntity goal;
  set_key(goal.fields, "classname", "info_null");
  set_key(goal.fields, "targetname", std::string_view(name));
  goal.origin = line.scope().placement.apply(aim);
  // Not checked: it may be inside a wall.
  goal.line = -1;
  io_script.point_entities.push_back(std::move(goal));
}

// The next value, if there is one.
double read_brightness(LevelScriptLine& line, double fallback) {
  const std::optional<std::string> word = line.next_text_if_present();
  if (!word) return fallback;
  formats::Entity parsed;
  set_key(parsed, "n", std::string_view(*word));
  const std::optional<float> bright = parsed.find_number("n");
  if (!bright) line.set_error(fmt::format("'{}' is not a brightness", base::quotable(*word)));
  return bright.value_or(0.0f);
}

base::Status read_light(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Point position = line.position();
  formats::Entity light = make_entity(line, "light");
  read_light_keys(line, light, read_brightness(line, 300));
  read_aim(line, light, io_script);
  add_point_entity(line, std::move(light), position, {}, io_script);
  return line.finish();
}

// A lamp with a light in front of it: `lamp north 64,96 250` on a wall, `lamp up mid,mid 250` at the ceiling
// (with hang=64 on a rod), `lamp down 64,64` on the floor.
base::Status read_lamp(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Side side = line.side();
  const bool on_wall = side_axis(side) < 2;
  const int size = line.integer("size", on_wall ? 16 : 32, 4, 256);
  const int tall = line.integer("tall", on_wall ? 32 : 8, 2, 512), deep = line.integer("deep", 8, 1, 64);
  const int hang = line.integer("hang", 0, 0, 2048);
  const std::string texture = line.text("texture", on_wall ? "lamp1" : "light3");
  const std::string rod = line.text("rod", "metal1");
  const double scale = line.number("scale", on_wall ? 0.5 : 1, 0.125, 8);
  Point at = on_wall ? line.wall_position(side) : line.position();
  if (side == Side::kUp && !script_line.values.empty() && at.z == 0) at.z = scope.size.z;
  const double bright = read_brightness(line, 200);
  Box box{at - Point(size / 2, size / 2, 0), at + Point(size / 2, size / 2, 0)};
  Point source = at;
  if (on_wall) {
    const int into = is_upper(side) ? -1 : 1;
    box.low.z -= tall / 2;
    box.high.z = box.low.z + tall;
    Point& far = into < 0 ? box.low : box.high;
    Point& near = into < 0 ? box.high : box.low;
    near[side_axis(side)] = at[side_axis(side)];
    far[side_axis(side)] = at[side_axis(side)] + into * deep;
    source[side_axis(side)] = at[side_axis(side)] + into * (deep + 12);
  } else if (side == Side::kUp) {
    box.high.z = at.z - hang;
    box.low.z = box.high.z - tall;
    source.z = box.low.z - 12;
  } else {
    box.high.z = at.z + tall;
    source.z = box.high.z + 12;
  }
  Looks looks = make_uniform_looks(texture, line.to_world(box));
  for (Look& look : looks) look.scale = math::Vec2d(scale);
  std::vector<Solid> solids = {make_solid(line, box, looks)};
  if (hang > 0) {
    const Box bar{{at.x - 2, at.y - 2, at.z - hang}, {at.x + 2, at.y + 2, at.z}};
    solids.push_back(make_solid(line, bar, make_uniform_looks(rod, line.to_world(bar))));
  }
  formats::Entity light = make_entity(line, "light");
  read_light_keys(line, light, bright);
  add_point_entity(line, std::move(light), source, {}, io_script);
  add_solids(line, std::move(solids), "detail", io_script);
  return line.finish();
}

// The light of fire flickers, unless style= says otherwise.
void read_fire_keys(LevelScriptLine& line, formats::Entity& io_fire, double bright) {
  constexpr double kFlickering = 1;
  read_light_color(line, io_fire, "255 160 72");
  set_key(io_fire, "light", bright);
  if (!line.has("style")) set_key(io_fire, "style", kFlickering);
}

// `torch north 64,72 200` on a wall, `flame 64,64,32 250` anywhere.
base::Status read_torch(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Side side = line.side();
  Point at = line.wall_position(side);
  at[side_axis(side) % 2] += is_upper(side) ? -8 : 8;
  formats::Entity torch = make_entity(line, "light_torch_small_walltorch");
  read_fire_keys(line, torch, read_brightness(line, 220));
  add_point_entity(line, std::move(torch), at, {}, io_script);
  return line.finish();
}

base::Status read_flame(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Point at = line.position();
  formats::Entity flame =
      make_entity(line, line.flag("large") ? "light_flame_large_yellow" : "light_flame_small_yellow");
  read_fire_keys(line, flame, read_brightness(line, 250));
  add_point_entity(line, std::move(flame), at, {}, io_script);
  return line.finish();
}

base::Status read_monster(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Kind* kind = find_kind(line, kMonsters, line.next_text());
  const Point foot = line.position();
  if (kind == nullptr) return line.finish();
  formats::Entity monster = make_entity(line, kind->classname, line.flag("ambush") ? 1 : 0);
  read_facing_key(line, monster);
  add_point_entity(line, std::move(monster), foot, kind->fit, io_script);
  return line.finish();
}

base::Status read_item(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Kind* kind = find_kind(line, kItems, line.next_text());
  const Point foot = line.position();
  if (kind == nullptr) return line.finish();
  formats::Entity item = make_entity(line, kind->classname, kind->flags);
  read_facing_key(line, item);
  add_point_entity(line, std::move(item), foot, kind->fit, io_script);
  return line.finish();
}

base::Status read_start(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Kind* kind = find_kind(line, kStarts, script_line.keyword);
  const Point foot = line.position();
  formats::Entity start = make_entity(line, kind->classname);
  read_facing_key(line, start);
  add_point_entity(line, std::move(start), foot, kind->fit, io_script);
  return line.finish();
}

// `arrival NAME 64,64 face=north`: the destination of a teleporter.
base::Status read_arrival(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  formats::Entity arrival = make_entity(line, "info_teleport_destination");
  set_key(arrival, "targetname", line.next_text());
  const Point foot = line.position();
  read_facing_key(line, arrival);
  Fit fit = kSmall;
  // Game code raises the destination itself.
  fit.origin = Point(0);
  add_point_entity(line, std::move(arrival), foot, fit, io_script);
  return line.finish();
}

// A camera for the end of the level: face= and pitch= (down is positive).
base::Status read_camera(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Point at = line.position();
  formats::Entity camera = make_entity(line, "info_intermission");
  const int pitch = line.integer("pitch", 0, -90, 90);
  const double yaw = line.facing("face").value_or(scope.placement.apply_angle(0));
  set_key(camera, "mangle", std::string_view(fmt::format("{} {} 0", pitch, yaw)));
  add_point_entity(line, std::move(camera), at, {}, io_script);
  return line.finish();
}

// An entity of any class: `entity ambient_drip 64,64,96`. All settings become keys, except for those that
// every line accepts: name=, face=, skill=, dm=, flags=, and to=.
base::Status read_entity(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const std::string classname = line.next_text();
  const Point at = line.position();
  formats::Entity entity = make_entity(line, classname);
  for (const auto& [key, value] : script_line.settings)
    if (key != "name" && key != "face" && key != "skill" && key != "dm" && key != "flags" && key != "to")
      set_key(entity, key, line.text(key, ""));
  read_facing_key(line, entity);
  add_point_entity(line, std::move(entity), at, {}, io_script);
  return line.finish();
}

constexpr LevelKeyword kEntityKeywords[] = {
    {"light", read_light},      {"lamp", read_lamp},       {"torch", read_torch},   {"flame", read_flame},
    {"monster", read_monster},  {"item", read_item},       {"start", read_start},   {"coop", read_start},
    {"deathmatch", read_start}, {"arrival", read_arrival}, {"camera", read_camera}, {"entity", read_entity},
};

}  // namespace

std::span<const LevelKeyword> entity_keywords() {
  return kEntityKeywords;
}

}  // namespace temblor::artgen
