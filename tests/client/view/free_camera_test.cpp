#include "client/view/free_camera.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/levels/drawable_level.h"
#include "support/pictures/viewpoints.h"
#include "world/trace.h"

namespace temblor::client {
namespace {

FreeCamera at(const math::Vec3& origin_world, const math::Vec3& angles_deg) {
  FreeCamera camera;
  camera.place({.origin_world = origin_world, .angles_deg = angles_deg, .fov_deg = 100});
  return camera;
}

void expect_near(const math::Vec3& a, const math::Vec3& b) {
  EXPECT_LT(glm::distance(a, b), 1e-3f) << a.x << " " << a.y << " " << a.z;
}

TEST(FreeCamera, FliesWhereItLooks) {
  FreeCamera camera = at({1, 2, 3}, {0, 90, 7});
  EXPECT_EQ(camera.camera().fov_deg, 100);
  EXPECT_EQ(camera.camera().angles_deg, math::Vec3(0, 90, 0)) << "upright";
  camera.fly({.forward = 1}, 100, 0.5, nullptr);
  expect_near(camera.camera().origin_world, {1, 52, 3});
  camera.fly({.right = 1}, 100, 0.1, nullptr);
  expect_near(camera.camera().origin_world, {11, 52, 3});
  camera.fly({.up = -0.5f}, 100, 0.1, nullptr);
  expect_near(camera.camera().origin_world, {11, 52, -2});
  camera.turn(90, 0);
  camera.fly({.forward = 1}, 100, 1, nullptr);
  expect_near(camera.camera().origin_world, {11, 52, -102});
}

TEST(FreeCamera, IsNotFasterDiagonally) {
  FreeCamera camera = at({0, 0, 0}, {0, 0, 0});
  camera.fly({.forward = 1, .right = 1, .up = 1}, 60, 1, nullptr);
  EXPECT_NEAR(glm::length(camera.camera().origin_world), 60, 1e-3);
}

TEST(FreeCamera, TurnsAroundFreelyButPitchIsLimited) {
  FreeCamera camera = at({0, 0, 0}, {350, 0, 0});
  EXPECT_EQ(camera.camera().angles_deg.x, -10);
  camera.turn(1000, 0);
  EXPECT_EQ(camera.camera().angles_deg.x, 90);
  for (int i = 0; i < 100; ++i) camera.turn(-7, 100);
  EXPECT_EQ(camera.camera().angles_deg.x, -90);
  EXPECT_LE(std::abs(camera.camera().angles_deg.y), 180);
  EXPECT_NEAR(std::remainder(camera.camera().angles_deg.y - 10000, 360.0f), 0, 1e-3);
}

// Flights in all directions: the camera never leaves the level, stays away from walls, and does not stick to
// them.
TEST(FreeCamera, SlidesAlongWalls) {
  const auto drawable = test::small_level();
  const world::Level& level = *drawable.level;
  double flown = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    test::Random random(seed);
    FreeCamera camera;
    camera.place(test::random_camera(level, random));
    if (!camera.is_inside(level)) continue;
    for (int step = 0; step < 60; ++step) {
      const math::Vec3 before = camera.camera().origin_world;
      camera.turn(static_cast<float>(random.uniform(-20, 20)), static_cast<float>(random.uniform(-30, 30)));
      camera.fly({.forward = 1}, 400, 0.05, &level);
      const math::Vec3 place = camera.camera().origin_world;
      EXPECT_TRUE(camera.is_inside(level)) << seed;
      const world::Trace trace =
          world::trace_line(level, world::ModelIndex{0}, world::Hull::kPoint, before, place);
      EXPECT_TRUE(trace.fraction == 1 || trace.start_solid) << seed;
      flown += double{glm::distance(before, place)};
    }
  }
  EXPECT_GT(flown, 10000);
}

TEST(FreeCamera, StopsBeforeAWallAndComesBackFromOutside) {
  const auto drawable = test::small_level();
  const world::Level& level = *drawable.level;
  test::Random random(1);
  FreeCamera camera;
  do camera.place(test::random_camera(level, random));
  while (!camera.is_inside(level));
  for (int step = 0; step < 500; ++step) camera.fly({.up = -1}, 400, 0.05, &level);
  const math::Vec3 place = camera.camera().origin_world;
  const world::Trace below = world::trace_line(level, world::ModelIndex{0}, world::Hull::kPoint, place,
                                               place - math::Vec3(0, 0, 100));
  EXPECT_NEAR(glm::distance(place, below.end), 8, 0.2) << "above the floor";
  camera.place({.origin_world = place - math::Vec3(0, 0, 20)});
  ASSERT_FALSE(camera.is_inside(level));
  for (int step = 0; step < 3; ++step) camera.fly({.up = 1}, 400, 0.05, &level);
  EXPECT_TRUE(camera.is_inside(level));
}

TEST(FreeCamera, StaysWhereFloatsArePrecise) {
  FreeCamera camera = at({0, 0, 0}, {-30, 45, 0});
  for (int i = 0; i < 100; ++i) camera.fly({.forward = 1}, 1e6f, 1, nullptr);
  const math::Vec3 far_world = camera.camera().origin_world;
  EXPECT_TRUE(std::isfinite(glm::length(far_world)));
  camera.turn(60, 180);
  camera.fly({.forward = 1}, 10, 1, nullptr);
  EXPECT_NE(camera.camera().origin_world, far_world);
}

}  // namespace
}  // namespace temblor::client
