// Accelerations and friction, held against what their differential equations or sums come to.
#include "movement/velocity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random.h"

namespace temblor::movement {
namespace {

constexpr Settings kStock{};
constexpr float kTick_s = 1.0f / 72;
constexpr math::Vec3 kLevelLook{0, 0, 0};

TEST(Velocity, ComesToRestWithinTheDistanceOfTheFormula) {
  // Down to stop_speed it falls by a part of itself, v' = -4 v; from there evenly, v' = -400.
  const double kDistance = (320.0 - 100) / 4 + 100.0 * 100 / (2 * 400);
  for (const float tick_s : {1.0f / 20, 1.0f / 72, 1.0f / 1000}) {
    math::Vec3 velocity(320, 0, 0);
    double distance = 0, time_s = 0;
    while (velocity.x > 0 && time_s < 10) {
      velocity = slowed_on_ground(velocity, kStock, tick_s, false);
      distance += double{velocity.x} * tick_s;
      time_s += tick_s;
    }
    EXPECT_EQ(velocity, math::Vec3(0.0f));
    // The first tick's friction comes before its way: at most a tick's way is missing.
    EXPECT_LT(distance, kDistance);
    EXPECT_GT(distance, kDistance - 320 * tick_s);
    // ln(320/100)/4 until stop_speed, then 100/400.
    EXPECT_NEAR(time_s, std::log(3.2) / 4 + 0.25, 2 * tick_s);
  }
}

TEST(Velocity, IsSlowedTwiceAsHardAtAnEdge) {
  const math::Vec3 velocity(200, 100, -40);
  const math::Vec3 plain = slowed_on_ground(velocity, kStock, kTick_s, false);
  const math::Vec3 edge = slowed_on_ground(velocity, kStock, kTick_s, true);
  const float lost = glm::length(velocity - plain), lost_at_edge = glm::length(velocity - edge);
  EXPECT_NEAR(lost_at_edge / lost, 2, 1e-4);
  // All of it, though only the level part counts as speed.
  EXPECT_NEAR(edge.z / velocity.z, edge.x / velocity.x, 1e-5);
  EXPECT_EQ(slowed_on_ground({0, 0, 50}, kStock, kTick_s, true), math::Vec3(0, 0, 50));
}

TEST(Velocity, EdgesAreLookedForAheadOfTheFeet) {
  const EdgeProbe probe = edge_probe({10, 20, 30}, -24, {0, -200, 77});
  EXPECT_EQ(probe.start, math::Vec3(10, 4, 6));
  EXPECT_EQ(probe.end, math::Vec3(10, 4, -28));
}

TEST(Velocity, OnGroundReachesTheSpeedAskedForAndNoMore) {
  for (const float speed : {100.0f, 320.0f}) {
    math::Vec3 velocity(0.0f);
    float before = 0;
    for (int tick = 0; tick < 144; ++tick) {
      velocity = slowed_on_ground(velocity, kStock, kTick_s, false);
      velocity = accelerated_on_ground(velocity, {0, speed, 0}, kStock, kTick_s);
      EXPECT_GE(velocity.y, before);
      before = velocity.y;
    }
    EXPECT_NEAR(velocity.y, speed, 1e-3);
  }
  // The first tick: 10 times the speed asked for, for a tick.
  EXPECT_NEAR(accelerated_on_ground({0, 0, 0}, {320, 0, 0}, kStock, kTick_s).x, 10 * 320 * kTick_s, 1e-3);
}

TEST(Velocity, InAirGainsOnlyThirtyAlongTheWish) {
  math::Vec3 velocity(0, 300, 0);
  for (int tick = 0; tick < 72; ++tick) velocity = accelerated_in_air(velocity, {320, 0, 0}, kStock, kTick_s);
  EXPECT_NEAR(velocity.x, 30, 1e-3);
  EXPECT_EQ(velocity.y, 300);
  // But as hard as for 320: it is there in the first tick.
  EXPECT_NEAR(accelerated_in_air({0, 0, 0}, {320, 0, 0}, kStock, kTick_s).x, 30, 1e-3);
  // Turning the wish across the velocity adds speed, as players found out.
  EXPECT_GT(glm::length(velocity), 301);
}

TEST(Velocity, SwimmingReachesSevenTenths) {
  math::Vec3 velocity(0.0f);
  for (int tick = 0; tick < 200; ++tick)
    velocity = swum(velocity, {0, 90, 0}, {.forward = 400}, kStock, kTick_s);
  EXPECT_NEAR(velocity.y, 320 * 0.7, 0.01);
  EXPECT_NEAR(velocity.x, 0, 0.01);
  // Down where it looks.
  velocity = math::Vec3(0.0f);
  for (int tick = 0; tick < 200; ++tick)
    velocity = swum(velocity, {90, 0, 0}, {.forward = 200}, kStock, kTick_s);
  EXPECT_NEAR(velocity.z, -200 * 0.7, 0.01);
}

TEST(Velocity, WhoDoesNotSwimSinks) {
  math::Vec3 velocity(200, 0, 0);
  for (int tick = 0; tick < 300; ++tick) velocity = swum(velocity, kLevelLook, {}, kStock, kTick_s);
  EXPECT_NEAR(velocity.z, -60 * 0.7, 0.01);
  EXPECT_NEAR(velocity.x, 0, 0.01);
}

TEST(Velocity, WishesGoWhereTheLookGoes) {
  const math::Vec3 forward = wish_velocity({0, 90, 0}, {.forward = 200});
  EXPECT_NEAR(forward.y, 200, 1e-3);
  const math::Vec3 right = wish_velocity({0, 90, 0}, {.side = 100});
  EXPECT_NEAR(right.x, 100, 1e-3);
  EXPECT_NEAR(glm::length(capped({400, 300, 0}, 320)), 320, 1e-3);
  EXPECT_EQ(capped({30, 40, 0}, 320), math::Vec3(30, 40, 0));
}

TEST(Velocity, LeansTowardsItsSideAtMostTwoDegrees) {
  EXPECT_FLOAT_EQ(roll_deg(kLevelLook, {0, -100, 0}), 1);
  EXPECT_FLOAT_EQ(roll_deg(kLevelLook, {0, 100, 0}), -1);
  EXPECT_FLOAT_EQ(roll_deg(kLevelLook, {0, -900, 50}), 2);
  EXPECT_NEAR(roll_deg(kLevelLook, {320, 0, 0}), 0, 1e-5);
}

TEST(Velocity, PunchesFadeByTenDegreesASecond) {
  math::Vec3 punch(-3, 0, 4);
  punch = faded_punch(punch, 0.1f);
  EXPECT_NEAR(glm::length(punch), 4, 1e-5);
  EXPECT_NEAR(punch.x / punch.z, -0.75, 1e-5);
  EXPECT_EQ(faded_punch(punch, 1), math::Vec3(0.0f));
  EXPECT_EQ(faded_punch(math::Vec3(0.0f), 1), math::Vec3(0.0f));
}

TEST(Velocity, GroundAccelerationNeverOvershoots) {
  test::Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const math::Vec3 velocity = random.in_cube(400), wished = random.in_cube(300);
    const math::Vec3 after = accelerated_on_ground(velocity, wished, kStock, kTick_s);
    const math::Vec3 direction = glm::normalize(wished);
    const float before_along = glm::dot(velocity, direction), along = glm::dot(after, direction);
    EXPECT_LE(along, std::max(before_along, glm::length(wished)) + 0.01f);
    // Nothing across the wish.
    EXPECT_LT(glm::length((after - velocity) - direction * (along - before_along)), 0.01f);
  }
}

}  // namespace
}  // namespace temblor::movement
