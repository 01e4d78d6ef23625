// Cases computed by hand. Times are sums of powers of two, so that they are exact.
#include "client/session/interpolation.h"

#include <gtest/gtest.h>

#include "support/random.h"

namespace temblor::test {
namespace {

using client::FrameBlend;
using client::FrameChanges;
using client::Motion;
using client::Place;

TEST(PacketWindow, IsTheGapLimitedToATenthOfASecond) {
  EXPECT_EQ(client::make_packet_window(2, 2.0625).begin_s, 2);
  EXPECT_EQ(client::make_packet_window(2, 2.0625).end_s, 2.0625);
  EXPECT_EQ(client::make_packet_window(2, 9).begin_s, 9 - 0.1);
  EXPECT_EQ(client::make_packet_window(2, 2).begin_s, 2);
}

TEST(ElapsedFraction, IsClamped) {
  EXPECT_EQ(client::compute_elapsed_fraction(2, 4, 1), 0);
  EXPECT_EQ(client::compute_elapsed_fraction(2, 4, 2.5), 0.25);
  EXPECT_EQ(client::compute_elapsed_fraction(2, 4, 5), 1);
  EXPECT_EQ(client::compute_elapsed_fraction(2, 2, 1), 1) << "an empty interval";
  EXPECT_EQ(client::compute_elapsed_fraction(4, 2, 1), 1) << "a reversed interval";
}

TEST(BlendAngles, TakesTheShortWay) {
  const auto yaw = [](float from, float to, double fraction) {
    return client::blend_angles_deg({0, from, 0}, {0, to, 0}, fraction).y;
  };
  EXPECT_EQ(yaw(10, 30, 0.5), 20);
  EXPECT_EQ(yaw(350, 10, 0.25), 355);
  EXPECT_EQ(yaw(10, 350, 0.25), 5);
  EXPECT_EQ(yaw(-170, 170, 0.5), -180);
  EXPECT_EQ(yaw(0, 725, 0.5), 2.5f);
  EXPECT_EQ(yaw(0, 725, 1), 725) << "exact at the end";
}

// At any distance: never more than half a turn, and whole turns make no difference.
TEST(BlendAngles, NeverTurnsMoreThanHalfATurn) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    Random random(seed);
    const math::Vec3 from = random.in_cube(720), to = random.in_cube(720);
    const double fraction = random.uniform(0, 1);
    const math::Vec3 between = client::blend_angles_deg(from, to, fraction);
    for (int axis = 0; axis < 3; ++axis) {
      const double turned = static_cast<double>(between[axis]) - static_cast<double>(from[axis]);
      EXPECT_LE(std::abs(turned), 180 * fraction + 1e-3) << seed;
      const double left = (static_cast<double>(to[axis]) - static_cast<double>(between[axis])) / 360;
      EXPECT_LE(std::abs(left - std::round(left)) * 360, 180 * (1 - fraction) + 1e-3) << seed;
    }
  }
}

TEST(Motion, FliesDuringThePacketsWindow) {
  Motion motion;
  motion.put({{10, 20, 30}, {0, 350, 0}});
  motion.fly_to({{20, 20, 26}, {0, 10, 0}}, {.begin_s = 4, .end_s = 4.0625});
  EXPECT_EQ(motion.at(3), (Place{{10, 20, 30}, {0, 350, 0}}));
  EXPECT_EQ(motion.at(4.015625), (Place{{12.5f, 20, 29}, {0, 355, 0}}));
  EXPECT_EQ(motion.at(4.0625), (Place{{20, 20, 26}, {0, 10, 0}}));
  EXPECT_EQ(motion.at(9), (Place{{20, 20, 26}, {0, 10, 0}}));
}

// Packets 1/64 s apart; one in four contains a step.
TEST(Motion, StepsTakeTheTimeBetweenThem) {
  Motion motion;
  motion.put({});
  motion.step_to({{8, 0, 0}, {}}, {.begin_s = 1, .end_s = 1.015625}, {});
  EXPECT_FLOAT_EQ(motion.at(1.05).origin_world.x, 4) << "the first step takes 0.1 s";
  EXPECT_EQ(motion.at(1.2).origin_world.x, 8);

  motion.step_to({{16, 0, 0}, {}}, {.begin_s = 1.0625, .end_s = 1.078125}, {});
  const float reached = motion.at(1.0625).origin_world.x;
  EXPECT_FLOAT_EQ(reached, 8 * 0.625f) << "from where the first step was interrupted";
  EXPECT_FLOAT_EQ(motion.at(1.0625 + 0.03125).origin_world.x, (reached + 16) / 2)
      << "a sixteenth of a second";
  const Place between = motion.at(1.1);
  motion.step_to({{16, 0, 0}, {}}, {.begin_s = 1.078125, .end_s = 1.09375}, {});
  EXPECT_EQ(motion.at(1.1), between) << "a packet without a step changes nothing";

  motion.step_to({{24, 0, 0}, {}}, {.begin_s = 3, .end_s = 3.015625}, 0.5f);
  EXPECT_EQ(motion.at(3.25).origin_world.x, 20) << "the duration that the server sent";
}

TEST(Teleport, IsMoreThan100UnitsAlongAnAxis) {
  EXPECT_FALSE(client::is_teleport({0, 0, 0}, {100, -100, 100}));
  EXPECT_TRUE(client::is_teleport({0, 0, 0}, {0, 0, -100.5f}));
  EXPECT_TRUE(client::is_teleport({-60, 0, 0}, {60, 0, 0}));
}

TEST(FrameChanges, AreBlended) {
  FrameChanges frames;
  frames.show(3);
  EXPECT_EQ(frames.at(1), (FrameBlend{3, 3, 0}));
  frames.update(4, 2, 0.5);
  EXPECT_EQ(frames.at(1), (FrameBlend{3, 4, 0}));
  EXPECT_EQ(frames.at(2.125), (FrameBlend{3, 4, 0.25f}));
  frames.update(4, 2.25, 0.5);
  EXPECT_EQ(frames.at(2.25), (FrameBlend{3, 4, 0.5f})) << "the same frame again changes nothing";
  EXPECT_EQ(frames.at(2.5), (FrameBlend{4, 4, 0}));
  frames.update(5, 3, 0.5);
  frames.update(6, 3.25, 0.5);
  EXPECT_EQ(frames.at(3.375), (FrameBlend{5, 6, 0.25f}));
}

TEST(FrameChanges, MuzzleFlashesAppearAndVanishAtOnce) {
  FrameChanges frames;
  frames.show(3);
  frames.update(4, 2, 0.5);
  frames.flash();
  EXPECT_EQ(frames.at(2.125), (FrameBlend{4, 4, 0}));
  frames.update(4, 2.25, 0.5);
  frames.update(5, 2.5, 0.5);
  EXPECT_EQ(frames.at(2.625), (FrameBlend{5, 5, 0}));
  frames.update(6, 3, 0.5);
  EXPECT_EQ(frames.at(3.125), (FrameBlend{5, 6, 0.25f})) << "blended again afterward";
}

}  // namespace
}  // namespace temblor::test
