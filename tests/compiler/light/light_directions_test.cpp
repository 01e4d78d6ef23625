// Directions of light (LIGHTINGDIR), compared with where the lights are.
#include "formats/bspx/light_directions.h"

#include <gtest/gtest.h>

#include <functional>

#include "compiler/light/lighting.h"

namespace temblor::test {
namespace {

using math::Vec3;
using math::Vec3d;

constexpr compiler::LightOptions kWithDirections{.directions = true};
// A byte has steps of 1/127; the room's luxels are a unit in front of its walls.
constexpr double kTolerance = 0.012;

// Calls check(place, normal, direction) for each luxel of style 0, with the direction in the world's space.
// All faces of the room have perpendicular texture axes of length 1.
void for_each_luxel(const formats::Bsp& bsp,
                    const std::function<void(const Vec3d&, const Vec3d&, const Vec3d&)>& check) {
  const auto level = world::make_level(bsp, "room").value();
  const std::vector<std::uint8_t> bytes = formats::read_light_directions(bsp).value();
  ASSERT_EQ(bytes.size(), 3 * bsp.lighting.size());
  std::size_t count = 0;
  for (std::size_t number = 0; number < level->faces.size(); ++number) {
    const world::Face& face = level->faces[number];
    if (bsp.faces[number].light_offset < 0 || bsp.faces[number].styles[0] != 0) continue;
    const world::TextureAxes& axes = level->texture_axes[face.axes];
    const Vec3d normal = world::compute_face_plane(*level, face).normal;
    for (int row = 0; row < face.light_height(); ++row)
      for (int column = 0; column < face.light_width(); ++column, ++count) {
        const auto sample = static_cast<std::size_t>(bsp.faces[number].light_offset) +
                            static_cast<std::size_t>(row * face.light_width() + column);
        const Vec3 in_face = formats::unpack_direction(std::span(bytes).subspan(sample * 3).first<3>());
        ASSERT_NEAR(glm::length(in_face), 1, 0.01);
        const Vec3d direction = Vec3d(axes.s_axis) * double{in_face.x} +
                                Vec3d(axes.t_axis) * double{in_face.y} + normal * double{in_face.z};
        check(luxel_place(*level, face, column, row) + normal, normal, direction);
      }
  }
  ASSERT_GT(count, 100u);
}

bool is_at_edge(const Vec3d& place) {
  int beyond = 0;
  for (int axis = 0; axis < 3; ++axis) beyond += std::abs(place[axis]) > kHalfRoom - 8 ? 1 : 0;
  return beyond > 1;  // in its plane, too; places beyond the face are moved
}

TEST(LightDirections, PointTowardTheLight) {
  const Vec3d lamp(10, -20, 30);
  const LitResult lit =
      light(room_with({.entities = "{ 'classname' 'light' 'origin' '10 -20 30' }"}), kWithDirections);
  std::size_t checked = 0;
  for_each_luxel(lit.bsp, [&](const Vec3d& place, const Vec3d&, const Vec3d& direction) {
    if (is_at_edge(place)) return;
    const Vec3d expected = glm::normalize(lamp - place);
    ASSERT_LT(glm::distance(direction, expected), kTolerance) << place.x << " " << place.y << " " << place.z;
    ++checked;
  });
  EXPECT_GT(checked, 100u);
  const LitResult usual = light(room_with({.entities = "{ 'classname' 'light' 'origin' '10 -20 30' }"}));
  EXPECT_EQ(usual.bsp.lighting, lit.bsp.lighting);
  EXPECT_EQ(usual.bsp.find_bspx(formats::kLightDirectionsLump), nullptr);
  EXPECT_EQ(light(lit.bsp).bsp, usual.bsp) << "lit again without the option";
}

// Two lights of the same brightness everywhere, but one is red and weighs as much as its strongest channel.
TEST(LightDirections, AreTheMeanByBrightness) {
  const LitResult lit = light(room_with({.entities = "{ 'classname' 'light' 'origin' '-30 0 20' 'delay' '3' "
                                                     "'light' '100' '_anglescale' '0' }"
                                                     "{ 'classname' 'light' 'origin' '30 10 0' 'delay' '3' "
                                                     "'light' '50' '_anglescale' '0' '_color' '1 0 0' }"}),
                              kWithDirections);
  for_each_luxel(lit.bsp, [&](const Vec3d& place, const Vec3d&, const Vec3d& direction) {
    if (is_at_edge(place)) return;
    const Vec3d sum =
        2.0 * glm::normalize(Vec3d(-30, 0, 20) - place) + glm::normalize(Vec3d(30, 10, 0) - place);
    ASSERT_LT(glm::distance(direction, glm::normalize(sum)), kTolerance)
        << place.x << " " << place.y << " " << place.z;
  });
}

TEST(LightDirections, SunHasOneDirection) {
  const LitResult lit = light(
      room_with({.world_keys = "'_sunlight' '200' '_sun_mangle' '30 -50 0'", .sky = true}), kWithDirections);
  const double yaw = 30 * M_PI / 180, pitch = -50 * M_PI / 180;
  const Vec3d toward =
      -Vec3d(std::cos(yaw) * std::cos(pitch), std::sin(yaw) * std::cos(pitch), std::sin(pitch));
  std::size_t lit_by_sun = 0, dark = 0;
  for_each_luxel(lit.bsp, [&](const Vec3d&, const Vec3d& normal, const Vec3d& direction) {
    const bool is_sun = glm::distance(direction, toward) < kTolerance,
               is_dark = glm::distance(direction, normal) < kTolerance;
    ASSERT_TRUE(is_sun || is_dark);
    ++(is_sun ? lit_by_sun : dark);
  });
  EXPECT_GT(lit_by_sun, 20u);
  EXPECT_GT(dark, 5u);
}

TEST(LightDirections, MinimumLightAndNoLightComeAlongTheNormal) {
  const LitResult lit = light(room_with({.world_keys = "'_minlight' '60'"}), kWithDirections);
  for_each_luxel(lit.bsp, [&](const Vec3d&, const Vec3d& normal, const Vec3d& direction) {
    ASSERT_LT(glm::distance(direction, normal), kTolerance);
  });
}

// Bounced light turns directions toward the normal.
TEST(LightDirections, BouncedLightComesFromAllAround) {
  const formats::Bsp room = room_with({.entities = "{ 'classname' 'light' 'origin' '40 0 -50' }"});
  const LitResult once = light(room, kWithDirections),
                  bounced = light(room, {.bounces = 4, .directions = true});
  const auto sum_facing = [](const LitResult& lit) {
    double sum = 0;
    for_each_luxel(lit.bsp, [&](const Vec3d&, const Vec3d& normal, const Vec3d& direction) {
      sum += glm::dot(normal, direction);
    });
    return sum;
  };
  EXPECT_GT(sum_facing(bounced), sum_facing(once) * 1.02);
}

// A cache that was made without directions has none of the sky's.
TEST(LightDirections, AreTheSameWithACache) {
  const formats::Bsp room = room_with({.entities = "{ 'classname' 'light' 'origin' '40 0 -50' }",
                                       .world_keys = "'_sunlight' '200' '_sun_mangle' '30 -50 0' '_dirt' '1'",
                                       .sky = true});
  const LitResult expected = light(room, kWithDirections);
  compiler::LightCache cache;
  light(room, {}, 1, &cache);
  EXPECT_EQ(light(room, kWithDirections, 2, &cache).bsp, expected.bsp);
  EXPECT_EQ(light(room, kWithDirections, 1, &cache).bsp, expected.bsp);
  EXPECT_EQ(light(room, {}, 1, &cache).bsp, light(room).bsp);
}

}  // namespace
}  // namespace temblor::test
