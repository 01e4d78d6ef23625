// Keywords for rock and for bands along walls.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "artgen/level_script/keywords.h"
#include "artgen/level_script/rock.h"
#include "base/hash.h"
#include "base/text.h"

namespace temblor::artgen {
namespace {

// sides=floor,walls,north and so on.
std::vector<Side> read_sides(LevelScriptLine& line, std::string_view fallback) {
  std::string rest = line.text("sides", fallback);
  std::vector<Side> sides;
  while (!rest.empty()) {
    const std::string name = rest.substr(0, rest.find(','));
    rest.erase(0, std::min(name.size() + 1, rest.size()));
    if (name == "walls")
      sides.insert(sides.end(), {Side::kEast, Side::kWest, Side::kNorth, Side::kSouth});
    else if (name == "floor" || name == "ceiling")
      sides.push_back(name == "floor" ? Side::kDown : Side::kUp);
    else if (const std::optional<Side> side = find_side(name))
      sides.push_back(*side);
    else
      line.set_error(
          fmt::format("sides={}: expected floor, ceiling, walls or compass points", base::quotable(name)));
  }
  return sides;
}

// `cave [BOX] TEXTURE`: covers the sides of a room with rock. The floor can have its own texture and
// roughness.
base::Status read_cave(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  RockFace face;
  const Box box = line.box_or({Point(0), scope.size});
  if (!box.has_volume()) line.set_error("expected a box (X,Y,Z to X,Y,Z), or a room above this line");
  face.box = line.to_world(box);
  face.texture = line.next_text();
  face.ledge_texture = line.text("ledges", face.texture);
  const std::string floor = line.text("floor", face.ledge_texture);
  const int rough = line.integer("rough", 48, 1, 1024);
  const int floor_rough = line.integer("floor_rough", std::min(rough, 20), 1, 1024);
  face.cell = line.integer("cell", 64, 16, 512);
  face.layer_texture = line.text("layers", "");
  if (!face.layer_texture.empty()) face.layer_height = line.integer("layer", 64, 16, 512);
  face.scale = line.number("scale", 1, 0.125, 16);
  face.seed = static_cast<std::uint64_t>(line.integer("seed", 1, 0, 1 << 30));
  face.line = script_line.number;
  const std::vector<Side> sides = read_sides(line, "walls,ceiling,floor");
  TRY_STATUS(line.finish());
  for (const Side side : sides) {
    face.side = scope.placement.apply(side);
    RockFace own = face;
    if (side == Side::kDown) own.ledge_texture = floor;
    own.rough = side == Side::kDown ? floor_rough : rough;
    io_script.rock_faces.push_back(std::move(own));
  }
  return base::Ok{};
}

// `band TEXTURE at=96 height=16`: a strip along the walls of a room; at=top places it below the ceiling.
base::Status read_band(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const std::string texture = line.next_text();
  const int height = line.integer("height", 16, 1, 1024), depth = line.integer("depth", 4, 1, 128);
  const bool on_top = line.text("at", "0") == "top";
  const int low = on_top ? scope.size.z - height : line.integer("at", 0, -8192, 8192);
  Band band{line.to_world({Point(0), scope.size}), {}, 0, 0, depth, texture, script_line.number};
  band.low = scope.placement.origin.z + low;
  band.high = band.low + height;
  const std::vector<Side> sides = read_sides(line, "walls");
  if (scope.size == Point(0)) line.set_error("it must be inside a room");
  TRY_STATUS(line.finish());
  for (const Side side : sides) {
    band.side = scope.placement.apply(side);
    io_script.bands.push_back(band);
  }
  return base::Ok{};
}

// A number in [0, 1); advances the seed.
double next_random(std::uint64_t& io_seed) {
  io_seed = base::hash_with(io_seed, 1);
  return static_cast<double>(io_seed >> 11) / 9007199254740992.0;
}

// A convex hull of random points.
base::Status read_boulder(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Point foot = line.position();
  const int size = line.integer("size", 64, 8, 4096), height = line.integer("height", size * 3 / 4, 4, 4096);
  const int corners_wanted = line.integer("corners", 14, 6, 32);
  std::uint64_t seed = base::hash_with(1, static_cast<std::uint64_t>(line.integer("seed", 1, 0, 1 << 30)));
  std::vector<Point> corners;
  for (int i = 0; i < corners_wanted; ++i) {
    // Evenly distributed on a sphere by the golden angle, then moved at random.
    const double up = 1 - 2 * (i + 0.5) / corners_wanted, around = 2.399963 * i + next_random(seed);
    const double wide = std::sqrt(1 - up * up) * size / 2 * (0.75 + 0.25 * next_random(seed));
    const double rise = (0.4 + 0.6 * up) * height * (0.85 + 0.15 * next_random(seed));
    corners.push_back(foot + Point(static_cast<int>(std::lround(wide * std::cos(around))),
                                   static_cast<int>(std::lround(wide * std::sin(around))),
                                   static_cast<int>(std::lround(rise))));
  }
  const Looks looks = line.looks(line.to_world(find_bounds(corners)), "rock1");
  add_solids(line, {make_solid(line, std::move(corners), looks)}, "detail", io_script);
  return line.finish();
}

// An upright prism of clip around the foot of a leaning crystal. Without it, players could walk under the
// crystal and become wedged between it and the floor. It is higher than a player can jump.
Solid make_guard(const LevelScriptLine& line, Point foot, int radius, Point lean) {
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
  const Looks looks = make_uniform_looks("clip", line.to_world(find_bounds(corners)));
  return make_solid(line, std::move(corners), looks);
}

// A six-sided needle with a slanted tip. lean= is the offset of the tip from the foot.
base::Status read_crystal(const ScriptLine& script_line, const Scope& scope, LevelScript& io_script) {
  LevelScriptLine line(script_line, scope);
  const Point foot = line.position();
  const int height = line.integer("height", 96, 4, 4096), radius = line.integer("radius", 12, 2, 512);
  const Point lean = line.position("lean", Point(0));
  std::uint64_t seed = base::hash_with(7, static_cast<std::uint64_t>(line.integer("seed", 1, 0, 1 << 30)));
  const double turn = next_random(seed);
  std::vector<Point> corners;
  for (int i = 0; i < 6; ++i) {
    const double angle = (i + turn) * std::numbers::pi / 3;
    const Point out(static_cast<int>(std::lround(radius * std::cos(angle))),
                    static_cast<int>(std::lround(radius * std::sin(angle))), 0);
    const Point sink(0, 0, -radius / 2);
    const double shoulder = 0.62 + 0.16 * next_random(seed);
    const Point up(static_cast<int>(std::lround(lean.x * shoulder)),
                   static_cast<int>(std::lround(lean.y * shoulder)),
                   static_cast<int>(std::lround(height * shoulder)));
    corners.push_back(foot + out * 2 / 3 + sink);
    corners.push_back(foot + out + up);
  }
  corners.push_back(foot + Point(lean.x, lean.y, height));
  const Looks looks = line.looks(line.to_world(find_bounds(corners)), "crystal1");
  const bool is_felt = line.text("as", "detail") != "ghost";
  add_solids(line, {make_solid(line, std::move(corners), looks)}, "detail", io_script);
  if (is_felt && lean != Point(0))
    add_solids(line, {make_guard(line, foot, radius, lean)}, "detail", io_script);
  return line.finish();
}

constexpr LevelKeyword kRockKeywords[] = {
    {"cave", read_cave}, {"band", read_band}, {"boulder", read_boulder}, {"crystal", read_crystal}};

}  // namespace

std::span<const LevelKeyword> rock_keywords() {
  return kRockKeywords;
}

}  // namespace temblor::artgen
