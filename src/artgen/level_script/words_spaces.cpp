// Words that make room: rooms, hollows, passages and openings; and those that put a part of a plan in more
// than one place.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "artgen/level_script/words.h"
#include "base/text.h"

namespace temblor::artgen {
namespace {

void add_space(const PlanLine& line, const Box& box, const Surfaces& surfaces, const Box& anchor,
               Plan& io_plan) {
  const Placement& placement = line.scope().placement;
  Space space{placement.apply(box), {}, line.line().number};
  for (const Side side : kSides)
    space.walls[index_of(placement.apply(side))] = {surfaces[index_of(side)], placement.apply(anchor)};
  io_plan.spaces.push_back(std::move(space));
}

Scope scope_within(const PlanLine& line, const Box& box, const Surfaces& surfaces) {
  Placement inner;
  inner.origin = box.low;
  return {line.scope().placement * inner, box.size(), surfaces, line.scope().copy};
}

// The corners of a polygon inscribed in the room, and what lies between it and the room's own corners.
std::vector<std::vector<Point>> corner_wedges(const Box& box, int cut) {
  std::vector<std::vector<Point>> wedges;
  for (int i = 0; i < 4; ++i) {
    const bool east = (i & 1) != 0, north = (i & 2) != 0;
    const Point corner(east ? box.high.x : box.low.x, north ? box.high.y : box.low.y, box.low.z);
    const Point along_x(corner.x + (east ? -cut : cut), corner.y, corner.z);
    const Point along_y(corner.x, corner.y + (north ? -cut : cut), corner.z);
    // Two steps of a twelve-sided room look round enough and stay on whole numbers.
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

base::Status read_room(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const std::string name = line.word();
  const Box box = line.box();
  const std::string like = line.text("like", "");
  Surfaces base = scope.surfaces;
  if (!like.empty()) {
    const auto room = io_plan.rooms.find(like);
    if (room == io_plan.rooms.end())
      line.complain(fmt::format("there is no room '{}' above this line", base::quotable(like)));
    else
      base = room->second.scope.surfaces;
  }
  const Surfaces surfaces = line.surfaces(base);
  const int longest_cut = std::min(box.size().x, box.size().y) / 2;
  const int cut = line.whole("round", 0, 0, std::max(longest_cut, 0));
  for (const Side side : kSides)
    if (surfaces[index_of(side)].empty()) line.complain("it needs floor=, walls= and ceiling=");
  TRY_STATUS(line.finish());

  const Room room{scope_within(line, box, surfaces), line.to_world(box)};
  if (!io_plan.rooms.emplace(name, room).second)
    return script_error(script, fmt::format("there is a room '{}' already", base::quotable(name)));
  add_space(line, box, surfaces, box, io_plan);
  if (cut > 0)
    for (std::vector<Point>& wedge : corner_wedges(box, cut))
      io_plan.structure.push_back(
          solid_of(line, std::move(wedge), looks_all(surfaces[index_of(Side::kNorth)], room.box)));
  return read_lines(script.below, room.scope, io_plan);
}

base::Status read_hollow(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Box box = line.box();
  const Surfaces surfaces = line.surfaces(scope.surfaces);
  const bool own = line.text("align", "self") == "self";
  TRY_STATUS(line.finish());
  if (surfaces.front().empty()) return script_error(script, "it needs floor=, walls= and ceiling=");
  add_space(line, box, surfaces, own ? box : Box{Point(0), scope.size}, io_plan);
  return read_lines(script.below, scope_within(line, box, surfaces), io_plan);
}

// A straight part of a passage: level, or with steps of 16 units cut into the rock.
void add_leg(const PlanLine& line, Point from, Point to, Point half_width_height, const Surfaces& surfaces,
             Plan& io_plan) {
  const int half = half_width_height.x, height = half_width_height.z;
  const int along = from.x != to.x ? 0 : 1;
  const int steps = std::abs(to.z - from.z) / 16 + 1;
  for (int i = 0; i < steps; ++i) {
    Point start = from, stop = to;
    start[along] = from[along] + (to[along] - from[along]) * i / steps;
    stop[along] = from[along] + (to[along] - from[along]) * (i + 1) / steps;
    start.z = stop.z = from.z + (to.z > from.z ? 16 : -16) * i;
    Box box = box_around(start, stop);
    box.low[1 - along] -= half;
    box.high[1 - along] += half;
    box.high.z += height;
    // The ends reach around the corner.
    const bool forward = to[along] > from[along];
    if (i == 0) (forward ? box.low : box.high)[along] -= forward ? half : -half;
    if (i == steps - 1) (forward ? box.high : box.low)[along] += forward ? half : -half;
    add_space(line, box, surfaces, box, io_plan);
  }
}

base::Status read_passage(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const int width = line.whole("width", 96, 34, 1024), height = line.whole("height", 128, 58, 1024);
  const Surfaces surfaces = line.surfaces(scope.surfaces);
  std::vector<Point> way = {line.place()};
  while (const std::optional<std::string> to = line.word_if_there()) {
    if (*to != "to") line.complain(fmt::format("'{}' is not 'to'", base::quotable(*to)));
    way.push_back(line.place(way.back().z));
  }
  if (way.size() < 2) line.complain("it needs two places at least: A to B to C");
  TRY_STATUS(line.finish());
  if (surfaces.front().empty()) return script_error(script, "it needs floor=, walls= and ceiling=");
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Point step = way[i] - way[i - 1];
    if ((step.x != 0) == (step.y != 0))
      return script_error(script, "each part of its way goes north, south, east or west");
    if (std::abs(step.z) % 16 != 0 || std::abs(step.z) > std::abs(step.x + step.y))
      return script_error(script, "it climbs in steps of 16, and not steeper than it goes on");
    add_leg(line, way[i - 1], way[i], {width / 2, 0, height}, surfaces, io_plan);
  }
  return base::Ok{};
}

// Between two rooms of a scope whose walls face each other.
struct Gap {
  Box box;  // of the level: between the walls, as wide and high as both rooms
  int across = 0;
};

std::optional<Gap> gap_between(const Box& a, const Box& b) {
  for (int axis = 0; axis < 2; ++axis) {
    const bool a_first = a.high[axis] <= b.low[axis];
    if (!a_first && b.high[axis] > a.low[axis]) continue;
    Box box = common(a, b);
    box.low[axis] = a_first ? a.high[axis] : b.high[axis];
    box.high[axis] = a_first ? b.low[axis] : a.low[axis];
    const Box thick = grown(box, 1);
    if (box.low[1 - axis] < box.high[1 - axis] && thick.has_volume()) return Gap{box, axis};
  }
  return {};
}

const Room* room_named(PlanLine& line, const Plan& plan) {
  const std::string name = line.word();
  const auto found = plan.rooms.find(name);
  if (found != plan.rooms.end()) return &found->second;
  line.complain(fmt::format("there is no room '{}' above this line", base::quotable(name)));
  return nullptr;
}

// A border around the hole, on the sides of both rooms.
void add_frame(PlanLine& line, const Box& hole, int across, const std::string& texture, int wide,
               Plan& io_plan) {
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
    for (const Box& piece : without(layer, cut))
      solids.push_back({corners_of(piece), looks_all(texture, piece), line.line().number});
  }
  put_solids(line, std::move(solids), "detail", io_plan);
}

base::Status read_opening(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Room* a = room_named(line, io_plan);
  const Room* b = room_named(line, io_plan);
  const int width = line.whole("width", 96, 1, 4096), height = line.whole("height", 128, 1, 4096);
  const int sill = line.whole("sill", 0, 0, 4096), at = line.whole("at", 0, -4096, 4096);
  const std::string frame = line.text("frame", "");
  const int frame_wide = line.whole("frame_width", 16, 4, 64);
  if (a == nullptr || b == nullptr) return line.finish();
  const Surfaces surfaces = line.surfaces(a->scope.surfaces);
  const std::optional<Gap> gap = gap_between(a->box, b->box);
  if (!gap) {
    line.complain("the rooms have no walls that face each other");
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
    line.complain(
        fmt::format("it is {} wide and up to {} high at {} from the middle; both rooms have {} by {}", width,
                    sill + height, at, gap->box.size()[other], gap->box.size().z));
  if (!frame.empty()) add_frame(line, hole, gap->across, frame, frame_wide, io_plan);
  TRY_STATUS(line.finish());
  const Scope level;
  if (hole.has_volume()) add_space(PlanLine(script, level), hole, surfaces, hole, io_plan);
  Placement placement;
  placement.origin = hole.low;
  return read_lines(script.below, {placement, hole.size(), surfaces, scope.copy}, io_plan);
}

// Known already: collect_groups.
base::Status read_group(const ScriptLine& script, const Scope& scope, Plan&) {
  PlanLine line(script, scope);
  line.word();
  return line.finish();
}

Scope copied(const Scope& scope, const std::string& copy) {
  Scope inner = scope;
  inner.copy = scope.copy.empty() ? copy : scope.copy + "_" + copy;
  return inner;
}

base::Status read_place(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const std::string name = line.word();
  Placement inner;
  inner.origin = line.place();
  inner.quarter_turns = line.whole("turn", 0, 0, 270) / 90;
  if (line.whole("turn", 0, 0, 270) % 90 != 0) line.complain("turn= is 0, 90, 180 or 270");
  inner.mirrored = line.flag("mirror");
  Scope scope_inner = copied(scope, line.text("copy", ""));
  if (!line.has("copy")) scope_inner.copy = scope.copy;
  scope_inner.surfaces = line.surfaces(scope.surfaces);
  TRY_STATUS(line.finish());
  const auto group = io_plan.groups.find(name);
  if (group == io_plan.groups.end())
    return script_error(script, fmt::format("there is no group '{}'", base::quotable(name)));
  scope_inner.placement = scope.placement * inner;
  const ScriptLine* lines = group->second;
  io_plan.groups.erase(group);  // so that it can't hold itself
  const base::Status read = read_lines(lines->below, scope_inner, io_plan);
  io_plan.groups.emplace(name, lines);
  return read;
}

base::Status read_repeat(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const std::string count = line.word();
  const Point step = line.place("step", Point(0));
  if (!line.has("step")) line.complain("it needs step=X,Y or X,Y,Z");
  int times = 0;
  for (const char c : count) times = c >= '0' && c <= '9' && times < 1000 ? times * 10 + (c - '0') : 10000;
  if (times < 1 || times > 256) line.complain("how often? A number from 1 to 256");
  TRY_STATUS(line.finish());
  for (int i = 0; i < times; ++i) {
    Scope inner = copied(scope, fmt::format("{}", i + 1));
    Placement shift;
    shift.origin = step * i;
    inner.placement = scope.placement * shift;
    TRY_STATUS(read_lines(script.below, inner, io_plan));
  }
  return base::Ok{};
}

// What is below, and once more as in a mirror: x=256 is a mirror that faces east and west.
base::Status read_mirror(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const bool along_x = line.has("x");
  if (along_x == line.has("y")) line.complain("it needs x= or y=, where the mirror stands");
  const Point middle = scope.size / 2;
  const std::string at = line.text(along_x ? "x" : "y", "0");
  int where = along_x ? middle.x : middle.y;
  if (at != "mid") where = line.whole(along_x ? "x" : "y", 0, -16384, 16384);
  TRY_STATUS(line.finish());
  TRY_STATUS(read_lines(script.below, copied(scope, "1"), io_plan));
  Scope inner = copied(scope, "2");
  Placement mirror;
  mirror.mirrored = true;
  mirror.quarter_turns = along_x ? 0 : 2;
  mirror.origin = along_x ? Point(2 * where, 0, 0) : Point(0, 2 * where, 0);
  inner.placement = scope.placement * mirror;
  return read_lines(script.below, inner, io_plan);
}

constexpr PlanWord kSpaceWords[] = {
    {"room", read_room},   {"hollow", read_hollow}, {"passage", read_passage}, {"opening", read_opening},
    {"group", read_group}, {"place", read_place},   {"repeat", read_repeat},   {"mirror", read_mirror},
};

}  // namespace

base::Status collect_groups(const std::vector<ScriptLine>& lines, Plan& io_plan) {
  for (const ScriptLine& line : lines) {
    if (line.word != "group" || line.values.empty()) continue;
    if (!io_plan.groups.emplace(line.values.front(), &line).second)
      return script_error(line,
                          fmt::format("there is a group '{}' already", base::quotable(line.values.front())));
  }
  return base::Ok{};
}

std::span<const PlanWord> space_words() {
  return kSpaceWords;
}

}  // namespace temblor::artgen
