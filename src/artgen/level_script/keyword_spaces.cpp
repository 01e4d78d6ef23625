// Keywords that make space: rooms, hollows, passages, and openings; and those that place lines more than
// once: groups, repetitions, and mirrors.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "artgen/level_script/keywords.h"
#include "base/text.h"

namespace temblor::artgen {
namespace {

// `anchor` aligns the textures of its walls.
void add_space(const LevelScriptLine& line, const Box& box, const Surfaces& surfaces, const Box& anchor,
               LevelScript& io_script) {
  const Placement& placement = line.scope().placement;
  Space space{placement.apply(box), {}, line.line().number};
  for (const Side side : kSides)
    space.walls[side_index(placement.apply(side))] = {surfaces[side_index(side)], placement.apply(anchor)};
  io_script.spaces.push_back(std::move(space));
}

// The scope of lines inside a box: its lower corner is the origin.
Scope make_inner_scope(const LevelScriptLine& line, const Box& box, const Surfaces& surfaces) {
  Placement inner;
  inner.origin = box.low;
  return {line.scope().placement * inner, box.size(), surfaces, line.scope().copy};
}

// Solids that round the four vertical corners of a room: two wedges for each corner, `cut` units along the
// walls.
std::vector<std::vector<Point>> make_corner_wedges(const Box& box, int cut) {
  std::vector<std::vector<Point>> wedges;
  for (int i = 0; i < 4; ++i) {
    const bool east = (i & 1) != 0, north = (i & 2) != 0;
    const Point corner(east ? box.high.x : box.low.x, north ? box.high.y : box.low.y, box.low.z);
    const Point along_x(corner.x + (east ? -cut : cut), corner.y, corner.z);
    const Point along_y(corner.x, corner.y + (north ? -cut : cut), corner.z);
    // Two segments per corner (a twelve-sided room) look round enough and have whole coordinates.
    const int bulge = cut / 4;
    const Point middle(corner.x + (east ? -bulge : bulge), corner.y + (north ? -bulge : bulge), corner.z);
    for (const Point& end : {along_x, along_y}) {
      std::vector<Point> wedge = {corner, middle, end};
      for (int k = 0; k < 3; ++k)
        wedge.push_back(
            {wedge[static_cast<std::size_t>(k)].x, wedge[static_cast<std::size_t>(k)].y, box.high.z});
      wedges.push_back(std::move(wedge));
    }
  }
  return wedges;
}

// `room NAME BOX like=OTHER round=64`: a space with a name and lines inside.
base::Status read_room(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const std::string name = line.next_text();
  const Box box = line.box();
  const std::string like = line.text("like", "");
  Surfaces base = scope.surfaces;
  if (!like.empty()) {
    const auto room = io_script.rooms.find(like);
    if (room == io_script.rooms.end())
      line.set_error(fmt::format("no room '{}' is defined above this line", base::quotable(like)));
    else
      base = room->second.scope.surfaces;
  }
  const Surfaces surfaces = line.surfaces(base);
  const int longest_cut = std::min(box.size().x, box.size().y) / 2;
  const int cut = line.integer("round", 0, 0, std::max(longest_cut, 0));
  for (const Side side : kSides)
    if (surfaces[side_index(side)].empty()) line.set_error("floor=, walls= and ceiling= are required");
  TRY_STATUS(line.finish());

  const Room room{make_inner_scope(line, box, surfaces), line.to_world(box)};
  if (!io_script.rooms.emplace(name, room).second)
    return script_error(script_line, fmt::format("room '{}' is already defined", base::quotable(name)));
  add_space(line, box, surfaces, box, io_script);
  if (cut > 0)
    for (std::vector<Point>& wedge : make_corner_wedges(box, cut))
      io_script.structure.push_back(make_solid(
          line, std::move(wedge), make_uniform_looks(surfaces[side_index(Side::kNorth)], room.box)));
  return read_lines(script_line.below, room.scope, io_script);
}

// `hollow BOX`: a space without a name, such as a niche. align=room continues the room's textures.
base::Status read_hollow(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Box box = line.box();
  const Surfaces surfaces = line.surfaces(scope.surfaces);
  const bool own = line.text("align", "self") == "self";
  TRY_STATUS(line.finish());
  if (surfaces.front().empty()) return script_error(script_line, "floor=, walls= and ceiling= are required");
  add_space(line, box, surfaces, own ? box : Box{Point(0), scope.size}, io_script);
  return read_lines(script_line.below, make_inner_scope(line, box, surfaces), io_script);
}

// A straight part of a passage: level, or with steps of 16 units.
void add_leg(const LevelScriptLine& line, Point from, Point to, Point half_width_height,
             const Surfaces& surfaces, LevelScript& io_script) {
  const int half = half_width_height.x, height = half_width_height.z;
  const int along = from.x != to.x ? 0 : 1;
  const int steps = std::abs(to.z - from.z) / 16 + 1;
  for (int i = 0; i < steps; ++i) {
    Point start = from, stop = to;
    start[along] = from[along] + (to[along] - from[along]) * i / steps;
    stop[along] = from[along] + (to[along] - from[along]) * (i + 1) / steps;
    start.z = stop.z = from.z + (to.z > from.z ? 16 : -16) * i;
    Box box = make_bounding_box(start, stop);
    box.low[1 - along] -= half;
    box.high[1 - along] += half;
    box.high.z += height;
    // The first and last step extend by half a width, so that legs meet in a full corner.
    const bool forward = to[along] > from[along];
    if (i == 0) (forward ? box.low : box.high)[along] -= forward ? half : -half;
    if (i == steps - 1) (forward ? box.high : box.low)[along] += forward ? half : -half;
    add_space(line, box, surfaces, box, io_script);
  }
}

// `passage A to B to C width=96 height=128`: a corridor along the floor positions.
base::Status read_passage(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const int width = line.integer("width", 96, 34, 1024), height = line.integer("height", 128, 58, 1024);
  const Surfaces surfaces = line.surfaces(scope.surfaces);
  std::vector<Point> path = {line.position()};
  while (const std::optional<std::string> to = line.next_text_if_present()) {
    if (*to != "to") line.set_error(fmt::format("'{}' is not 'to'", base::quotable(*to)));
    path.push_back(line.position(path.back().z));
  }
  if (path.size() < 2) line.set_error("a passage needs at least two positions: A to B to C");
  TRY_STATUS(line.finish());
  if (surfaces.front().empty()) return script_error(script_line, "floor=, walls= and ceiling= are required");
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Point step = path[i] - path[i - 1];
    if ((step.x != 0) == (step.y != 0))
      return script_error(script_line, "each leg must run north, south, east or west");
    if (std::abs(step.z) % 16 != 0 || std::abs(step.z) > std::abs(step.x + step.y))
      return script_error(script_line, "each leg must climb in steps of 16 and by no more than its length");
    add_leg(line, path[i - 1], path[i], {width / 2, 0, height}, surfaces, io_script);
  }
  return base::Ok{};
}

// The wall between two rooms that face each other: a box in the level's coordinates, as wide and high as both
// rooms' common part. `across` is the axis through the wall.
struct Gap {
  Box box;
  int across = 0;
};

// Nothing if the rooms do not face each other. Rooms may touch; the gap then has no depth.
std::optional<Gap> find_gap(const Box& a, const Box& b) {
  for (int axis = 0; axis < 2; ++axis) {
    const bool a_first = a.high[axis] <= b.low[axis];
    if (!a_first && b.high[axis] > a.low[axis]) continue;
    Box box = intersect(a, b);
    box.low[axis] = a_first ? a.high[axis] : b.high[axis];
    box.high[axis] = a_first ? b.low[axis] : a.low[axis];
    const Box thick = grow_box(box, 1);
    if (box.low[1 - axis] < box.high[1 - axis] && thick.has_volume()) return Gap{box, axis};
  }
  return {};
}

const Room* find_room(LevelScriptLine& line, const LevelScript& script) {
  const std::string name = line.next_text();
  const auto found = script.rooms.find(name);
  if (found != script.rooms.end()) return &found->second;
  line.set_error(fmt::format("no room '{}' is defined above this line", base::quotable(name)));
  return nullptr;
}

// A border around the hole that protrudes into both rooms.
void add_frame(LevelScriptLine& line, const Box& hole, int across, const std::string& texture, int wide,
               LevelScript& io_script) {
  constexpr int kProud = 8;
  Box outer = hole;
  outer.low[1 - across] -= wide;
  outer.high[1 - across] += wide;
  outer.high.z += wide;
  std::vector<Solid> solids;
  for (const bool upper : {false, true}) {
    Box layer = outer;
    (upper ? layer.low : layer.high)[across] = upper ? hole.high[across] : hole.low[across];
    (upper ? layer.high : layer.low)[across] += upper ? kProud : -kProud;
    Box cut = hole;
    cut.low[across] = layer.low[across];
    cut.high[across] = layer.high[across];
    for (const Box& piece : subtract(layer, cut))
      solids.push_back({list_corners(piece), make_uniform_looks(texture, piece), line.line().number});
  }
  add_solids(line, std::move(solids), "detail", io_script);
}

// `opening ROOM ROOM width=96 height=128`: a hole in the wall between two rooms. Lines below it have the hole
// as their scope, so that they can place a door in it.
base::Status read_opening(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Room* a = find_room(line, io_script);
  const Room* b = find_room(line, io_script);
  const int width = line.integer("width", 96, 1, 4096), height = line.integer("height", 128, 1, 4096);
  const int sill = line.integer("sill", 0, 0, 4096), at = line.integer("at", 0, -4096, 4096);
  const std::string frame = line.text("frame", "");
  const int frame_wide = line.integer("frame_width", 16, 4, 64);
  if (a == nullptr || b == nullptr) return line.finish();
  const Surfaces surfaces = line.surfaces(a->scope.surfaces);
  const std::optional<Gap> gap = find_gap(a->box, b->box);
  if (!gap) {
    line.set_error("the two rooms have no walls that face each other");
    return line.finish();
  }
  const int other = 1 - gap->across;
  Box hole = gap->box;
  const int middle = (hole.low[other] + hole.high[other]) / 2 + at;
  hole.low[other] = middle - width / 2;
  hole.high[other] = hole.low[other] + width;
  hole.low.z += sill;
  hole.high.z = hole.low.z + height;
  if (hole.low[other] < gap->box.low[other] || hole.high[other] > gap->box.high[other] ||
      hole.high.z > gap->box.high.z)
    line.set_error(fmt::format(
        "it is {} wide, reaches {} high and is {} off the middle; the rooms' common wall is {} by {}", width,
        sill + height, at, gap->box.size()[other], gap->box.size().z));
  if (!frame.empty()) add_frame(line, hole, gap->across, frame, frame_wide, io_script);
  TRY_STATUS(line.finish());
  const Scope level;
  if (hole.has_volume()) add_space(LevelScriptLine(script_line, level), hole, surfaces, hole, io_script);
  Placement placement;
  placement.origin = hole.low;
  return read_lines(script_line.below, {placement, hole.size(), surfaces, scope.copy}, io_script);
}

// collect_groups has registered it already.
base::Status read_group(const ScriptLine& script_line, const Scope& scope, LevelScript&) {
  LevelScriptLine line(script_line, scope);
  line.next_text();
  return line.finish();
}

// Nested copies join their names: "1_2".
Scope make_copy_scope(const Scope& scope, const std::string& copy) {
  Scope inner = scope;
  inner.copy = scope.copy.empty() ? copy : scope.copy + "_" + copy;
  return inner;
}

// `place GROUP X,Y,Z turn=90 mirror=yes copy=A`: reads the lines of a group in a transformed scope.
base::Status read_place(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const std::string name = line.next_text();
  Placement inner;
  inner.origin = line.position();
  inner.quarter_turns = line.integer("turn", 0, 0, 270) / 90;
  if (line.integer("turn", 0, 0, 270) % 90 != 0) line.set_error("turn= must be 0, 90, 180 or 270");
  inner.mirrored = line.flag("mirror");
  Scope scope_inner = make_copy_scope(scope, line.text("copy", ""));
  if (!line.has("copy")) scope_inner.copy = scope.copy;
  scope_inner.surfaces = line.surfaces(scope.surfaces);
  TRY_STATUS(line.finish());
  const auto group = io_script.groups.find(name);
  if (group == io_script.groups.end())
    return script_error(script_line, fmt::format("no group is named '{}'", base::quotable(name)));
  scope_inner.placement = scope.placement * inner;
  const ScriptLine* lines = group->second;
  // So that a group cannot place itself.
  io_script.groups.erase(group);
  const base::Status read = read_lines(lines->below, scope_inner, io_script);
  io_script.groups.emplace(name, lines);
  return read;
}

// `repeat COUNT step=X,Y`: reads the lines below COUNT times, each moved by one more step. $ is the number,
// from 1.
base::Status read_repeat(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const std::string count = line.next_text();
  const Point step = line.position("step", Point(0));
  if (!line.has("step")) line.set_error("step=X,Y or step=X,Y,Z is required");
  int times = 0;
  for (const char c : count) times = c >= '0' && c <= '9' && times < 1000 ? times * 10 + (c - '0') : 10000;
  if (times < 1 || times > 256) line.set_error("the repeat count must be from 1 to 256");
  TRY_STATUS(line.finish());
  for (int i = 0; i < times; ++i) {
    Scope inner = make_copy_scope(scope, fmt::format("{}", i + 1));
    Placement shift;
    shift.origin = step * i;
    inner.placement = scope.placement * shift;
    TRY_STATUS(read_lines(script_line.below, inner, io_script));
  }
  return base::Ok{};
}

// Reads the lines below twice, once mirrored. x=256 is a mirror plane that is perpendicular to the x axis.
base::Status read_mirror(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const bool along_x = line.has("x");
  if (along_x == line.has("y")) line.set_error("x= or y= (the position of the mirror) is required");
  const Point middle = scope.size / 2;
  const std::string at = line.text(along_x ? "x" : "y", "0");
  int where = along_x ? middle.x : middle.y;
  if (at != "mid") where = line.integer(along_x ? "x" : "y", 0, -16384, 16384);
  TRY_STATUS(line.finish());
  TRY_STATUS(read_lines(script_line.below, make_copy_scope(scope, "1"), io_script));
  Scope inner = make_copy_scope(scope, "2");
  Placement mirror;
  mirror.mirrored = true;
  mirror.quarter_turns = along_x ? 0 : 2;
  mirror.origin = along_x ? Point(2 * where, 0, 0) : Point(0, 2 * where, 0);
  inner.placement = scope.placement * mirror;
  return read_lines(script_line.below, inner, io_script);
}

constexpr LevelKeyword kSpaceKeywords[] = {
    {"room", read_room},   {"hollow", read_hollow}, {"passage", read_passage}, {"opening", read_opening},
    {"group", read_group}, {"place", read_place},   {"repeat", read_repeat},   {"mirror", read_mirror},
};

}  // namespace

base::Status collect_groups(const std::vector<ScriptLine>& lines, LevelScript& io_script) {
  for (const ScriptLine& line : lines) {
    if (line.keyword != "group" || line.values.empty()) continue;
    if (!io_script.groups.emplace(line.values.front(), &line).second)
      return script_error(line,
                          fmt::format("group '{}' is already defined", base::quotable(line.values.front())));
  }
  return base::Ok{};
}

std::span<const LevelKeyword> space_keywords() {
  return kSpaceKeywords;
}

}  // namespace temblor::artgen
