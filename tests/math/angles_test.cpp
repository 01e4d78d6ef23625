#include "math/angles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace temblor::math {
namespace {

constexpr double kTolerance = 1e-6;  // of a component, because the angles are floats

void expect_near(const Vec3d& actual, const Vec3d& expected, const char* what) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(actual[axis], expected[axis], kTolerance) << what << axis;
}

// Rodrigues' rotation of `vector` about a unit `axis`, counter-clockwise for a viewer toward whom the axis
// points.
Vec3d rotated(const Vec3d& vector, const Vec3d& axis, double angle_deg) {
  const double angle = angle_deg * std::numbers::pi / 180;
  return vector * std::cos(angle) + glm::cross(axis, vector) * std::sin(angle) +
         axis * (glm::dot(axis, vector) * (1 - std::cos(angle)));
}

TEST(Angles, ZeroLooksAlongX) {
  const Basis basis = basis_from_angles({0, 0, 0});
  expect_near(basis.forward, {1, 0, 0}, "forward");
  expect_near(basis.right, {0, -1, 0}, "right");
  expect_near(basis.up, {0, 0, 1}, "up");
}

TEST(Angles, QuarterTurns) {
  expect_near(basis_from_angles({0, 90, 0}).forward, {0, 1, 0}, "yaw turns left, forward ");
  expect_near(basis_from_angles({0, 90, 0}).right, {1, 0, 0}, "yaw turns left, right ");
  expect_near(basis_from_angles({90, 0, 0}).forward, {0, 0, -1}, "pitch looks down, forward ");
  expect_near(basis_from_angles({90, 0, 0}).up, {1, 0, 0}, "pitch looks down, up ");
  expect_near(basis_from_angles({0, 0, 90}).right, {0, 0, -1}, "roll lowers the right, right ");
  expect_near(basis_from_angles({0, 0, 90}).forward, {1, 0, 0}, "roll lowers the right, forward ");
}

// First roll about the axis of view, then pitch, then yaw about the vertical.
TEST(Angles, AreThreeRotationsOneAfterAnother) {
  std::mt19937_64 random(1);
  const auto angle = [&] { return static_cast<float>(random() % 7200) / 10.0f - 360.0f; };
  for (int round = 0; round < 1000; ++round) {
    const Vec3 angles_deg(angle(), angle(), angle());
    const auto turned = [&](const Vec3d& vector) {
      const Vec3d rolled = rotated(vector, {1, 0, 0}, angles_deg.z);
      return rotated(rotated(rolled, {0, 1, 0}, angles_deg.x), {0, 0, 1}, angles_deg.y);
    };
    const Basis basis = basis_from_angles(angles_deg);
    expect_near(basis.forward, turned({1, 0, 0}), "forward ");
    expect_near(basis.right, turned({0, -1, 0}), "right ");
    expect_near(basis.up, turned({0, 0, 1}), "up ");
    ASSERT_FALSE(::testing::Test::HasFailure()) << angles_deg.x << " " << angles_deg.y << " " << angles_deg.z;
  }
}

}  // namespace
}  // namespace temblor::math
