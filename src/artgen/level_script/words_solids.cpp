// Words for what stands in a room: blocks, stairs, pillars, arches, railings, pipes, liquids.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "artgen/level_script/words.h"
#include "base/text.h"

namespace temblor::artgen {
namespace {

base::Status read_block(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Box box = line.box();
  const Looks looks = line.looks(line.to_world(box), scope.surfaces[index_of(Side::kNorth)]);
  put_solids(line, {solid_of(line, box, looks)}, "detail", io_plan);
  return line.finish();
}

// Any convex body, by its corners.
base::Status read_hull(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  std::vector<Point> corners;
  while (line.box_is_next()) corners.push_back(line.place());
  if (corners.size() < 4 || corners.size() > 64) {
    line.complain("it has from 4 to 64 corners, each X,Y,Z");
    return line.finish();
  }
  const Looks looks = line.looks(line.to_world(bounds_of(corners)), scope.surfaces[index_of(Side::kNorth)]);
  if (hull_of(corners).empty()) line.complain("its corners lie in one plane");
  put_solids(line, {solid_of(line, std::move(corners), looks)}, "detail", io_plan);
  return line.finish();
}

// A block whose top rises from nothing at one side to its height at the other.
base::Status read_ramp(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Box box = line.box();
  const Side up = line.side("up", Side::kNorth);
  if (axis_of(up) == 2) line.complain("up= is a compass point");
  const Looks looks = line.looks(line.to_world(box), scope.surfaces[index_of(Side::kDown)]);
  std::vector<Point> corners;
  for (const Point& corner : corners_of(box))
    if (corner.z == box.low.z || corner[axis_of(up)] == box.at(up)) corners.push_back(corner);
  put_solids(line, {solid_of(line, std::move(corners), looks)}, "detail", io_plan);
  return line.finish();
}

base::Status read_stairs(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Box box = line.box();
  const Side up = line.side("up", Side::kNorth);
  if (axis_of(up) == 2) line.complain("up= is a compass point");
  const int rise = line.whole("rise", 16, 4, 64);
  const bool hanging = line.flag("hanging");
  const Looks looks = line.looks(line.to_world(box), scope.surfaces[index_of(Side::kDown)]);
  const int steps = std::max(1, (box.size().z + rise - 1) / rise);
  const int axis = axis_of(up) % 2, length = box.size()[axis];
  std::vector<Solid> solids;
  for (int i = 0; i < steps; ++i) {
    Box step = box;
    const int from = length * i / steps, to = hanging ? length * (i + 1) / steps : length;
    step.low[axis] = is_upper(up) ? box.low[axis] + from : box.high[axis] - to;
    step.high[axis] = is_upper(up) ? box.low[axis] + to : box.high[axis] - from;
    step.high.z = std::min(box.high.z, box.low.z + rise * (i + 1));
    step.low.z = hanging ? step.high.z - rise : box.low.z + rise * i;
    // Each step's riser shows its texture from its own foot.
    Looks own = looks;
    for (Look& look : own) look.anchor = line.to_world(step);
    if (step.has_volume()) solids.push_back(solid_of(line, step, own));
  }
  put_solids(line, std::move(solids), "detail", io_plan);
  return line.finish();
}

// The corners of a regular polygon with two sides to the north and south.
std::vector<Point> polygon(Point middle, double radius, int sides) {
  std::vector<Point> corners;
  const double outer = radius / std::cos(std::numbers::pi / sides);
  for (int i = 0; i < sides; ++i) {
    const double angle = (2 * i + 1) * std::numbers::pi / sides;
    corners.push_back({middle.x + static_cast<int>(std::lround(outer * std::cos(angle))),
                       middle.y + static_cast<int>(std::lround(outer * std::sin(angle))), middle.z});
  }
  return corners;
}

std::vector<Point> drum(Point foot, double radius, int sides, int height) {
  std::vector<Point> corners = polygon(foot, radius, sides);
  for (const Point& top : polygon(foot + Point(0, 0, height), radius, sides)) corners.push_back(top);
  return corners;
}

base::Status read_pillar(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Point foot = line.place();
  const int size = line.whole("size", 48, 8, 1024), sides = line.whole("sides", 8, 3, 24);
  const int height = line.whole("height", std::max(scope.size.z - foot.z, 1), 1, 8192);
  const int foot_height = line.whole("foot", 0, 0, 256),
            head_height = line.whole("head", foot_height, 0, 256);
  const int proud = line.whole("proud", 8, 0, 64);
  const Box box{foot - Point(size / 2, size / 2, 0), foot + Point(size / 2, size / 2, height)};
  const Looks looks = line.looks(line.to_world(box), scope.surfaces[index_of(Side::kNorth)]);
  Looks ends = looks;
  for (Look& look : ends) look.texture = line.text("ends", look.texture);
  const double radius = size / 2.0;
  std::vector<Solid> solids;
  const int shaft = height - foot_height - head_height;
  if (shaft < 1) line.complain("foot= and head= leave no height between them");
  const auto add = [&](int from, int tall, double wide, const Looks& look) {
    if (tall > 0) solids.push_back(solid_of(line, drum(foot + Point(0, 0, from), wide, sides, tall), look));
  };
  add(0, foot_height, radius + proud, ends);
  add(foot_height, shaft, radius, looks);
  add(height - head_height, head_height, radius + proud, ends);
  put_solids(line, std::move(solids), "detail", io_plan);
  return line.finish();
}

// Height of an arch of height 1 over the way from one foot (0) to the other (1).
double arch_height(double at, bool pointed) {
  if (!pointed) return std::sqrt(std::max(0.0, 1 - (2 * at - 1) * (2 * at - 1)));
  const double off = 1 - std::min(at, 1 - at);  // the center of each half is the other's foot
  return std::sqrt(std::max(0.0, 1 - off * off)) / std::sqrt(0.75);
}

// Fills what is above the arch that fits the box: along= is the way one goes through.
base::Status read_arch(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Box box = line.box_or(scope.whole());
  const Point size = box.size();
  const std::string along_name = line.text("along", size.x < size.y ? "x" : "y");
  if (along_name != "x" && along_name != "y") line.complain("along= is x or y");
  const int across = along_name == "x" ? 1 : 0;
  const int pieces = line.whole("pieces", 8, 2, 32);
  const bool pointed = line.flag("pointed");
  const Looks looks = line.looks(line.to_world(box), scope.surfaces[index_of(Side::kNorth)]);
  const auto at = [&](int i, bool top, bool far) {
    const double part = pointed ? 1.0 * i / pieces : (1 - std::cos(std::numbers::pi * i / pieces)) / 2;
    Point point = far ? box.high : box.low;
    point[across] = box.low[across] + static_cast<int>(std::lround(part * size[across]));
    const int rise = static_cast<int>(std::lround(arch_height(part, pointed) * size.z));
    point.z = top ? box.high.z : std::min(box.high.z, box.low.z + rise);
    return point;
  };
  std::vector<Solid> solids;
  for (int i = 0; i < pieces; ++i) {
    std::vector<Point> corners;
    for (const bool far : {false, true})
      for (const bool top : {false, true})
        for (const int end : {i, i + 1}) corners.push_back(at(end, top, far));
    if (!hull_of(corners).empty()) solids.push_back(solid_of(line, std::move(corners), looks));
  }
  put_solids(line, std::move(solids), "detail", io_plan);
  return line.finish();
}

base::Status read_beams(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Box box = line.box();
  const int count = line.whole("count", 4, 1, 64), width = line.whole("width", 16, 1, 256);
  const std::string along_name = line.text("along", "x");
  if (along_name != "x" && along_name != "y") line.complain("along= is x or y");
  const int across = along_name == "x" ? 1 : 0;
  const Looks looks = line.looks(line.to_world(box), "beam1");
  std::vector<Solid> solids;
  for (int i = 0; i < count; ++i) {
    Box beam = box;
    beam.low[across] = box.low[across] + (2 * i + 1) * box.size()[across] / (2 * count) - width / 2;
    beam.high[across] = beam.low[across] + width;
    Looks own = looks;
    for (Look& look : own) look.anchor = line.to_world(beam);
    solids.push_back(solid_of(line, beam, own));
  }
  put_solids(line, std::move(solids), "detail", io_plan);
  return line.finish();
}

// Posts and a bar along the longer way of the box, as high as it.
void add_rail(const PlanLine& line, const Box& box, const std::string& texture,
              std::vector<Solid>& io_solids) {
  constexpr int kPostEvery = 64, kBar = 6;
  const int axis = box.size().x >= box.size().y ? 0 : 1, length = box.size()[axis];
  const Looks looks = looks_all(texture, line.to_world(box));
  Box bar = box;
  bar.low.z = std::max(box.low.z, box.high.z - kBar);
  io_solids.push_back(solid_of(line, bar, looks));
  const int fields = std::max(1, (length + kPostEvery / 2) / kPostEvery);
  const int thick = std::min(box.size()[1 - axis], length);
  for (int i = 0; i <= fields && bar.low.z > box.low.z; ++i) {
    Box post = box;
    post.low[axis] = box.low[axis] + (length - thick) * i / fields;
    post.high[axis] = post.low[axis] + thick;
    post.high.z = bar.low.z;
    io_solids.push_back(solid_of(line, post, looks));
  }
}

base::Status read_rail(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Box box = line.box();
  const std::string texture = line.word_if_there().value_or("metal1");
  std::vector<Solid> solids;
  if (box.has_volume()) add_rail(line, box, texture, solids);
  put_solids(line, std::move(solids), "detail", io_plan);
  return line.finish();
}

// A plate to walk on, with railings on the sides that rails= lists.
base::Status read_catwalk(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Box box = line.box();
  std::string rails = line.text("rails", "");
  const std::string texture = line.text("rail", "metal1");
  const int high = line.whole("rail_height", 40, 8, 128);
  const Looks looks = line.looks(line.to_world(box), "grate1");
  std::vector<Solid> solids = {solid_of(line, box, looks)};
  while (!rails.empty()) {
    const std::string name = rails.substr(0, rails.find(','));
    rails.erase(0, std::min(name.size() + 1, rails.size()));
    const std::optional<Side> side = side_named(name);
    if (!side || axis_of(*side) == 2) {
      line.complain(fmt::format("rails={}: compass points, with commas between them", base::quotable(name)));
      break;
    }
    constexpr int kThick = 4;
    Box rail = box;
    rail.low.z = box.high.z;
    rail.high.z = box.high.z + high;
    (is_upper(*side) ? rail.low : rail.high)[axis_of(*side)] =
        box.at(*side) + (is_upper(*side) ? -kThick : kThick);
    add_rail(line, rail, texture, solids);
  }
  put_solids(line, std::move(solids), "detail", io_plan);
  return line.finish();
}

base::Status read_pipe(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Point from = line.place();
  if (line.word() != "to") line.complain("it goes from one place 'to' another");
  const Point to = line.place(from.z);
  const int radius = line.whole("radius", 8, 2, 512), sides = line.whole("sides", 8, 3, 16);
  const Point way = to - from;
  const int axes = (way.x != 0) + (way.y != 0) + (way.z != 0);
  if (axes != 1) line.complain("it runs along one axis");
  const int axis = way.x != 0 ? 0 : way.y != 0 ? 1 : 2;
  std::vector<Point> corners;
  for (const Point& end : {from, to})
    for (const Point& on_ring : polygon(Point(0), radius, sides)) {
      Point corner = end;
      corner[(axis + 1) % 3] += on_ring.x;
      corner[(axis + 2) % 3] += on_ring.y;
      corners.push_back(corner);
    }
  const Looks looks = line.looks(line.to_world(bounds_of(corners)), "pipe1");
  put_solids(line, {solid_of(line, std::move(corners), looks)}, "detail", io_plan);
  return line.finish();
}

base::Status read_liquid(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Box box = line.box();
  const Looks looks = line.looks(line.to_world(box), "*water1");
  if (!looks.front().texture.starts_with('*')) line.complain("liquids' textures begin with *");
  put_solids(line, {solid_of(line, box, looks)}, "world", io_plan);
  return line.finish();
}

// A thin block on a wall of the room: `panel north 64,48 size 64x64 sign_exit` has its lower corner at 64
// along the wall and 48 up.
base::Status read_panel(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Side side = line.side();
  const int depth = line.whole("depth", 4, 1, 64);
  const Box box = line.box_on_wall(side, depth);
  const Looks looks = line.looks(line.to_world(box), "trim1");
  put_solids(line, {solid_of(line, box, looks)}, "detail", io_plan);
  return line.finish();
}

constexpr PlanWord kSolidWords[] = {
    {"block", read_block},     {"hull", read_hull}, {"ramp", read_ramp},     {"stairs", read_stairs},
    {"pillar", read_pillar},   {"arch", read_arch}, {"beams", read_beams},   {"rail", read_rail},
    {"catwalk", read_catwalk}, {"pipe", read_pipe}, {"liquid", read_liquid}, {"panel", read_panel},
};

}  // namespace

std::span<const PlanWord> solid_words() {
  return kSolidWords;
}

}  // namespace temblor::artgen
