#include "client/view/free_camera.h"

#include <gtest/gtest.h>

#include <cmath>

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
  camera.fly({.forward = 1}, 100, 0.5);
  expect_near(camera.camera().origin_world, {1, 52, 3});
  camera.fly({.right = 1}, 100, 0.1);
  expect_near(camera.camera().origin_world, {11, 52, 3});
  camera.fly({.up = -0.5f}, 100, 0.1);
  expect_near(camera.camera().origin_world, {11, 52, -2});
  camera.turn(90, 0);
  camera.fly({.forward = 1}, 100, 1);
  expect_near(camera.camera().origin_world, {11, 52, -102});
}

TEST(FreeCamera, IsNotFasterDiagonally) {
  FreeCamera camera = at({0, 0, 0}, {0, 0, 0});
  camera.fly({.forward = 1, .right = 1, .up = 1}, 60, 1);
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

TEST(FreeCamera, StaysWhereFloatsArePrecise) {
  FreeCamera camera = at({0, 0, 0}, {-30, 45, 0});
  for (int i = 0; i < 100; ++i) camera.fly({.forward = 1}, 1e6f, 1);
  const math::Vec3 far_world = camera.camera().origin_world;
  EXPECT_TRUE(std::isfinite(glm::length(far_world)));
  camera.turn(60, 180);
  camera.fly({.forward = 1}, 10, 1);
  EXPECT_NE(camera.camera().origin_world, far_world);
}

}  // namespace
}  // namespace temblor::client
