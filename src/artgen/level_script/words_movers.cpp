// Words for brush entities: what moves, and what is set off by who enters it.
#include <fmt/format.h>

#include <algorithm>

#include "artgen/level_script/words.h"
#include "base/text.h"

namespace temblor::artgen {
namespace {

constexpr int kDoorThick = 16;

// In the middle of an opening, across it.
Box door_in(const Scope& scope, int thick) {
  Box box = scope.whole();
  const int axis = scope.size.x <= scope.size.y ? 0 : 1;
  const int middle = scope.size[axis] / 2;
  box.low[axis] = middle - thick / 2;
  box.high[axis] = box.low[axis] + thick;
  return box;
}

int key_flag(PlanLine& line) {
  const std::string key = line.text("key", "");
  if (key == "gold") return 8;
  if (key == "silver") return 16;
  if (!key.empty()) line.complain("key= is gold or silver");
  return 0;
}

void put_door(PlanLine& line, const Box& leaf, Side way, const std::string& texture, int flags,
              Plan& io_plan) {
  const Looks looks = looks_all(texture, line.to_world(leaf));
  formats::Entity door = entity_of(line, "func_door", flags);
  set_key(door, "angle", move_angle(line, way));
  put_body(std::move(door), {solid_of(line, leaf, looks)}, io_plan);
}

base::Status read_door(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const int thick = line.whole("thick", kDoorThick, 2, 128);
  if (!line.box_is_next() && scope.size == Point(0)) line.complain("it has a box, or stands in an opening");
  const Box box = line.box_or(door_in(scope, thick));
  const std::string texture = line.word_if_there().value_or("door1");
  const int flags = key_flag(line) + (line.flag("toggle") ? 32 : 0) + (line.flag("open") ? 1 : 0) +
                    (line.flag("alone") ? 4 : 0);
  const Side move = line.side("move", Side::kUp);
  if (!line.flag("double")) {
    put_door(line, box, move, texture, flags, io_plan);
    return line.finish();
  }
  const int axis = box.size().x >= box.size().y ? 0 : 1;
  for (const bool upper : {false, true}) {
    Box leaf = box;
    (upper ? leaf.low : leaf.high)[axis] = (box.low[axis] + box.high[axis]) / 2;
    put_door(line, leaf, static_cast<Side>(2 * axis + (upper ? 0 : 1)), texture, flags, io_plan);
  }
  return line.finish();
}

// A piece of wall that goes back and then aside; open=shot (any hit opens it) or a name= to be used by.
base::Status read_secret_door(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Box box = line.box_or(scope.whole());
  if (!box.has_volume()) line.complain("it has a box, or stands in an opening");
  const Looks looks = line.looks(line.to_world(box), scope.surfaces[index_of(Side::kNorth)]);
  const Side first = line.side("first", Side::kDown);
  const Side then = line.side("move", Side::kNorth);
  if (axis_of(then) == 2) line.complain("move= is a compass point: the second part of its way");
  formats::Entity door = entity_of(line, "func_door_secret", first == Side::kDown ? 4 : 0);
  // Its angle is the second part of its way; the first is down, or to the right of that.
  set_key(door, "angle", move_angle(line, then));
  if (first != Side::kDown) {
    const Side way = scope.placement.apply(first), angle = scope.placement.apply(then);
    const Placement right{Point(0), 3, false};
    if (axis_of(first) == 2 || axis_of(first) == axis_of(then))
      line.complain("first= is down, or to the left or right of move=");
    else if (way != right.apply(angle))
      set_key(door, "spawnflags", 2 + line.whole("flags", 0, 0, 255));
  }
  if (line.has("far")) set_key(door, "t_length", line.whole("far", 0, 1, 4096));
  if (line.has("back")) set_key(door, "t_width", line.whole("back", 0, 1, 4096));
  put_body(std::move(door), {solid_of(line, box, looks)}, io_plan);
  return line.finish();
}

// Its box is where it stands above; it waits `drop` below.
base::Status read_lift(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Box box = line.box();
  const Looks looks = line.looks(line.to_world(box), "metal1");
  formats::Entity lift = entity_of(line, "func_plat", line.flag("low_trigger") ? 1 : 0);
  if (line.has("drop")) set_key(lift, "height", line.whole("drop", 0, 8, 8192));
  put_body(std::move(lift), {solid_of(line, box, looks)}, io_plan);
  return line.finish();
}

void put_corner(const PlanLine& line, const Box& box_there, const std::string& name, const std::string& next,
                double wait, Plan& io_plan) {
  Thing corner;
  set_key(corner.fields, "classname", "path_corner");
  set_key(corner.fields, "targetname", name);
  set_key(corner.fields, "target", next);
  if (wait != 0) set_key(corner.fields, "wait", wait);
  corner.origin = line.to_world(box_there).low;
  corner.line = -1;  // may lie in the rock
  corner.word = "stop";
  io_plan.things.push_back(std::move(corner));
}

struct Stop {
  Point low;
  double wait = 0;
};

// The train's own box is its first stop, unless the stops say otherwise; after the last it goes back to the
// first.
void put_train(PlanLine& line, const Box& box, const std::vector<Stop>& stops, std::vector<Solid> solids,
               Plan& io_plan) {
  const std::string track = fmt::format("track{}", ++io_plan.names_given);
  const auto name_of = [&](std::size_t i) { return fmt::format("{}_{}", track, i % stops.size()); };
  formats::Entity train = entity_of(line, "func_train");
  set_key(train, "target", name_of(0));
  put_body(std::move(train), std::move(solids), io_plan);
  for (std::size_t i = 0; i < stops.size(); ++i)
    put_corner(line, {stops[i].low, stops[i].low + box.size()}, name_of(i), name_of(i + 1), stops[i].wait,
               io_plan);
}

// What goes with a train: walls, a load. The train's place is its lower corner, which is its first box's.
base::Status read_part(PlanLine& part, const Box& train, std::vector<Solid>& io_solids) {
  const Box box = part.box();
  const Looks looks = part.looks(part.to_world(box), "metal1");
  for (int axis = 0; axis < 3; ++axis)
    if (box.low[axis] < train.low[axis]) {
      part.complain("it reaches further west, south or down than the train's own box");
      break;
    }
  io_solids.push_back(solid_of(part, box, looks));
  return part.finish();
}

base::Status read_train(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Box box = line.box();
  const Looks looks = line.looks(line.to_world(box), "metal1");
  std::vector<Solid> solids = {solid_of(line, box, looks)};
  std::vector<Stop> stops;
  for (const ScriptLine& below : script.below) {
    PlanLine stop(below, scope);
    if (below.word == "part") {
      TRY_STATUS(read_part(stop, box, solids));
      continue;
    }
    if (below.word != "stop") return script_error(below, "under a train stand its stops and parts");
    stops.push_back({stop.place(box.low.z), stop.number("wait", 0, 0, 3600)});
    TRY_STATUS(stop.finish());
  }
  if (stops.size() < 2) line.complain("it needs two stops at least");
  if (stops.size() >= 2) put_train(line, box, stops, std::move(solids), io_plan);
  return line.finish();
}

// A block that comes down by drop=, waits, and goes up again.
base::Status read_crusher(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Box box = line.box();
  const Looks looks = line.looks(line.to_world(box), "metal1");
  const int drop = line.whole("drop", 64, 8, 4096);
  const double above = line.number("above", 1.5, 0, 60), below = line.number("below", 0.5, 0, 60);
  put_train(line, box, {{box.low, above}, {box.low - Point(0, 0, drop), below}}, {solid_of(line, box, looks)},
            io_plan);
  formats::Entity& train = io_plan.bodies.back().fields;
  if (!line.has("dmg")) set_key(train, "dmg", 40.0);
  if (!line.has("speed")) set_key(train, "speed", 200.0);
  return line.finish();
}

// `button north 64,40 size 32x32` is on the room's north wall; with a box it is there, and pressed that way.
base::Status read_button(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Side press = line.side();
  const Box box =
      line.on_wall_is_next() ? line.box_on_wall(press, line.whole("depth", 8, 2, 64)) : line.box();
  const Looks looks = line.looks(line.to_world(box), "+0button");
  formats::Entity button = entity_of(line, "func_button");
  set_key(button, "angle", move_angle(line, press));
  put_body(std::move(button), {solid_of(line, box, looks)}, io_plan);
  return line.finish();
}

base::Status put_trigger(PlanLine& line, std::string_view classname, int flags, Plan& io_plan) {
  const Box box = line.box_or(line.scope().whole());
  if (!box.has_volume()) line.complain("it has a box, or stands in a room");
  formats::Entity trigger = entity_of(line, classname, flags);
  if (line.has("way")) set_key(trigger, "angle", move_angle(line, line.side("way", Side::kUp)));
  put_body(std::move(trigger), {solid_of(line, box, looks_all("trigger", line.to_world(box)))}, io_plan);
  return line.finish();
}

base::Status read_trigger(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  constexpr std::array<std::string_view, 8> kKinds = {"once", "multiple", "secret",      "hurt",
                                                      "push", "setskill", "monsterjump", "onlyregistered"};
  PlanLine line(script, scope);
  const std::string kind = line.word();
  if (std::find(kKinds.begin(), kKinds.end(), kind) == kKinds.end())
    line.complain(fmt::format("'{}' is none of {}", base::quotable(kind), fmt::join(kKinds, ", ")));
  return put_trigger(line, "trigger_" + kind, 0, io_plan);
}

base::Status read_secret(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  return put_trigger(line, "trigger_secret", 0, io_plan);
}

base::Status read_exit(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  if (!line.has("map")) line.complain("it needs map=, the level that it leads to");
  return put_trigger(line, "trigger_changelevel", line.flag("at_once") ? 1 : 0, io_plan);
}

// A glowing field, and what it does to who enters it: to= an arrival's name, or map= a level's.
base::Status read_teleporter(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Box box = line.box_or(scope.whole());
  if (!box.has_volume()) line.complain("it has a box, or stands in an opening");
  const Box box_world = line.to_world(box);
  const Looks looks = line.looks(box_world, "*tele1");
  if (line.has("to") == line.has("map")) line.complain("it needs to= or map=");
  const std::string to = line.text("to", "");
  io_plan.structure.push_back(solid_of(line, box, looks));
  formats::Entity trigger = entity_of(line, to.empty() ? "trigger_changelevel" : "trigger_teleport",
                                      to.empty() && line.flag("at_once") ? 1 : 0);
  if (!to.empty()) set_key(trigger, "target", to);
  put_body(std::move(trigger), {solid_of(line, box, looks_all("trigger", box_world))}, io_plan);
  return line.finish();
}

// Any class whose shape is a box: `brush func_illusionary 0,0,0 size 64x64x4 vine1`. All its settings are
// keys.
base::Status read_brush(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const std::string classname = line.word();
  const Box box = line.box_or(scope.whole());
  const Looks looks = line.looks(line.to_world(box), "trigger");
  formats::Entity entity = entity_of(line, classname);
  if (line.has("way")) set_key(entity, "angle", move_angle(line, line.side("way", Side::kUp)));
  put_body(std::move(entity), {solid_of(line, box, looks)}, io_plan);
  return line.finish();
}

constexpr PlanWord kMoverWords[] = {
    {"door", read_door},       {"secret_door", read_secret_door}, {"lift", read_lift},
    {"train", read_train},     {"crusher", read_crusher},         {"button", read_button},
    {"trigger", read_trigger}, {"secret", read_secret},           {"exit", read_exit},
    {"brush", read_brush},     {"teleporter", read_teleporter},
};

}  // namespace

std::span<const PlanWord> mover_words() {
  return kMoverWords;
}

}  // namespace temblor::artgen
