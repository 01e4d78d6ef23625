// Words for rock and for bands along walls.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "artgen/level_script/rock.h"
#include "artgen/level_script/words.h"
#include "base/hash.h"
#include "base/text.h"

namespace temblor::artgen {
namespace {

// sides=floor,walls,north ... ; all of them when it is not said.
std::vector<Side> sides_listed(PlanLine& line, std::string_view otherwise) {
  std::string rest = line.text("sides", otherwise);
  std::vector<Side> sides;
  while (!rest.empty()) {
    const std::string name = rest.substr(0, rest.find(','));
    rest.erase(0, std::min(name.size() + 1, rest.size()));
    if (name == "walls")
      sides.insert(sides.end(), {Side::kEast, Side::kWest, Side::kNorth, Side::kSouth});
    else if (name == "floor" || name == "ceiling")
      sides.push_back(name == "floor" ? Side::kDown : Side::kUp);
    else if (const std::optional<Side> side = side_named(name))
      sides.push_back(*side);
    else
      line.complain(fmt::format("sides={}: floor, ceiling, walls or compass points", base::quotable(name)));
  }
  return sides;
}

base::Status read_cave(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  RockFace face;
  const Box box = line.box_or({Point(0), scope.size});
  if (!box.has_volume()) line.complain("it stands in a room, or has a box");
  face.box = line.to_world(box);
  face.texture = line.word();
  face.ledge_texture = line.text("ledges", face.texture);
  const std::string floor = line.text("floor", face.ledge_texture);
  const int rough = line.whole("rough", 48, 1, 1024);
  const int floor_rough = line.whole("floor_rough", std::min(rough, 20), 1, 1024);
  face.cell = line.whole("cell", 64, 16, 512);
  face.scale = line.number("scale", 1, 0.125, 16);
  face.seed = static_cast<std::uint64_t>(line.whole("seed", 1, 0, 1 << 30));
  face.line = script.number;
  const std::vector<Side> sides = sides_listed(line, "walls,ceiling,floor");
  TRY_STATUS(line.finish());
  for (const Side side : sides) {
    face.side = scope.placement.apply(side);
    RockFace own = face;
    if (side == Side::kDown) own.ledge_texture = floor;
    own.rough = side == Side::kDown ? floor_rough : rough;
    io_plan.rock_faces.push_back(std::move(own));
  }
  return base::Ok{};
}

base::Status read_band(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const std::string texture = line.word();
  const int height = line.whole("height", 16, 1, 1024), depth = line.whole("depth", 4, 1, 128);
  const bool on_top = line.text("at", "0") == "top";
  const int low = on_top ? scope.size.z - height : line.whole("at", 0, -8192, 8192);
  Band band{line.to_world({Point(0), scope.size}), {}, 0, 0, depth, texture, script.number};
  band.low = scope.placement.origin.z + low;
  band.high = band.low + height;
  const std::vector<Side> sides = sides_listed(line, "walls");
  if (scope.size == Point(0)) line.complain("it stands in a room");
  TRY_STATUS(line.finish());
  for (const Side side : sides) {
    band.side = scope.placement.apply(side);
    io_plan.bands.push_back(band);
  }
  return base::Ok{};
}

double chance(std::uint64_t& io_seed) {
  io_seed = base::hash_with(io_seed, 1);
  return static_cast<double>(io_seed >> 11) / 9007199254740992.0;
}

base::Status read_boulder(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Point foot = line.place();
  const int size = line.whole("size", 64, 8, 4096), height = line.whole("height", size * 3 / 4, 4, 4096);
  const int corners_wanted = line.whole("corners", 14, 6, 32);
  std::uint64_t seed = base::hash_with(1, static_cast<std::uint64_t>(line.whole("seed", 1, 0, 1 << 30)));
  std::vector<Point> corners;
  for (int i = 0; i < corners_wanted; ++i) {
    // Evenly over a ball, by the golden angle, and then disturbed.
    const double up = 1 - 2 * (i + 0.5) / corners_wanted, around = 2.399963 * i + chance(seed);
    const double wide = std::sqrt(1 - up * up) * size / 2 * (0.75 + 0.25 * chance(seed));
    const double rise = (0.4 + 0.6 * up) * height * (0.85 + 0.15 * chance(seed));
    corners.push_back(foot + Point(static_cast<int>(std::lround(wide * std::cos(around))),
                                   static_cast<int>(std::lround(wide * std::sin(around))),
                                   static_cast<int>(std::lround(rise))));
  }
  const Looks looks = line.looks(line.to_world(bounds_of(corners)), "rock1");
  put_solids(line, {solid_of(line, std::move(corners), looks)}, "detail", io_plan);
  return line.finish();
}

// What keeps players out from under a leaning needle, where they would be wedged between it and the floor: an
// upright prism of clip, higher than they jump.
Solid guard_of(const PlanLine& line, Point foot, int radius, Point lean) {
  constexpr int kHigh = 96, kSides = 8;
  const Point middle = foot + Point(lean.x, lean.y, 0) / 5;
  const double wide = radius + 0.3 * std::hypot(lean.x, lean.y);
  std::vector<Point> corners;
  for (int i = 0; i < kSides; ++i) {
    const double angle = (2 * i + 1) * std::numbers::pi / kSides;
    const Point out(static_cast<int>(std::lround(wide * std::cos(angle))),
                    static_cast<int>(std::lround(wide * std::sin(angle))), 0);
    corners.push_back(middle + out);
    corners.push_back(middle + out + Point(0, 0, kHigh));
  }
  const Looks looks = looks_all("clip", line.to_world(bounds_of(corners)));
  return solid_of(line, std::move(corners), looks);
}

// A six-sided needle with a slanted tip: at its foot `radius` wide, leaning by lean= at its top.
base::Status read_crystal(const ScriptLine& script, const Scope& scope, Plan& io_plan) {
  PlanLine line(script, scope);
  const Point foot = line.place();
  const int height = line.whole("height", 96, 4, 4096), radius = line.whole("radius", 12, 2, 512);
  const Point lean = line.place("lean", Point(0));
  std::uint64_t seed = base::hash_with(7, static_cast<std::uint64_t>(line.whole("seed", 1, 0, 1 << 30)));
  const double turn = chance(seed);
  std::vector<Point> corners;
  for (int i = 0; i < 6; ++i) {
    const double angle = (i + turn) * std::numbers::pi / 3;
    const Point out(static_cast<int>(std::lround(radius * std::cos(angle))),
                    static_cast<int>(std::lround(radius * std::sin(angle))), 0);
    const Point sink(0, 0, -radius / 2);
    const double shoulder = 0.62 + 0.16 * chance(seed);
    const Point up(static_cast<int>(std::lround(lean.x * shoulder)),
                   static_cast<int>(std::lround(lean.y * shoulder)),
                   static_cast<int>(std::lround(height * shoulder)));
    corners.push_back(foot + out * 2 / 3 + sink);
    corners.push_back(foot + out + up);
  }
  corners.push_back(foot + Point(lean.x, lean.y, height));
  const Looks looks = line.looks(line.to_world(bounds_of(corners)), "crystal1");
  const bool is_felt = line.text("as", "detail") != "ghost";
  put_solids(line, {solid_of(line, std::move(corners), looks)}, "detail", io_plan);
  if (is_felt && lean != Point(0)) put_solids(line, {guard_of(line, foot, radius, lean)}, "detail", io_plan);
  return line.finish();
}

constexpr PlanWord kRockWords[] = {
    {"cave", read_cave}, {"band", read_band}, {"boulder", read_boulder}, {"crystal", read_crystal}};

}  // namespace

std::span<const PlanWord> rock_words() {
  return kRockWords;
}

}  // namespace temblor::artgen
