#include "compiler/random/random_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "compiler/prefabs.h"
#include "support/levels/room_map.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using math::Vec2d;
using math::Vec3d;

constexpr double kFloor = 0, kCeiling = 128, kThick = 16, kDoorTop = 80, kDoorHalfWidth = 40;

// A vertical plane; the brush is on the left of the line from `from` to `to`, seen from above.
struct Line {
  Vec2d from, to;
};

Vec2d turn_counterclockwise(const Vec2d& direction) {
  return {-direction.y, direction.x};
}
Line moved(const Line& line, double to_the_right) {
  const Vec2d offset = -turn_counterclockwise(glm::normalize(line.to - line.from)) * to_the_right;
  return {line.from + offset, line.to + offset};
}
Line reversed(const Line& line) {
  return {line.to, line.from};
}

std::string wall_side_text(const Vec3d& a, const Vec3d& b, const Vec3d& c, std::string_view texture) {
  return fmt::format("( {} {} {} ) ( {} {} {} ) ( {} {} {} ) {} 0 0 0 1 1\n", a.x, a.y, a.z, b.x, b.y, b.z,
                     c.x, c.y, c.z, texture);
}

// A brush between vertical planes.
std::string prism_text(std::span<const Line> lines, double bottom, double top, std::string_view texture) {
  std::string text = "{\n";
  for (const Line& line : lines)
    text += wall_side_text(Vec3d(line.from, 0), Vec3d(line.from, 64), Vec3d(line.to, 0), texture);
  text += wall_side_text({0, 0, top}, {0, 64, top}, {64, 0, top}, texture);
  text += wall_side_text({0, 0, bottom}, {64, 0, bottom}, {0, 64, bottom}, texture);
  return text + "}\n";
}

// A room: its corners without walls, counterclockwise. Side 0 is open if it is the outside of another room's
// wall.
struct Room {
  std::array<Vec2d, 4> corners;
  bool opens_first_side = false;
  std::array<bool, 4> has_door{};

  Line side(std::size_t index) const { return {corners[index], corners[(index + 1) % 4]}; }
};

// Behind an open first side, everything reaches half into the wall there, so that no crack is left.
double reach(const Room& room, std::size_t side) {
  return side == 0 && room.opens_first_side ? kThick / 2 : kThick;
}

std::string wall_text(const Room& room, std::size_t index) {
  const Line side = room.side(index);
  std::vector<Line> lines = {reversed(side), moved(side, kThick)};
  for (const std::size_t next : {(index + 3) % 4, (index + 1) % 4})
    lines.push_back(moved(room.side(next), reach(room, next)));
  const double bottom = kFloor - kThick, top = kCeiling + kThick;
  if (!room.has_door[index]) return prism_text(lines, bottom, top, "wall");
  const Vec2d middle = (side.from + side.to) * 0.5, along = glm::normalize(side.to - side.from);
  const Vec2d across = turn_counterclockwise(along);
  const Vec2d begin = middle - along * kDoorHalfWidth, end = middle + along * kDoorHalfWidth;
  const auto with = [&](std::initializer_list<Line> more) {
    std::vector<Line> all = lines;
    all.insert(all.end(), more);
    return all;
  };
  const Line before{begin, begin + across}, behind{end, end - across};  // the sides of the wall's two halves
  return prism_text(with({before}), bottom, top, "wall") + prism_text(with({behind}), bottom, top, "wall") +
         prism_text(with({reversed(before), reversed(behind)}), kDoorTop, top, "lintel") +
         prism_text(with({reversed(before), reversed(behind)}), bottom, kFloor, "sill");
}

std::string slab_text(const Room& room, double bottom, double top, std::string_view texture) {
  std::array<Line, 4> lines;
  for (std::size_t i = 0; i < 4; ++i) lines[i] = moved(room.side(i), reach(room, i));
  return prism_text(lines, bottom, top, texture);
}

// Lengthens a quadrilateral from its first side in a random direction.
Room make_room(Random& random, const Vec2d& a, const Vec2d& b, bool opens_first_side) {
  const auto turned = [&](const Vec2d& direction, double most_deg) {
    const double angle = random.uniform(-most_deg, most_deg) * 3.14159265358979 / 180;
    return Vec2d(direction.x * std::cos(angle) - direction.y * std::sin(angle),
                 direction.x * std::sin(angle) + direction.y * std::cos(angle));
  };
  const Vec2d along = glm::normalize(b - a);
  // One random number for each statement: compilers may evaluate the operands of an expression in any order,
  // and all must make the same maps.
  const double length = random.uniform(180, 360);
  const Vec2d far = (a + b) * 0.5 + turned(turn_counterclockwise(along), 25) * length;
  const double half_width = glm::length(b - a) / 2 * random.uniform(0.9, 1.2);
  const Vec2d half = turned(along, 15) * half_width;
  // Whole numbers for some rooms, as mappers have them, and others between.
  const auto place = [&, is_whole = random.chance(0.5)](const Vec2d& point) {
    return is_whole ? glm::round(point) : point;
  };
  return {{a, b, place(far + half), place(far - half)}, opens_first_side, {}};
}

// Whether a line along a side of `a` has all of `b` on its outside, a wall away.
bool has_side_between(const Room& a, const Room& b) {
  for (std::size_t i = 0; i < 4; ++i) {
    const Line side = a.side(i);
    const Vec2d inward = turn_counterclockwise(glm::normalize(side.to - side.from));
    if (std::ranges::all_of(b.corners, [&](const Vec2d& corner) {
          return glm::dot(inward, corner - side.from) < 0.01 - kThick;
        }))
      return true;
  }
  return false;
}

// A convex polygon around a place, as a pillar, pool, or block.
std::string column_text(Random& random, const Vec2d& at, double radius, double bottom, double top,
                        std::string_view texture) {
  const std::size_t sides = 3 + random.below(4);
  const double turn = random.uniform(0, 6.28);
  std::vector<Vec2d> corners;
  for (std::size_t i = 0; i < sides; ++i) {
    const double angle = turn + 6.283185307179586 * static_cast<double>(i) / static_cast<double>(sides);
    corners.push_back(at + Vec2d(std::cos(angle), std::sin(angle)) * radius);
  }
  std::vector<Line> lines;
  for (std::size_t i = 0; i < sides; ++i) lines.push_back({corners[i], corners[(i + 1) % sides]});
  return prism_text(lines, bottom, top, texture);
}

std::string furniture_text(Random& random, const Vec2d& middle, std::string& io_world) {
  const double y = random.uniform(-60, 60), x = random.uniform(-60, 60);
  const Vec2d at = middle + Vec2d(x, y);
  switch (random.below(6)) {
    case 0:
      return entity_text("func_detail", "", column_text(random, at, 24, kFloor, 200, "pillar"));
    case 1:
      io_world += column_text(random, at, random.uniform(10, 50), kFloor - 8, kCeiling + 8, "column");
      return "";
    case 2: {
      const char* const liquid = random.chance(0.5) ? "*water" : "*slime";
      const double top = random.uniform(8, 40), radius = random.uniform(30, 80);
      io_world += column_text(random, at, radius, kFloor, top, liquid);
      return "";
    }
    case 3:
      return entity_text("func_detail_wall", "", column_text(random, at, 30, -8, 50, "crate"));
    case 4:
      return entity_text("misc_external_map",
                         fmt::format("\"_external_map\" \"prefab.map\"\n\"_external_map_angle\" \"{}\"\n"
                                     "\"origin\" \"{} {} {}\"",
                                     random.below(360), std::round(at.x), std::round(at.y), kFloor));
    default:
      io_world += column_text(random, at, 40, random.uniform(40, 90), kCeiling, "block");
      return "";
  }
}

constexpr double kPlayerZ = 32;

}  // namespace

RandomMap make_random_map(std::uint64_t seed) {
  Random random(seed);
  std::vector<Room> rooms = {make_room(random, {-120, 0}, {120, 0}, false)};
  const std::size_t wanted = 2 + random.below(5);
  for (int attempt = 0; attempt < 40 && rooms.size() < wanted; ++attempt) {
    Room& from = rooms[random.below(rooms.size())];
    const std::size_t exit = 1 + random.below(3);
    const Line outside = moved(from.side(exit), kThick);
    if (from.has_door[exit] || glm::length(outside.to - outside.from) < 160) continue;
    const Room next = make_room(random, outside.to, outside.from, true);
    // In a room that reaches into another one, walls may enclose a place without an entity, which is filled.
    if (!std::ranges::all_of(rooms, [&](const Room& room) {
          return has_side_between(room, next) || has_side_between(next, room);
        }))
      continue;
    from.has_door[exit] = true;
    rooms.push_back(next);
  }
  RandomMap made;
  made.floor_z = kFloor;
  made.ceiling_z = kCeiling;
  std::string world, others;
  for (const Room& room : rooms) {
    for (std::size_t i = 0; i < 4; ++i)
      if (i > 0 || !room.opens_first_side) world += wall_text(room, i);
    world += slab_text(room, kFloor - kThick, kFloor, "floor");
    world += slab_text(room, kCeiling, kCeiling + kThick, random.chance(0.4) ? "sky1" : "ceiling");
    const Vec2d middle = (room.corners[0] + room.corners[1] + room.corners[2] + room.corners[3]) * 0.25;
    for (std::size_t i = random.below(4); i > 0; --i) others += furniture_text(random, middle, world);
    others += point_text("light", Vec3d(middle, kPlayerZ));
    made.floors.emplace_back(room.corners.begin(), room.corners.end());
  }
  made.text =
      entity_text("worldspawn", "", world) + others + point_text("info_player_start", Vec3d(0, 40, kPlayerZ));
  const auto read = [](const std::filesystem::path&) -> base::Result<std::string> {
    return entity_text("worldspawn", "", box_text({-20, -12, 0}, {20, 12, 30}, "prefab")) +
           entity_text("func_detail", "", box_text({-8, -8, 30}, {8, 8, 44}, "prefab"));
  };
  compiler::Warnings unused;
  made.map = compiler::expand_prefabs(parse_map(made.text), "random.map", read, unused).value();
  return made;
}

double depth_in_rooms(const RandomMap& map, const Vec3d& point) {
  double deepest = -std::numeric_limits<double>::max();
  for (const std::vector<Vec2d>& floor : map.floors) {
    double depth = std::min(point.z - map.floor_z, map.ceiling_z - point.z);
    for (std::size_t i = 0; i < floor.size(); ++i) {
      const Vec2d along = glm::normalize(floor[(i + 1) % floor.size()] - floor[i]);
      depth = std::min(depth, glm::dot(turn_counterclockwise(along), Vec2d(point) - floor[i]));
    }
    deepest = std::max(deepest, depth);
  }
  return deepest;
}

}  // namespace temblor::test
