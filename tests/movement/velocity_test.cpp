// Accelerations and friction, compared with the solutions of their differential equations or sums.
#include "movement/player/velocity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random.h"

namespace temblor::movement {
namespace {

constexpr math::PhysicsSettings kStock{};
constexpr float kStockTick_s = 1.0f / 72;
constexpr math::Vec3 kLevelLook{0, 0, 0};

TEST(Velocity, ComesToRestWithinTheDistanceOfTheFormula) {
  // Down to stop_speed the speed decays exponentially, v' = -4 v; from there linearly, v' = -400.
  const double kDistance = (320.0 - 100) / 4 + 100.0 * 100 / (2 * 400);
  for (const float tick_s : {1.0f / 20, 1.0f / 72, 1.0f / 1000}) {
    math::Vec3 velocity(320, 0, 0);
    double distance = 0, time_s = 0;
    while (velocity.x > 0 && time_s < 10) {
      velocity = apply_ground_friction(velocity, kStock, tick_s, false);
      distance += double{velocity.x} * tick_s;
      time_s += tick_s;
    }
    EXPECT_EQ(velocity, math::Vec3(0.0f));
    // The first tick's friction comes before its motion: at most one tick's distance is missing.
    EXPECT_LT(distance, kDistance);
    EXPECT_GT(distance, kDistance - 320 * tick_s);
    // ln(320/100)/4 seconds until stop_speed, then 100/400.
    EXPECT_NEAR(time_s, std::log(3.2) / 4 + 0.25, 2 * tick_s);
  }
}

TEST(Velocity, IsSlowedTwiceAsMuchAtAnEdge) {
  const math::Vec3 velocity(200, 100, -40);
  const math::Vec3 plain = apply_ground_friction(velocity, kStock, kStockTick_s, false);
  const math::Vec3 edge = apply_ground_friction(velocity, kStock, kStockTick_s, true);
  const float lost = glm::length(velocity - plain), lost_at_edge = glm::length(velocity - edge);
  EXPECT_NEAR(lost_at_edge / lost, 2, 1e-4);
  // All components, although only the horizontal ones count as speed.
  EXPECT_NEAR(edge.z / velocity.z, edge.x / velocity.x, 1e-5);
  EXPECT_EQ(apply_ground_friction({0, 0, 50}, kStock, kStockTick_s, true), math::Vec3(0, 0, 50));
}

TEST(Velocity, EdgesAreProbedAheadOfTheFeet) {
  const EdgeProbe probe = make_edge_probe({10, 20, 30}, -24, {0, -200, 77});
  EXPECT_EQ(probe.start, math::Vec3(10, 4, 6));
  EXPECT_EQ(probe.end, math::Vec3(10, 4, -28));
}

TEST(Velocity, OnGroundReachesTheWishedSpeedAndNoMore) {
  for (const float speed : {100.0f, 320.0f}) {
    math::Vec3 velocity(0.0f);
    float before = 0;
    for (int tick = 0; tick < 144; ++tick) {
      velocity = apply_ground_friction(velocity, kStock, kStockTick_s, false);
      velocity = accelerate_on_ground(velocity, {0, speed, 0}, kStock, kStockTick_s);
      EXPECT_GE(velocity.y, before);
      before = velocity.y;
    }
    EXPECT_NEAR(velocity.y, speed, 1e-3);
  }
  // The first tick: an acceleration of 10 times the wished speed.
  EXPECT_NEAR(accelerate_on_ground({0, 0, 0}, {320, 0, 0}, kStock, kStockTick_s).x, 10 * 320 * kStockTick_s,
              1e-3);
}

TEST(Velocity, InAirGainsOnlyThirtyAlongTheWish) {
  math::Vec3 velocity(0, 300, 0);
  for (int tick = 0; tick < 72; ++tick)
    velocity = accelerate_in_air(velocity, {320, 0, 0}, kStock, kStockTick_s);
  EXPECT_NEAR(velocity.x, 30, 1e-3);
  EXPECT_EQ(velocity.y, 300);
  // But as quickly as for 320: it is reached in the first tick.
  EXPECT_NEAR(accelerate_in_air({0, 0, 0}, {320, 0, 0}, kStock, kStockTick_s).x, 30, 1e-3);
  // A wish perpendicular to the velocity adds speed, as players found out.
  EXPECT_GT(glm::length(velocity), 301);
}

TEST(Velocity, SwimmingReachesSevenTenths) {
  math::Vec3 velocity(0.0f);
  for (int tick = 0; tick < 200; ++tick)
    velocity = accelerate_in_water(velocity, {0, 90, 0}, {.forward = 400}, kStock, kStockTick_s);
  EXPECT_NEAR(velocity.y, 320 * 0.7, 0.01);
  EXPECT_NEAR(velocity.x, 0, 0.01);
  // A player who looks down swims down.
  velocity = math::Vec3(0.0f);
  for (int tick = 0; tick < 200; ++tick)
    velocity = accelerate_in_water(velocity, {90, 0, 0}, {.forward = 200}, kStock, kStockTick_s);
  EXPECT_NEAR(velocity.z, -200 * 0.7, 0.01);
}

TEST(Velocity, PlayersWithoutAWishSinkInWater) {
  math::Vec3 velocity(200, 0, 0);
  for (int tick = 0; tick < 300; ++tick)
    velocity = accelerate_in_water(velocity, kLevelLook, {}, kStock, kStockTick_s);
  EXPECT_NEAR(velocity.z, -60 * 0.7, 0.01);
  EXPECT_NEAR(velocity.x, 0, 0.01);
}

TEST(Velocity, WishesFollowTheViewAngles) {
  const math::Vec3 forward = find_wish_velocity({0, 90, 0}, {.forward = 200});
  EXPECT_NEAR(forward.y, 200, 1e-3);
  const math::Vec3 right = find_wish_velocity({0, 90, 0}, {.side = 100});
  EXPECT_NEAR(right.x, 100, 1e-3);
  EXPECT_NEAR(glm::length(limit_speed({400, 300, 0}, 320)), 320, 1e-3);
  EXPECT_EQ(limit_speed({30, 40, 0}, 320), math::Vec3(30, 40, 0));
}

TEST(Velocity, LeansTowardItsSidewaysMotionByAtMostTwoDegrees) {
  EXPECT_FLOAT_EQ(find_roll_deg(kLevelLook, {0, -100, 0}), 1);
  EXPECT_FLOAT_EQ(find_roll_deg(kLevelLook, {0, 100, 0}), -1);
  EXPECT_FLOAT_EQ(find_roll_deg(kLevelLook, {0, -900, 50}), 2);
  EXPECT_NEAR(find_roll_deg(kLevelLook, {320, 0, 0}), 0, 1e-5);
}

TEST(Velocity, PunchesFadeByTenDegreesPerSecond) {
  math::Vec3 punch(-3, 0, 4);
  punch = fade_punch(punch, 0.1f);
  EXPECT_NEAR(glm::length(punch), 4, 1e-5);
  EXPECT_NEAR(punch.x / punch.z, -0.75, 1e-5);
  EXPECT_EQ(fade_punch(punch, 1), math::Vec3(0.0f));
  EXPECT_EQ(fade_punch(math::Vec3(0.0f), 1), math::Vec3(0.0f));
}

TEST(Velocity, GroundAccelerationNeverOvershoots) {
  test::Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const math::Vec3 velocity = random.in_cube(400), wished = random.in_cube(300);
    const math::Vec3 after = accelerate_on_ground(velocity, wished, kStock, kStockTick_s);
    const math::Vec3 direction = glm::normalize(wished);
    const float before_along = glm::dot(velocity, direction), along = glm::dot(after, direction);
    EXPECT_LE(along, std::max(before_along, glm::length(wished)) + 0.01f);
    // Nothing perpendicular to the wish.
    EXPECT_LT(glm::length((after - velocity) - direction * (along - before_along)), 0.01f);
  }
}

}  // namespace
}  // namespace temblor::movement
