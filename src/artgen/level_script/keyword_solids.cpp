// Keywords for solids in a room: blocks, stairs, pillars, arches, railings, pipes, liquids.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "artgen/level_script/keywords.h"
#include "base/text.h"

namespace temblor::artgen {
namespace {

base::Status read_block(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Box box = line.box();
  const Looks looks = line.looks(line.to_world(box), scope.surfaces[side_index(Side::kNorth)]);
  add_solids(line, {make_solid(line, box, looks)}, "detail", io_script);
  return line.finish();
}

// A convex solid by its corners: `hull X,Y,Z X,Y,Z ... TEXTURE`.
base::Status read_hull(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  std::vector<Point> corners;
  while (line.is_box_next()) corners.push_back(line.position());
  if (corners.size() < 4 || corners.size() > 64) {
    line.set_error("expected 4 to 64 corners, each X,Y,Z");
    return line.finish();
  }
  const Looks looks =
      line.looks(line.to_world(find_bounds(corners)), scope.surfaces[side_index(Side::kNorth)]);
  if (make_hull(corners).empty()) line.set_error("its corners are all in one plane");
  add_solids(line, {make_solid(line, std::move(corners), looks)}, "detail", io_script);
  return line.finish();
}

// A wedge that rises toward the side up=.
base::Status read_ramp(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Box box = line.box();
  const Side up = line.side("up", Side::kNorth);
  if (side_axis(up) == 2) line.set_error("up= must be north, east, south or west");
  const Looks looks = line.looks(line.to_world(box), scope.surfaces[side_index(Side::kDown)]);
  std::vector<Point> corners;
  for (const Point& corner : list_corners(box))
    if (corner.z == box.low.z || corner[side_axis(up)] == box.at(up)) corners.push_back(corner);
  add_solids(line, {make_solid(line, std::move(corners), looks)}, "detail", io_script);
  return line.finish();
}

// Steps that rise toward the side up=. hanging=yes leaves out the solids below them.
base::Status read_stairs(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Box box = line.box();
  const Side up = line.side("up", Side::kNorth);
  if (side_axis(up) == 2) line.set_error("up= must be north, east, south or west");
  const int rise = line.integer("rise", 16, 4, 64);
  const bool hanging = line.flag("hanging");
  const Looks looks = line.looks(line.to_world(box), scope.surfaces[side_index(Side::kDown)]);
  const int steps = std::max(1, (box.size().z + rise - 1) / rise);
  const int axis = side_axis(up) % 2, length = box.size()[axis];
  std::vector<Solid> solids;
  for (int i = 0; i < steps; ++i) {
    Box step = box;
    const int from = length * i / steps, to = hanging ? length * (i + 1) / steps : length;
    step.low[axis] = is_upper(up) ? box.low[axis] + from : box.high[axis] - to;
    step.high[axis] = is_upper(up) ? box.low[axis] + to : box.high[axis] - from;
    step.high.z = std::min(box.high.z, box.low.z + rise * (i + 1));
    step.low.z = hanging ? step.high.z - rise : box.low.z + rise * i;
    // The texture of each riser starts at its own base.
    Looks own = looks;
    for (Look& look : own) look.anchor = line.to_world(step);
    if (step.has_volume()) solids.push_back(make_solid(line, step, own));
  }
  add_solids(line, std::move(solids), "detail", io_script);
  return line.finish();
}

// The corners of a regular polygon with an inner radius, with two sides facing north and south.
std::vector<Point> make_polygon_points(Point middle, double radius, int sides) {
  std::vector<Point> corners;
  const double outer = radius / std::cos(std::numbers::pi / sides);
  for (int i = 0; i < sides; ++i) {
    const double angle = (2 * i + 1) * std::numbers::pi / sides;
    corners.push_back({middle.x + static_cast<int>(std::lround(outer * std::cos(angle))),
                       middle.y + static_cast<int>(std::lround(outer * std::sin(angle))), middle.z});
  }
  return corners;
}

// The corners of an upright prism.
std::vector<Point> make_drum(Point foot, double radius, int sides, int height) {
  std::vector<Point> corners = make_polygon_points(foot, radius, sides);
  for (const Point& top : make_polygon_points(foot + Point(0, 0, height), radius, sides))
    corners.push_back(top);
  return corners;
}

// A shaft with an optional base (foot=) and capital (head=), which protrude by proud= units.
base::Status read_pillar(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Point foot = line.position();
  const int size = line.integer("size", 48, 8, 1024), sides = line.integer("sides", 8, 3, 24);
  const int height = line.integer("height", std::max(scope.size.z - foot.z, 1), 1, 8192);
  const int foot_height = line.integer("foot", 0, 0, 256),
            head_height = line.integer("head", foot_height, 0, 256);
  const int proud = line.integer("proud", 8, 0, 64);
  const Box box{foot - Point(size / 2, size / 2, 0), foot + Point(size / 2, size / 2, height)};
  const Looks looks = line.looks(line.to_world(box), scope.surfaces[side_index(Side::kNorth)]);
  Looks ends = looks;
  for (Look& look : ends) look.texture = line.text("ends", look.texture);
  const double radius = size / 2.0;
  std::vector<Solid> solids;
  const int shaft = height - foot_height - head_height;
  if (shaft < 1) line.set_error("foot= and head= leave no height for the shaft");
  const auto add = [&](int from, int tall, double wide, const Looks& look) {
    if (tall > 0)
      solids.push_back(make_solid(line, make_drum(foot + Point(0, 0, from), wide, sides, tall), look));
  };
  add(0, foot_height, radius + proud, ends);
  add(foot_height, shaft, radius, looks);
  add(height - head_height, head_height, radius + proud, ends);
  add_solids(line, std::move(solids), "detail", io_script);
  return line.finish();
}

// The height of an arch of height 1, at a fraction of its width. Round arches are half an ellipse; each half
// of a pointed one is a circle around the foot of the other.
double arch_height(double at, bool pointed) {
  if (!pointed) return std::sqrt(std::max(0.0, 1 - (2 * at - 1) * (2 * at - 1)));
  const double off = 1 - std::min(at, 1 - at);
  return std::sqrt(std::max(0.0, 1 - off * off)) / std::sqrt(0.75);
}

// Fills the part of the box above an arch. along= is the axis along which one walks through.
base::Status read_arch(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Box box = line.box_or(scope.bounds());
  const Point size = box.size();
  const std::string along_name = line.text("along", size.x < size.y ? "x" : "y");
  if (along_name != "x" && along_name != "y") line.set_error("along= must be x or y");
  const int across = along_name == "x" ? 1 : 0;
  const int pieces = line.integer("pieces", 8, 2, 32);
  const bool pointed = line.flag("pointed");
  const Looks looks = line.looks(line.to_world(box), scope.surfaces[side_index(Side::kNorth)]);
  // A corner of piece i. Round arches are divided by angle, so that the steep parts near the feet have enough
  // pieces.
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
    if (!make_hull(corners).empty()) solids.push_back(make_solid(line, std::move(corners), looks));
  }
  add_solids(line, std::move(solids), "detail", io_script);
  return line.finish();
}

// count= parallel beams, spaced evenly in the box.
base::Status read_beams(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Box box = line.box();
  const int count = line.integer("count", 4, 1, 64), width = line.integer("width", 16, 1, 256);
  const std::string along_name = line.text("along", "x");
  if (along_name != "x" && along_name != "y") line.set_error("along= must be x or y");
  const int across = along_name == "x" ? 1 : 0;
  const Looks looks = line.looks(line.to_world(box), "beam1");
  std::vector<Solid> solids;
  for (int i = 0; i < count; ++i) {
    Box beam = box;
    beam.low[across] = box.low[across] + (2 * i + 1) * box.size()[across] / (2 * count) - width / 2;
    beam.high[across] = beam.low[across] + width;
    Looks own = looks;
    for (Look& look : own) look.anchor = line.to_world(beam);
    solids.push_back(make_solid(line, beam, own));
  }
  add_solids(line, std::move(solids), "detail", io_script);
  return line.finish();
}

// A rail along the longer side of the box, at its top, on posts every 64 units.
void add_rail(const LevelScriptLine& line, const Box& box, const std::string& texture,
              std::vector<Solid>& io_solids) {
  constexpr int kPostEvery = 64, kBar = 6;
  const int axis = box.size().x >= box.size().y ? 0 : 1, length = box.size()[axis];
  const Looks looks = make_uniform_looks(texture, line.to_world(box));
  Box bar = box;
  bar.low.z = std::max(box.low.z, box.high.z - kBar);
  io_solids.push_back(make_solid(line, bar, looks));
  const int fields = std::max(1, (length + kPostEvery / 2) / kPostEvery);
  const int thick = std::min(box.size()[1 - axis], length);
  for (int i = 0; i <= fields && bar.low.z > box.low.z; ++i) {
    Box post = box;
    post.low[axis] = box.low[axis] + (length - thick) * i / fields;
    post.high[axis] = post.low[axis] + thick;
    post.high.z = bar.low.z;
    io_solids.push_back(make_solid(line, post, looks));
  }
}

base::Status read_rail(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Box box = line.box();
  const std::string texture = line.next_text_if_present().value_or("metal1");
  std::vector<Solid> solids;
  if (box.has_volume()) add_rail(line, box, texture, solids);
  add_solids(line, std::move(solids), "detail", io_script);
  return line.finish();
}

// A plate to walk on, with railings on the sides that rails= lists.
base::Status read_catwalk(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Box box = line.box();
  std::string rails = line.text("rails", "");
  const std::string texture = line.text("rail", "metal1");
  const int high = line.integer("rail_height", 40, 8, 128);
  const Looks looks = line.looks(line.to_world(box), "grate1");
  std::vector<Solid> solids = {make_solid(line, box, looks)};
  while (!rails.empty()) {
    const std::string name = rails.substr(0, rails.find(','));
    rails.erase(0, std::min(name.size() + 1, rails.size()));
    const std::optional<Side> side = find_side(name);
    if (!side || side_axis(*side) == 2) {
      line.set_error(
          fmt::format("rails={}: expected compass points separated by commas", base::quotable(name)));
      break;
    }
    constexpr int kThick = 4;
    Box rail = box;
    rail.low.z = box.high.z;
    rail.high.z = box.high.z + high;
    (is_upper(*side) ? rail.low : rail.high)[side_axis(*side)] =
        box.at(*side) + (is_upper(*side) ? -kThick : kThick);
    add_rail(line, rail, texture, solids);
  }
  add_solids(line, std::move(solids), "detail", io_script);
  return line.finish();
}

// A prism along one axis between two points.
base::Status read_pipe(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Point from = line.position();
  if (line.next_text() != "to") line.set_error("expected 'to' between the two ends");
  const Point to = line.position(from.z);
  const int radius = line.integer("radius", 8, 2, 512), sides = line.integer("sides", 8, 3, 16);
  const Point offset = to - from;
  const int axes = (offset.x != 0) + (offset.y != 0) + (offset.z != 0);
  if (axes != 1) line.set_error("a pipe must run along one axis");
  const int axis = offset.x != 0 ? 0 : offset.y != 0 ? 1 : 2;
  std::vector<Point> corners;
  for (const Point& end : {from, to})
    for (const Point& on_ring : make_polygon_points(Point(0), radius, sides)) {
      Point corner = end;
      corner[(axis + 1) % 3] += on_ring.x;
      corner[(axis + 2) % 3] += on_ring.y;
      corners.push_back(corner);
    }
  const Looks looks = line.looks(line.to_world(find_bounds(corners)), "pipe1");
  add_solids(line, {make_solid(line, std::move(corners), looks)}, "detail", io_script);
  return line.finish();
}

// A box of water, slime, or lava, by its texture.
base::Status read_liquid(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Box box = line.box();
  const Looks looks = line.looks(line.to_world(box), "*water1");
  if (!looks.front().texture.starts_with('*')) line.set_error("a liquid's texture must begin with *");
  add_solids(line, {make_solid(line, box, looks)}, "world", io_script);
  return line.finish();
}

// A thin block on a wall of the room: the lower left corner of `panel north 64,48 size 64x64 sign_exit` is 64
// units along the wall and 48 up.
base::Status read_panel(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Side side = line.side();
  const int depth = line.integer("depth", 4, 1, 64);
  const Box box = line.wall_box(side, depth);
  const Looks looks = line.looks(line.to_world(box), "trim1");
  add_solids(line, {make_solid(line, box, looks)}, "detail", io_script);
  return line.finish();
}

constexpr LevelKeyword kSolidKeywords[] = {
    {"block", read_block},     {"hull", read_hull}, {"ramp", read_ramp},     {"stairs", read_stairs},
    {"pillar", read_pillar},   {"arch", read_arch}, {"beams", read_beams},   {"rail", read_rail},
    {"catwalk", read_catwalk}, {"pipe", read_pipe}, {"liquid", read_liquid}, {"panel", read_panel},
};

}  // namespace

std::span<const LevelKeyword> solid_keywords() {
  return kSolidKeywords;
}

}  // namespace temblor::artgen
