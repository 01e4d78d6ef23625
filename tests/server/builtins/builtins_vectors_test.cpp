// Directions, lengths, numbers and random numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "server/builtins/builtin_stage.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using math::Vec3;

void expect_near(const Vec3& a, const Vec3& b) {
  EXPECT_LT(glm::distance(a, b), 1e-6f) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(VectorBuiltins, MakevectorsSetsThreeGlobals) {
  Stage stage;
  stage.run("makevectors", Vec3(0, 90, 0));
  expect_near(stage.machine.global_vector(vm::GlobalIndex{59}), {0, 1, 0});
  expect_near(stage.machine.global_vector(vm::GlobalIndex{62}), {0, 0, 1});
  expect_near(stage.machine.global_vector(vm::GlobalIndex{65}), {1, 0, 0});
  stage.run("makevectors", Vec3(90, 0, 0));
  expect_near(stage.machine.global_vector(vm::GlobalIndex{59}), {0, 0, -1});
  stage.run("makevectors", Vec3(0, 0, 90));
  expect_near(stage.machine.global_vector(vm::GlobalIndex{62}), {0, -1, 0});
}

TEST(VectorBuiltins, NormalizeAndVlen) {
  Stage stage;
  expect_near(stage.vector("normalize", Vec3(3, 0, -4)), {0.6f, 0, -0.8f});
  expect_near(stage.vector("normalize", Vec3(0.0f)), Vec3(0.0f));
  EXPECT_FLOAT_EQ(stage.number("vlen", Vec3(2, 3, 6)), 7);
  EXPECT_EQ(stage.number("vlen", Vec3(0.0f)), 0);
}

TEST(VectorBuiltins, AnglesAreTruncatedToWholeDegrees) {
  Stage stage;
  EXPECT_EQ(stage.number("vectoyaw", Vec3(1, 0, 5)), 0);
  EXPECT_EQ(stage.number("vectoyaw", Vec3(0, 1, 0)), 90);
  EXPECT_EQ(stage.number("vectoyaw", Vec3(-1, 0, 0)), 180);
  EXPECT_EQ(stage.number("vectoyaw", Vec3(0, -1, 0)), 270);
  EXPECT_EQ(stage.number("vectoyaw", Vec3(0, 0, 9)), 0);
  // -2.86 degrees are truncated toward 0, and -0.06 to 0 itself.
  EXPECT_EQ(stage.number("vectoyaw", Vec3(1, -0.05f, 0)), 358);
  EXPECT_EQ(stage.number("vectoyaw", Vec3(1, -0.001f, 0)), 0);
  EXPECT_EQ(stage.vector("vectoangles", Vec3(1, 0, 1)), Vec3(45, 0, 0));
  EXPECT_EQ(stage.vector("vectoangles", Vec3(1, 1, -0.1f)), Vec3(356, 45, 0));
  EXPECT_EQ(stage.vector("vectoangles", Vec3(0, 0, 2)), Vec3(90, 0, 0));
  EXPECT_EQ(stage.vector("vectoangles", Vec3(0, 0, -2)), Vec3(270, 0, 0));
  EXPECT_EQ(stage.vector("vectoangles", Vec3(0.0f)), Vec3(270, 0, 0));
}

TEST(VectorBuiltins, AnglesAreWholeAndRightWithinADegree) {
  Stage stage;
  Random random(3);
  for (int i = 0; i < 500; ++i) {
    const Vec3 way = random.in_cube(100);
    const Vec3 angles = stage.vector("vectoangles", way);
    ASSERT_EQ(angles, glm::floor(angles));
    ASSERT_EQ(stage.number("vectoyaw", way), angles.y);
    const double pitch = std::numbers::pi / 180 * angles.x, yaw = std::numbers::pi / 180 * angles.y;
    const Vec3 back(
        math::Vec3d(std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw), std::sin(pitch)));
    ASSERT_GT(glm::dot(back, glm::normalize(way)), std::cos(1.5 * std::numbers::pi / 180));
  }
}

TEST(VectorBuiltins, RandomvecIsInTheUnitBall) {
  Stage stage;
  Vec3 sum(0.0f);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 vector = stage.vector("randomvec");
    ASSERT_LE(glm::dot(vector, vector), 1.0f);
    sum += vector;
  }
  EXPECT_LT(glm::length(sum) / 2000, 0.05f);
}

TEST(NumberBuiltins, RandomIs15BitsOf32767) {
  Stage stage;
  server::GameRandom same;
  for (int i = 0; i < 1000; ++i) {
    const float value = stage.number("random");
    ASSERT_EQ(value, static_cast<float>(same.next_15_bits()) / 32767);
    ASSERT_GE(value, 0);
    ASSERT_LE(value, 1);
  }
}

TEST(NumberBuiltins, Rounding) {
  Stage stage;
  for (const auto& [value, rounded] : {std::pair(0.5f, 1.0f), {-0.5f, -1.0f}, {1.49f, 1.0f}, {2.5f, 3.0f}})
    EXPECT_EQ(stage.number("rint", value), rounded);
  EXPECT_EQ(stage.number("floor", -1.5f), -2);
  EXPECT_EQ(stage.number("ceil", -1.5f), -1);
  EXPECT_EQ(stage.number("fabs", -1.5f), 1.5f);
  EXPECT_EQ(stage.number("floor", 1e20f), 1e20f);
}

TEST(NumberBuiltins, Functions) {
  Stage stage;
  EXPECT_FLOAT_EQ(stage.number("sin", 1.5707964f), 1);
  EXPECT_FLOAT_EQ(stage.number("cos", 3.1415927f), -1);
  EXPECT_EQ(stage.number("sqrt", 49), 7);
  EXPECT_TRUE(std::isnan(stage.number("sqrt", -1)));
  EXPECT_EQ(stage.number("pow", 2, 10), 1024);
  EXPECT_EQ(stage.number("min", 3, 1, 2), 1);
  EXPECT_EQ(stage.number("max", 3, 1), 3);
  EXPECT_EQ(stage.number("min", 8, 7, 6, 5, 4, 3, 2, 1), 1);
  EXPECT_EQ(stage.number("max", 1, 2, 3, 4, 5, 6, 7, 8), 8);
  EXPECT_EQ(stage.number("bound", 1, 5, 3), 3);
  EXPECT_EQ(stage.number("bound", 1, 0, 3), 1);
  EXPECT_EQ(stage.number("bound", 1, 2, 3), 2);
  EXPECT_NE(stage.error("min", 1).find("builtin min: takes 2 to 8 numbers, not 1"), std::string::npos);
}

TEST(NumberBuiltins, AcceptNan) {
  Stage stage;
  for (const float value : {kNan, std::numeric_limits<float>::infinity(), -3e38f})
    for (const char* name : {"rint", "floor", "ceil", "fabs", "sin", "cos", "sqrt"}) stage.run(name, value);
  stage.run("vectoangles", Vec3(kNan));
  stage.run("vectoyaw", Vec3(kNan, 1, 0));
  stage.run("makevectors", Vec3(3e38f, kNan, 0));
}

}  // namespace
}  // namespace temblor::test
