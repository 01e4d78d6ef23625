#include "client/view/view_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace temblor::client {
namespace {

TEST(ViewMotion, Bob) {
  // 0.02 per unit of speed: 6.4 at 320, 30 % of it constant and 70 % a sine with a period of 0.6 s.
  const math::Vec3 running(192, 256, -500);
  EXPECT_NEAR(compute_bob(0, running), 1.92, 1e-4);
  EXPECT_NEAR(compute_bob(0.025, running), 1.92 + 4.48 * 0.258819, 1e-4);
  EXPECT_NEAR(compute_bob(0.15, running), 4, 1e-4);              // 6.4, cut off
  EXPECT_NEAR(compute_bob(0.45, running), 1.92 - 4.48, 1e-4);    // downward
  EXPECT_NEAR(compute_bob(0.45, running * 4.0f), -7, 1e-4);      // -10.24, cut off
  EXPECT_NEAR(compute_bob(600.45, running), 1.92 - 4.48, 1e-3);  // the same as a thousand cycles earlier
  EXPECT_EQ(compute_bob(0.15, {0, 0, 300}), 0);
  // It rises for a quarter of a second, and falls for three quarters.
  EXPECT_NEAR(compute_bob(0.1, running * 0.5f, 1, 0.25), 0.96 + 2.24 * 0.951057, 1e-4);
  EXPECT_NEAR(compute_bob(0.625, running * 0.5f, 1, 0.25), 0.96 - 2.24, 1e-4);
  for (const double up : {0.0, 1.0}) EXPECT_TRUE(std::isfinite(compute_bob(0.3, running, 0.6, up))) << up;
  EXPECT_EQ(compute_bob(0.15, running, 0, 0.5), 0);
}

TEST(ViewMotion, StrafeRoll) {
  const math::Vec3 right(0, -1, 0);
  EXPECT_FLOAT_EQ(compute_strafe_roll_deg({320, 0, 0}, right), 0);
  EXPECT_FLOAT_EQ(compute_strafe_roll_deg({0, -100, 0}, right), 1);
  EXPECT_FLOAT_EQ(compute_strafe_roll_deg({0, 50, 0}, right), -0.5);
  EXPECT_FLOAT_EQ(compute_strafe_roll_deg({0, -350, 0}, right), 2);
  EXPECT_FLOAT_EQ(compute_strafe_roll_deg({0, 350, 0}, right), -2);
}

TEST(ViewMotion, IdleSway) {
  EXPECT_EQ(compute_idle_sway_deg(0), math::Vec3(0, 0, 0));
  const math::Vec3 sway = compute_idle_sway_deg(1);
  EXPECT_NEAR(sway.x, 0.3 * 0.841471, 1e-5);
  EXPECT_NEAR(sway.y, 0.3 * 0.909297, 1e-5);
  EXPECT_NEAR(sway.z, 0.1 * 0.479426, 1e-5);
}

TEST(ViewMotion, StairsAreClimbedAt80UnitsASecond) {
  StairSmoothing stairs;
  stairs.reset(0);
  EXPECT_EQ(stairs.advance(8, true, 0), -8);
  EXPECT_FLOAT_EQ(stairs.advance(8, true, 0.05), -4);
  EXPECT_FLOAT_EQ(stairs.advance(16, true, 0.025), -10);
  EXPECT_FLOAT_EQ(stairs.advance(34, true, 0.025), -12);  // the largest lag
  EXPECT_FLOAT_EQ(stairs.advance(34, true, 1), 0);
  EXPECT_EQ(stairs.advance(50, false, 0), 0);  // in a jump the eyes stay with the body
  EXPECT_EQ(stairs.advance(20, true, 0), 0);   // and on the way down
}

TEST(ViewMotion, StairsAreTheSameAtAnyFrameRate) {
  for (const int frames_per_second : {10, 72, 1000}) {
    StairSmoothing stairs;
    stairs.reset(0);
    float behind = stairs.advance(10, true, 0);
    for (int frame = 0; frame < frames_per_second / 10; ++frame)
      behind = stairs.advance(10, true, 1.0 / frames_per_second);
    // A tenth of a second, or seven frames of 1/72 s, which is close to it.
    const float elapsed_s =
        static_cast<float>(frames_per_second / 10) / static_cast<float>(frames_per_second);
    EXPECT_NEAR(behind, -10 + 80 * elapsed_s, 1e-3f) << frames_per_second;
  }
}

TEST(ViewMotion, DamageKick) {
  constexpr double kKick_s = 0.5;
  // 20 of armor, 60 of blood: 40, times 0.6.
  DamageKick kick;
  kick.add({20, 60, {100, 0, 0}}, {0, 0, 0}, 0, 1);
  EXPECT_NEAR(kick.angles_deg(1, kKick_s).x, 24, 1e-3);
  EXPECT_NEAR(kick.angles_deg(1, kKick_s).z, 0, 1e-3);
  EXPECT_NEAR(kick.angles_deg(1.25, kKick_s).x, 12, 1e-3);
  EXPECT_EQ(kick.angles_deg(1.5, kKick_s), math::Vec3(0.0f));
  EXPECT_EQ(kick.angles_deg(9, kKick_s), math::Vec3(0.0f));
  EXPECT_EQ(kick.angles_deg(1, 0), math::Vec3(0.0f)) << "v_kicktime 0 turns it off";
  // From the right of a player who looks along +y: +x. Little damage counts as 10.
  kick.add({0, 1, {500, 10, 10}}, {0, 10, 10}, 90, 2);
  EXPECT_NEAR(kick.angles_deg(2, kKick_s).x, 0, 1e-3);
  EXPECT_NEAR(kick.angles_deg(2, kKick_s).z, 6, 1e-3);
  EXPECT_EQ(DamageKick().angles_deg(0, kKick_s), math::Vec3(0.0f));
  // From the player's own place.
  kick.add({0, 30, {1, 1, 1}}, {1, 1, 1}, 0, 3);
  EXPECT_EQ(kick.angles_deg(3, kKick_s), math::Vec3(0.0f));
}

TEST(ViewMotion, EasedValuesTakeTheTimeOfAStep) {
  EasedVector eased;
  eased.jump({0, 0, 0}, 0);
  eased.advance({10, 0, 0}, 0.05);
  EXPECT_EQ(eased.value(0.05).x, 0);
  EXPECT_NEAR(eased.value(0.075).x, 5, 1e-4);
  EXPECT_EQ(eased.value(0.1).x, 10);
  // After a long pause a step takes a tenth of a second.
  eased.advance({20, 0, 0}, 7);
  EXPECT_NEAR(eased.value(7.05).x, 15, 1e-4);
  // From the value it has reached.
  eased.advance({0, 0, 0}, 7.05);
  EXPECT_NEAR(eased.value(7.05).x, 15, 1e-4);
  EXPECT_NEAR(eased.value(7.075).x, 7.5, 1e-4);
  eased.advance({0, 0, 0}, 7.09);
  EXPECT_EQ(eased.value(7.1).x, 0);
}

}  // namespace
}  // namespace temblor::client
