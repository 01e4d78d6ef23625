// Words for entities without brushes: lights, monsters, items, places.
#include <fmt/format.h>

#include <algorithm>

#include "artgen/level_script/words.h"
#include "base/text.h"

namespace temblor::artgen {
namespace {

// An item's origin from the middle of its foot, and the room it takes there.
struct Fit {
  Point origin{0};
  Point low{0}, high{0};
};

constexpr Fit kBoxItem{{-16, -16, 0}, {-15, -15, 1}, {15, 15, 32}};  // its origin is its lower corner
constexpr Fit kPickedUp{{0, 0, 0}, {-15, -15, 1}, {15, 15, 32}};     // weapons, armor
constexpr Fit kHovering{{0, 0, 24}, {-15, -15, 1}, {15, 15, 48}};    // keys, artifacts
constexpr Fit kSmall{{0, 0, 24}, {-16, -16, 1}, {16, 16, 56}};       // as large as a player
constexpr Fit kLarge{{0, 0, 24}, {-32, -32, 1}, {32, 32, 88}};       // as large as an ogre

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

const Kind* find_kind(PlanLine& line, std::span<const Kind> kinds, const std::string& name) {
  const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return k.name == name; });
  if (kind != kinds.end()) return &*kind;
  std::string names;
  for (const Kind& known : kinds) names += fmt::format("{}{}", names.empty() ? "" : ", ", known.name);
  line.complain(fmt::format("'{}' is none of {}", base::quotable(name), names));
  return nullptr;
}

void put_thing(const PlanLine& line, formats::Entity fields, Point foot, const Fit& fit, Plan& io_plan) {
  Thing thing;
  const Point foot_world = line.scope().placement.apply(foot);
  thing.origin = foot_world + fit.origin;
  if (fit.low != fit.high) thing.needs = {foot_world + fit.low, foot_world + fit.high};
  thing.fields = std::move(fields);
  thing.line = line.line().number;
  thing.word = line.line().word;
  io_plan.things.push_back(std::move(thing));
}

void take_facing(PlanLine& line, formats::Entity& io_entity) {
  if (const std::optional<double> angle = line.facing("face")) set_key(io_entity, "angle", *angle);
}

// color=255,160,64
void take_color(PlanLine& line, formats::Entity& io_entity, std::string_view otherwise = "") {
  std::string color = line.text("color", otherwise);
  if (color.empty()) return;
  std::replace(color.begin(), color.end(), ',', ' ');
  formats::Entity parsed;
  set_key(parsed, "c", std::string_view(color));
  if (!parsed.find_vec3("c")) line.complain("color= is R,G,B, each from 0 to 255");
  set_key(io_entity, "_color", std::string_view(color));
}

// Who sets off what a light is called by is up to the level: its name is a targetname.
void take_light_keys(PlanLine& line, formats::Entity& io_light, double bright) {
  set_key(io_light, "light", bright);
  take_color(line, io_light);
  if (line.flag("off")) set_key(io_light, "spawnflags", 1.0);
}

// aim= a place: a cone of cone= degrees towards it.
void take_aim(PlanLine& line, formats::Entity& io_light, Plan& io_plan) {
  if (!line.has("aim")) return;
  const Point aim = line.place("aim", Point(0));
  const std::string name = fmt::format("aim{}", ++io_plan.names_given);
  set_key(io_light, "target", std::string_view(name));
  set_key(io_light, "angle", line.number("cone", 40, 1, 179));
  Thing goal;
  set_key(goal.fields, "classname", "info_null");
  set_key(goal.fields, "targetname", std::string_view(name));
  goal.origin = line.scope().placement.apply(aim);
  goal.line = -1;
  io_plan.things.push_back(std::move(goal));
}

double brightness(PlanLine& line, double otherwise) {
  const std::optional<std::string> word = line.word_if_there();
  if (!word) return otherwise;
  formats::Entity parsed;
  set_key(parsed, "n", std::string_view(*word));
  const std::optional<float> bright = parsed.find_number("n");
  if (!bright) line.complain(fmt::format("'{}' is no brightness", base::quotable(*word)));
  return bright.value_or(0.0f);
}

base::Status read_light(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Point place = line.place();
  formats::Entity light = entity_of(line, "light");
  take_light_keys(line, light, brightness(line, 300));
  take_aim(line, light, io_plan);
  put_thing(line, std::move(light), place, {}, io_plan);
  return line.finish();
}

// A lamp with its light before it: `lamp north 64,96 250` on a wall, `lamp up mid,mid 250` at the ceiling
// (with hang=64 on a rod), `lamp down 64,64` on the floor.
base::Status read_lamp(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Side side = line.side();
  const bool on_wall = axis_of(side) < 2;
  const int size = line.whole("size", on_wall ? 16 : 32, 4, 256);
  const int tall = line.whole("tall", on_wall ? 32 : 8, 2, 512), deep = line.whole("deep", 8, 1, 64);
  const int hang = line.whole("hang", 0, 0, 2048);
  const std::string texture = line.text("texture", on_wall ? "lamp1" : "light3");
  const std::string rod = line.text("rod", "metal1");
  const double scale = line.number("scale", on_wall ? 0.5 : 1, 0.125, 8);
  Point at = on_wall ? line.place_on_wall(side) : line.place();
  if (side == Side::kUp && !script.values.empty() && at.z == 0) at.z = scope.size.z;
  const double bright = brightness(line, 200);
  Box box{at - Point(size / 2, size / 2, 0), at + Point(size / 2, size / 2, 0)};
  Point source = at;
  if (on_wall) {
    const int into = is_upper(side) ? -1 : 1;
    box.low.z -= tall / 2;
    box.high.z = box.low.z + tall;
    Point& far = into < 0 ? box.low : box.high;
    Point& near = into < 0 ? box.high : box.low;
    near[axis_of(side)] = at[axis_of(side)];
    far[axis_of(side)] = at[axis_of(side)] + into * deep;
    source[axis_of(side)] = at[axis_of(side)] + into * (deep + 12);
  } else if (side == Side::kUp) {
    box.high.z = at.z - hang;
    box.low.z = box.high.z - tall;
    source.z = box.low.z - 12;
  } else {
    box.high.z = at.z + tall;
    source.z = box.high.z + 12;
  }
  Looks looks = looks_all(texture, line.to_world(box));
  for (Look& look : looks) look.scale = math::Vec2d(scale);
  std::vector<Solid> solids = {solid_of(line, box, looks)};
  if (hang > 0) {
    const Box bar{{at.x - 2, at.y - 2, at.z - hang}, {at.x + 2, at.y + 2, at.z}};
    solids.push_back(solid_of(line, bar, looks_all(rod, line.to_world(bar))));
  }
  formats::Entity light = entity_of(line, "light");
  take_light_keys(line, light, bright);
  put_thing(line, std::move(light), source, {}, io_plan);
  put_solids(line, std::move(solids), "detail", io_plan);
  return line.finish();
}

// `torch north 64,72 200` on a wall, `flame 64,64,32 250` anywhere.
base::Status read_torch(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Side side = line.side();
  Point at = line.place_on_wall(side);
  at[axis_of(side) % 2] += is_upper(side) ? -8 : 8;
  formats::Entity torch = entity_of(line, "light_torch_small_walltorch");
  take_color(line, torch, "255 160 72");
  set_key(torch, "light", brightness(line, 220));
  put_thing(line, std::move(torch), at, {}, io_plan);
  return line.finish();
}

base::Status read_flame(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Point at = line.place();
  formats::Entity flame =
      entity_of(line, line.flag("large") ? "light_flame_large_yellow" : "light_flame_small_yellow");
  take_color(line, flame, "255 160 72");
  set_key(flame, "light", brightness(line, 250));
  put_thing(line, std::move(flame), at, {}, io_plan);
  return line.finish();
}

base::Status read_monster(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Kind* kind = find_kind(line, kMonsters, line.word());
  const Point foot = line.place();
  if (kind == nullptr) return line.finish();
  formats::Entity monster = entity_of(line, kind->classname, line.flag("ambush") ? 1 : 0);
  take_facing(line, monster);
  put_thing(line, std::move(monster), foot, kind->fit, io_plan);
  return line.finish();
}

base::Status read_item(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Kind* kind = find_kind(line, kItems, line.word());
  const Point foot = line.place();
  if (kind == nullptr) return line.finish();
  formats::Entity item = entity_of(line, kind->classname, kind->flags);
  take_facing(line, item);
  put_thing(line, std::move(item), foot, kind->fit, io_plan);
  return line.finish();
}

base::Status read_start(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Kind* kind = find_kind(line, kStarts, script.word);
  const Point foot = line.place();
  formats::Entity start = entity_of(line, kind->classname);
  take_facing(line, start);
  put_thing(line, std::move(start), foot, kind->fit, io_plan);
  return line.finish();
}

// `arrival NAME 64,64 face=north`: where a teleporter leads.
base::Status read_arrival(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  formats::Entity arrival = entity_of(line, "info_teleport_destination");
  set_key(arrival, "targetname", line.word());
  const Point foot = line.place();
  take_facing(line, arrival);
  Fit fit = kSmall;
  fit.origin = Point(0);  // the game raises it
  put_thing(line, std::move(arrival), foot, fit, io_plan);
  return line.finish();
}

// Where the end of the level is watched from: face= and pitch= (down is positive).
base::Status read_camera(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Point at = line.place();
  formats::Entity camera = entity_of(line, "info_intermission");
  const int pitch = line.whole("pitch", 0, -90, 90);
  const double yaw = line.facing("face").value_or(scope.placement.apply_angle(0));
  set_key(camera, "mangle", std::string_view(fmt::format("{} {} 0", pitch, yaw)));
  put_thing(line, std::move(camera), at, {}, io_plan);
  return line.finish();
}

// Any class: `entity ambient_drip 64,64,96`. All settings but name=, face=, skill= and dm= are its keys.
base::Status read_entity(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const std::string classname = line.word();
  const Point at = line.place();
  formats::Entity entity = entity_of(line, classname);
  for (const auto& [key, value] : script.settings)
    if (key != "name" && key != "face" && key != "skill" && key != "dm" && key != "flags" && key != "to")
      set_key(entity, key, line.text(key, ""));
  take_facing(line, entity);
  put_thing(line, std::move(entity), at, {}, io_plan);
  return line.finish();
}

constexpr PlanWord kThingWords[] = {
    {"light", read_light},      {"lamp", read_lamp},       {"torch", read_torch},   {"flame", read_flame},
    {"monster", read_monster},  {"item", read_item},       {"start", read_start},   {"coop", read_start},
    {"deathmatch", read_start}, {"arrival", read_arrival}, {"camera", read_camera}, {"entity", read_entity},
};

}  // namespace

std::span<const PlanWord> thing_words() {
  return kThingWords;
}

}  // namespace temblor::artgen
