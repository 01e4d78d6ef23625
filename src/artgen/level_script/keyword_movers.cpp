// Keywords for brush entities: doors, lifts, trains, buttons, triggers.
#include <fmt/format.h>

#include <algorithm>

#include "artgen/level_script/keywords.h"
#include "base/text.h"

namespace temblor::artgen {
namespace {

constexpr int kDoorThick = 16;

// A door in the middle of an opening, across its shorter horizontal axis.
Box make_door_box(const Scope& scope, int thick) {
  Box box = scope.bounds();
  const int axis = scope.size.x <= scope.size.y ? 0 : 1;
  const int middle = scope.size[axis] / 2;
  box.low[axis] = middle - thick / 2;
  box.high[axis] = box.low[axis] + thick;
  return box;
}

// The spawnflag of a door that needs a key.
int read_key_flag(LevelScriptLine& line) {
  const std::string key = line.text("key", "");
  if (key == "gold") return 8;
  if (key == "silver") return 16;
  if (!key.empty()) line.set_error("key= must be gold or silver");
  return 0;
}

// One leaf that moves in `direction`.
void add_door(LevelScriptLine& line, const Box& leaf, Side direction, const std::string& texture, int flags,
              LevelScript& io_script) {
  const Looks looks = make_uniform_looks(texture, line.to_world(leaf));
  formats::Entity door = make_entity(line, "func_door", flags);
  set_key(door, "angle", find_move_angle(line, direction));
  add_brush_entity(std::move(door), {make_solid(line, leaf, looks)}, io_script);
}

// `door [BOX] [TEXTURE] move=up double=yes key=gold`. double=yes makes two leaves that move apart.
base::Status read_door(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const int thick = line.integer("thick", kDoorThick, 2, 128);
  if (!line.is_box_next() && scope.size == Point(0))
    line.set_error("expected a box (X,Y,Z to X,Y,Z), or an opening above this line");
  const Box box = line.box_or(make_door_box(scope, thick));
  const std::string texture = line.next_text_if_present().value_or("door1");
  const int flags = read_key_flag(line) + (line.flag("toggle") ? 32 : 0) + (line.flag("open") ? 1 : 0) +
                    (line.flag("alone") ? 4 : 0);
  const Side move = line.side("move", Side::kUp);
  if (!line.flag("double")) {
    add_door(line, box, move, texture, flags, io_script);
    return line.finish();
  }
  const int axis = box.size().x >= box.size().y ? 0 : 1;
  for (const bool upper : {false, true}) {
    Box leaf = box;
    (upper ? leaf.low : leaf.high)[axis] = (box.low[axis] + box.high[axis]) / 2;
    add_door(line, leaf, static_cast<Side>(2 * axis + (upper ? 0 : 1)), texture, flags, io_script);
  }
  return line.finish();
}

// A piece of wall that first moves down or sideways (first=) and then in the direction of move=. open=shot
// lets any hit open it; otherwise something must target its name=.
base::Status read_secret_door(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Box box = line.box_or(scope.bounds());
  if (!box.has_volume()) line.set_error("expected a box (X,Y,Z to X,Y,Z), or an opening above this line");
  const Looks looks = line.looks(line.to_world(box), scope.surfaces[side_index(Side::kNorth)]);
  const Side first = line.side("first", Side::kDown);
  const Side then = line.side("move", Side::kNorth);
  if (side_axis(then) == 2)
    line.set_error("move= must be north, east, south or west: the second leg of the door's path");
  formats::Entity door = make_entity(line, "func_door_secret", first == Side::kDown ? 4 : 0);
  // The key "angle" is the direction of the second movement. Without the spawnflag 4, the first one is to the
  // right of it, or with spawnflag 2 to the left.
  set_key(door, "angle", find_move_angle(line, then));
  if (first != Side::kDown) {
    const Side direction = scope.placement.apply(first), angle = scope.placement.apply(then);
    const Placement right{Point(0), 3, false};
    if (side_axis(first) == 2 || side_axis(first) == side_axis(then))
      line.set_error("first= must be down, or at a right angle to move=");
    else if (direction != right.apply(angle))
      set_key(door, "spawnflags", 2 + line.integer("flags", 0, 0, 255));
  }
  if (line.has("far")) set_key(door, "t_length", line.integer("far", 0, 1, 4096));
  if (line.has("back")) set_key(door, "t_width", line.integer("back", 0, 1, 4096));
  add_brush_entity(std::move(door), {make_solid(line, box, looks)}, io_script);
  return line.finish();
}

// The box is the upper position; the lift waits drop= units below.
base::Status read_lift(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Box box = line.box();
  const Looks looks = line.looks(line.to_world(box), "metal1");
  formats::Entity lift = make_entity(line, "func_plat", line.flag("low_trigger") ? 1 : 0);
  if (line.has("drop")) set_key(lift, "height", line.integer("drop", 0, 8, 8192));
  add_brush_entity(std::move(lift), {make_solid(line, box, looks)}, io_script);
  return line.finish();
}

void add_path_corner(const LevelScriptLine& line, const Box& box_there, const std::string& name,
                     const std::string& next, double wait, LevelScript& io_script) {
  PointEntity corner;
  set_key(corner.fields, "classname", "path_corner");
  set_key(corner.fields, "targetname", name);
  set_key(corner.fields, "target", next);
  if (wait != 0) set_key(corner.fields, "wait", wait);
  corner.origin = line.to_world(box_there).low;
  // Not checked: it may be inside a wall.
  corner.line = -1;
  corner.keyword = "stop";
  io_script.point_entities.push_back(std::move(corner));
}

// A stop of a train: the position of its lower corner, and how long it waits there in seconds.
struct Stop {
  Point low;
  double wait = 0;
};

// Adds a train and a circle of path corners. After the last stop it returns to the first one.
void add_train(LevelScriptLine& line, const Box& box, const std::vector<Stop>& stops,
               std::vector<Solid> solids, LevelScript& io_script) {
  const std::string track = fmt::format("track{}", ++io_script.generated_names);
  const auto stop_name = [&](std::size_t i) { return fmt::format("{}_{}", track, i % stops.size()); };
  formats::Entity train = make_entity(line, "func_train");
  set_key(train, "target", stop_name(0));
  add_brush_entity(std::move(train), std::move(solids), io_script);
  for (std::size_t i = 0; i < stops.size(); ++i)
    add_path_corner(line, {stops[i].low, stops[i].low + box.size()}, stop_name(i), stop_name(i + 1),
                    stops[i].wait, io_script);
}

// Another solid of the same entity.
base::Status read_part(LevelScriptLine& part, std::string_view default_texture,
                       std::vector<Solid>& io_solids) {
  const Box box = part.box();
  io_solids.push_back(make_solid(part, box, part.looks(part.to_world(box), default_texture)));
  return part.finish();
}

// Walls or a load. A train's position is the lower corner of all its solids, so none may extend below the
// corner of the first box.
base::Status read_train_part(const ScriptLine& script_line, const Scope& scope, const Box& train,
                             std::vector<Solid>& io_solids) {
  LevelScriptLine corner(script_line, scope), part(script_line, scope);
  const Point low = corner.box().low;
  for (int axis = 0; axis < 3; ++axis)
    if (low[axis] < train.low[axis]) {
      part.set_error("it reaches farther west, south or down than the train's own box");
      break;
    }
  return read_part(part, "metal1", io_solids);
}

base::Status read_train(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Box box = line.box();
  const Looks looks = line.looks(line.to_world(box), "metal1");
  std::vector<Solid> solids = {make_solid(line, box, looks)};
  std::vector<Stop> stops;
  for (const ScriptLine& below : script_line.below) {
    if (below.keyword == "part") {
      TRY_STATUS(read_train_part(below, scope, box, solids));
      continue;
    }
    if (below.keyword != "stop")
      return script_error(below, "only 'stop' and 'part' lines can be under a train");
    LevelScriptLine stop(below, scope);
    stops.push_back({stop.position(box.low.z), stop.number("wait", 0, 0, 3600)});
    TRY_STATUS(stop.finish());
  }
  if (stops.size() < 2) line.set_error("a train needs at least two stops");
  if (stops.size() >= 2) add_train(line, box, stops, std::move(solids), io_script);
  return line.finish();
}

// A train that moves down by drop=, waits, and moves up again.
base::Status read_crusher(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Box box = line.box();
  const Looks looks = line.looks(line.to_world(box), "metal1");
  const int drop = line.integer("drop", 64, 8, 4096);
  const double above = line.number("above", 1.5, 0, 60), below = line.number("below", 0.5, 0, 60);
  add_train(line, box, {{box.low, above}, {box.low - Point(0, 0, drop), below}},
            {make_solid(line, box, looks)}, io_script);
  formats::Entity& train = io_script.brush_entities.back().fields;
  if (!line.has("dmg")) set_key(train, "dmg", 40.0);
  if (!line.has("speed")) set_key(train, "speed", 200.0);
  return line.finish();
}

// `button north 64,40 size 32x32` is on the room's north wall. With a full box, it is there and is pressed
// northward.
base::Status read_button(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Side press = line.side();
  const Box box =
      line.is_wall_position_next() ? line.wall_box(press, line.integer("depth", 8, 2, 64)) : line.box();
  const Looks looks = line.looks(line.to_world(box), "+0button");
  formats::Entity button = make_entity(line, "func_button");
  set_key(button, "angle", find_move_angle(line, press));
  add_brush_entity(std::move(button), {make_solid(line, box, looks)}, io_script);
  return line.finish();
}

// The box is optional in a room; the trigger then fills it.
base::Status add_trigger(LevelScriptLine& line, std::string_view classname, int flags,
                         LevelScript& io_script) {
  const Box box = line.box_or(line.scope().bounds());
  if (!box.has_volume()) line.set_error("expected a box (X,Y,Z to X,Y,Z), or a room above this line");
  formats::Entity trigger = make_entity(line, classname, flags);
  if (line.has("way")) set_key(trigger, "angle", find_move_angle(line, line.side("way", Side::kUp)));
  add_brush_entity(std::move(trigger),
                   {make_solid(line, box, make_uniform_looks("trigger", line.to_world(box)))}, io_script);
  return line.finish();
}

base::Status read_trigger(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  constexpr std::array<std::string_view, 8> kKinds = {"once", "multiple", "secret",      "hurt",
                                                      "push", "setskill", "monsterjump", "onlyregistered"};
  LevelScriptLine line(script_line, scope);
  const std::string kind = line.next_text();
  if (std::find(kKinds.begin(), kKinds.end(), kind) == kKinds.end())
    line.set_error(fmt::format("'{}' is not one of {}", base::quotable(kind), fmt::join(kKinds, ", ")));
  return add_trigger(line, "trigger_" + kind, 0, io_script);
}

base::Status read_secret(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  return add_trigger(line, "trigger_secret", 0, io_script);
}

base::Status read_exit(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  if (!line.has("map")) line.set_error("map= (the level it leads to) is required");
  return add_trigger(line, "trigger_changelevel", line.flag("at_once") ? 1 : 0, io_script);
}

// A glowing field and a trigger in it: to= names an arrival, map= another level.
base::Status read_teleporter(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Box box = line.box_or(scope.bounds());
  if (!box.has_volume()) line.set_error("expected a box (X,Y,Z to X,Y,Z), or an opening above this line");
  const Box box_world = line.to_world(box);
  const Looks looks = line.looks(box_world, "*tele1");
  if (line.has("to") == line.has("map"))
    line.set_error("to= (an arrival) or map= (a level) is required, not both");
  const std::string to = line.text("to", "");
  io_script.structure.push_back(make_solid(line, box, looks));
  formats::Entity trigger = make_entity(line, to.empty() ? "trigger_changelevel" : "trigger_teleport",
                                        to.empty() && line.flag("at_once") ? 1 : 0);
  if (!to.empty()) set_key(trigger, "target", to);
  add_brush_entity(std::move(trigger), {make_solid(line, box, make_uniform_looks("trigger", box_world))},
                   io_script);
  return line.finish();
}

// A brush entity of any class: `brush func_illusionary 0,0,0 size 64x64x4 vine1`. Settings become keys as for
// make_entity. Lines `part BOX TEXTURE` below it add solids.
base::Status read_brush(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const std::string classname = line.next_text();
  const Box box = line.box_or(scope.bounds());
  std::vector<Solid> solids = {make_solid(line, box, line.looks(line.to_world(box), "trigger"))};
  for (const ScriptLine& below : script_line.below) {
    if (below.keyword != "part") return script_error(below, "only 'part' lines can be under a brush entity");
    LevelScriptLine part(below, scope);
    TRY_STATUS(read_part(part, "trigger", solids));
  }
  formats::Entity entity = make_entity(line, classname);
  if (line.has("way")) set_key(entity, "angle", find_move_angle(line, line.side("way", Side::kUp)));
  add_brush_entity(std::move(entity), std::move(solids), io_script);
  return line.finish();
}

constexpr LevelKeyword kMoverKeywords[] = {
    {"door", read_door},       {"secret_door", read_secret_door}, {"lift", read_lift},
    {"train", read_train},     {"crusher", read_crusher},         {"button", read_button},
    {"trigger", read_trigger}, {"secret", read_secret},           {"exit", read_exit},
    {"brush", read_brush},     {"teleporter", read_teleporter},
};

}  // namespace

std::span<const LevelKeyword> mover_keywords() {
  return kMoverKeywords;
}

}  // namespace temblor::artgen
