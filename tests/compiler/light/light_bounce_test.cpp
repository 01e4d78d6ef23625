// Bounced light in rooms whose answer is known, and beside traced paths (Kajiya, "The rendering equation",
// 1986), which know nothing of the compiler's nodes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>

#include "compiler/light/lit_map.h"
#include "support/effort.h"
#include "support/levels/room_map.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using math::Vec3d;

// The share of light that a gray wall sends back. Light maps count light from all sides 2 - _anglescale times
// as much as a matte surface would.
double gray_share(double angle_scale) {
  return (2 - angle_scale) * 127 / 255;
}

// The light after many bounces of a light of 1, if each sends on the same share of all light.
double add_bounces(double share, int count) {
  double sum = 1;
  for (int bounce = 1; bounce <= count; ++bounce) sum += std::pow(share, bounce);
  return sum;
}

// A closed room in which every luxel gets 20 from the light itself.
std::string furnace_text(std::string_view world_keys) {
  return entity_text("worldspawn", world_keys, walls_text({-96, -96, 0}, {96, 96, 128}, "stone")) +
         entity_text("light",
                     "\"origin\" \"10 20 50\"\n\"light\" \"40\"\n\"delay\" \"3\"\n\"_anglescale\" \"0\"\n"
                     "\"_dirt\" \"-1\"") +
         point_text("info_player_start", {0, 0, 40});
}

TEST(LightBounce, FurnaceHasTheSumOfAllBounces) {
  for (const double angle_scale : {0.5, 1.0})
    for (const int count : {1, 2, 16}) {
      const auto level = lit_map(
          furnace_text(fmt::format("\"_bounce\" \"{}\"\n\"_anglescale\" \"{}\"", count, angle_scale)));
      const double expected = 20 * add_bounces(gray_share(angle_scale), count);
      const auto [least, most] = std::minmax_element(level->light.begin(), level->light.end());
      EXPECT_NEAR(*least, expected, 1) << count << " bounces, angle scale " << angle_scale;
      EXPECT_NEAR(*most, expected, 1) << count << " bounces, angle scale " << angle_scale;
    }
}

// Both faces of a water surface, which are lit from both sides, get the same.
TEST(LightBounce, LiquidsGetItFromBothSides) {
  const std::string room = entity_text("worldspawn", "\"_bounce\" \"%\"",
                                       walls_text({-96, -96, 0}, {96, 96, 192}, "stone") +
                                           box_text({-96, -96, 0}, {96, 96, 64}, "*water")) +
                           // Much nearer to the bottom than to the ceiling.
                           entity_text("light", "\"origin\" \"0 0 30\"\n\"light\" \"150\"") +
                           point_text("info_player_start", {0, 0, 100});
  const auto with_bounces = [&](const char* count) {
    std::string text = room;
    return lit_map(text.replace(text.find('%'), 1, count));
  };
  const auto direct = with_bounces("0"), bounced = with_bounces("4");
  double above = 0, below = 0;
  for (int x = -64; x <= 64; x += 32)
    for (int y = -64; y <= 64; y += 32) {
      const auto find_bounced_part = [&](double side) {
        const Vec3d place(x, y, 64), normal(0, 0, side);
        return shown_light(*bounced, face_under(*bounced, place, normal), place).x -
               shown_light(*direct, face_under(*direct, place, normal), place).x;
      };
      above += find_bounced_part(1);
      below += find_bounced_part(-1);
    }
  EXPECT_GT(below, 25 * 10);
  EXPECT_NEAR(above / below, 1, 0.05);
}

TEST(LightBounce, ColorsOfTexturesTintEachBounce) {
  formats::Palette palette{};
  palette.fill({51, 102, 255});
  const auto level = lit_map(furnace_text("\"_bounce\" \"3\"\n\"_bouncecolorscale\" \"1\""), {{}, palette});
  const Vec3d light = shown_light(*level, face_under(*level, {0, 0, 0}, {0, 0, 1}), {0, 0, 0});
  EXPECT_NEAR(light.x, 20 * add_bounces(1.5 * 51 / 255, 3), 1);
  EXPECT_NEAR(light.y, 20 * add_bounces(1.5 * 102 / 255, 3), 1);
  EXPECT_NEAR(light.z, 20 * add_bounces(1, 3), 1) << "a wall sends back at most what it gets";
}

// The light itself takes no dirt here.
TEST(LightBounce, DirtDarkensBouncedLight) {
  const auto floor_light = [](const std::string& world_keys, double from_middle) {
    const auto level = lit_map(furnace_text(world_keys));
    const Vec3d place(from_middle, from_middle, 0);
    return shown_light(*level, face_under(*level, place, {0, 0, 1}), place).x;
  };
  const std::string bounce = "\"_bounce\" \"1\"\n", dirt = "\"_dirt\" \"1\"\n\"_dirtdepth\" \"32\"\n";
  constexpr double kMiddle = 0, kCorner = 88;
  EXPECT_NEAR(floor_light(dirt, kCorner), 20, 0.5);
  EXPECT_NEAR(floor_light(dirt + bounce, kMiddle), floor_light(bounce, kMiddle), 1);
  EXPECT_LT(floor_light(dirt + bounce, kCorner), floor_light(bounce, kCorner) - 3);
}

TEST(LightBounce, ScaleAppliesToTheSumOfBounces) {
  const auto level = lit_map(furnace_text("\"_bounce\" \"2\"\n\"_bouncescale\" \"0.5\""));
  const double expected = 20 + 0.5 * 20 * (add_bounces(gray_share(0.5), 2) - 1);
  for (const std::uint8_t luxel : level->light) ASSERT_NEAR(luxel, expected, 1);
}

// The form factor of a rectangle, seen from below one of its corners by a surface parallel to it (the closed
// form in Siegel and Howell, "Thermal Radiation Heat Transfer", 1972).
double corner_form_factor(double width, double depth, double distance) {
  const double x = width / distance, y = depth / distance;
  const double across_x = std::sqrt(1 + x * x), across_y = std::sqrt(1 + y * y);
  return (x / across_x * std::atan(y / across_x) + y / across_y * std::atan(x / across_y)) /
         (2 * std::numbers::pi);
}

// A lit floor and a dark ceiling between walls that take no part. They are large beside the 48 units between
// the compiler's nodes.
TEST(LightBounce, ParallelPlatesExchangeTheirFormFactor) {
  constexpr double kHalf = 192, kHeight = 256, kOuter = 208;
  std::string plates, walls;
  plates += box_text({-kOuter, -kOuter, -16}, {kOuter, kOuter, 0}, "stone");
  plates += box_text({-kOuter, -kOuter, kHeight}, {kOuter, kOuter, kHeight + 16}, "stone");
  walls += box_text({-kOuter, -kOuter, 0}, {-kHalf, kOuter, kHeight}, "stone");
  walls += box_text({kHalf, -kOuter, 0}, {kOuter, kOuter, kHeight}, "stone");
  walls += box_text({-kHalf, -kOuter, 0}, {kHalf, -kHalf, kHeight}, "stone");
  walls += box_text({-kHalf, kHalf, 0}, {kHalf, kOuter, kHeight}, "stone");
  const auto level = lit_map(entity_text("worldspawn", "\"_bounce\" \"1\"", plates) +
                             entity_text("func_group", "\"_bounce\" \"-1\"", walls) +
                             entity_text("light",
                                         "\"origin\" \"0 0 248\"\n\"light\" \"300\"\n\"delay\" \"3\"\n"
                                         "\"_anglescale\" \"0\"\n\"mangle\" \"0 -90 0\"\n\"angle\" \"178\"") +
                             point_text("info_player_start", {0, 0, 40}));
  const double sent = 150 * gray_share(0.5);
  for (double x = -176; x <= 176; x += 16)
    for (double y = -176; y <= 176; y += 16) {
      double seen = 0;
      for (const double width : {kHalf - x, kHalf + x})
        for (const double depth : {kHalf - y, kHalf + y})
          seen += corner_form_factor(width, depth, kHeight - 1);
      const Vec3d place(x, y, kHeight);
      ASSERT_NEAR(shown_light(*level, face_under(*level, place, {0, 0, -1}), place).x, sent * seen, 2.5)
          << x << " " << y;
    }
}

// A room with a pillar and one light, as the path tracer sees it.
struct PillarRoom {
  Vec3d low{0, 0, 0}, high{512, 384, 256};
  Vec3d pillar_low{256, 192, 0}, pillar_high{320, 256, 192};
  Vec3d light{128, 128, 176};
  double value = 250;
};

struct Hit {
  double distance = std::numeric_limits<double>::infinity();
  Vec3d normal{0.0};
};

// The nearest wall or side of the pillar along a ray.
Hit trace(const PillarRoom& room, const Vec3d& from, const Vec3d& direction) {
  Hit wall, pillar;
  double enter = 0, leave = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double step = direction[axis];
    if (step == 0) {
      if (from[axis] < room.pillar_low[axis] || from[axis] > room.pillar_high[axis]) leave = -1;
      continue;
    }
    Vec3d toward(0.0);
    toward[axis] = step > 0 ? -1 : 1;
    const double to_wall = ((step > 0 ? room.high : room.low)[axis] - from[axis]) / step;
    if (to_wall < wall.distance) wall = {to_wall, toward};
    const double a = (room.pillar_low[axis] - from[axis]) / step;
    const double b = (room.pillar_high[axis] - from[axis]) / step;
    if (std::min(a, b) > enter) {
      enter = std::min(a, b);
      pillar = {enter, toward};
    }
    leave = std::min(leave, std::max(a, b));
  }
  return enter > 0 && enter < leave && enter < wall.distance ? pillar : wall;
}

double direct_light(const PillarRoom& room, const Vec3d& place, const Vec3d& normal) {
  const Vec3d way = room.light - place;
  const double distance = glm::length(way), cosine = glm::dot(way, normal) / distance;
  if (cosine <= 0 || trace(room, place, way / distance).distance < distance) return 0;
  return std::max(0.0, room.value - distance) * (0.5 + 0.5 * cosine);
}

// A direction around a normal along an axis, distributed by the cosine.
Vec3d pick_direction(const Vec3d& normal, Random& io_random) {
  const double radius_squared = io_random.uniform(0, 1), turn = io_random.uniform(0, 2 * std::numbers::pi);
  const double radius = std::sqrt(radius_squared);
  const Vec3d right = normal.z != 0 ? Vec3d(1, 0, 0) : Vec3d(0, 0, 1);
  return right * (radius * std::cos(turn)) + glm::cross(normal, right) * (radius * std::sin(turn)) +
         normal * std::sqrt(1 - radius_squared);
}

// The light that a place gets over a number of bounces, as a mean over random paths.
double trace_bounces(const PillarRoom& room, const Vec3d& place, const Vec3d& normal, int bounces,
                     Random& io_random) {
  const int paths = effort(20000, 4000);
  double sum = 0;
  for (int path = 0; path < paths; ++path) {
    Vec3d at = place + normal, up = normal;
    double share = 1;
    for (int bounce = 0; bounce < bounces; ++bounce) {
      const Vec3d direction = pick_direction(up, io_random);
      const Hit hit = trace(room, at, direction);
      at += direction * hit.distance + hit.normal;
      up = hit.normal;
      share *= gray_share(0.5);
      sum += share * direct_light(room, at, up);
    }
  }
  return sum / paths;
}

TEST(LightBounce, EqualsTracedPaths) {
  const PillarRoom room;
  const auto lit_with = [&](int bounces) {
    return lit_map(entity_text("worldspawn", fmt::format("\"_bounce\" \"{}\"", bounces),
                               walls_text(room.low, room.high, "stone") +
                                   box_text(room.pillar_low, room.pillar_high, "stone")) +
                   entity_text("light", "\"origin\" \"128 128 176\"\n\"light\" \"250\"") +
                   point_text("info_player_start", {32, 32, 40}));
  };
  const auto direct = lit_with(0);
  struct LitPlace {
    Vec3d at, normal;
  };
  std::vector<LitPlace> places;
  for (const double x : {80.0, 200.0, 400.0})
    for (const double y : {80.0, 300.0})
      for (const double z : {0.0, 256.0}) places.push_back({{x, y, z}, {0, 0, z == 0 ? 1 : -1}});
  for (const double x : {80.0, 280.0, 440.0})
    for (const double z : {48.0, 180.0}) {
      places.push_back({{x, 0, z}, {0, 1, 0}});
      places.push_back({{x, 384, z}, {0, -1, 0}});
    }
  for (const double z : {48.0, 140.0}) {
    places.push_back({{256, 224, z}, {-1, 0, 0}});
    places.push_back({{320, 224, z}, {1, 0, 0}});
    places.push_back({{512, 200, z}, {-1, 0, 0}});
  }
  Random random(7);
  for (const int bounces : {1, 4}) {
    const auto lit = lit_with(bounces);
    double ours = 0, traced = 0;
    for (const auto& [at, normal] : places) {
      const double with = shown_light(*lit, face_under(*lit, at, normal), at).x;
      const double bounced = with - shown_light(*direct, face_under(*direct, at, normal), at).x;
      const double expected = trace_bounces(room, at, normal, bounces, random) / 2;
      EXPECT_NEAR(bounced, expected, 1.5 + 0.1 * expected)
          << bounces << " bounces at " << at.x << " " << at.y << " " << at.z;
      ours += bounced;
      traced += expected;
    }
    EXPECT_NEAR(ours / traced, 1, 0.03) << bounces;
  }
}

}  // namespace
}  // namespace temblor::test
