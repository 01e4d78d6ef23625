// Casings in a level built in code.
#include "client/debris/casings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "artgen/small_level.h"
#include "support/levels/drawable_level.h"
#include "support/random.h"
#include "world/trace.h"
#include "world/visibility.h"

namespace temblor::client {
namespace {

const world::Level& casing_level() {
  static const auto small = test::small_level().level;
  return *small;
}

// The middle of the first box of open space, the hall.
math::Vec3 middle_of_hall() {
  const math::Bounds bounds = artgen::small_level_boxes().front().bounds;
  return (bounds.mins + bounds.maxs) * 0.5f;
}

CasingThrow thrown_up(std::uint64_t seed = 1) {
  return {CasingModel::kShell, middle_of_hall(), {60, 20, 150}, 10, seed};
}

TEST(Casings, FallBounceLieAndFade) {
  Casings casings;
  casings.throw_casing(casing_level(), thrown_up());
  casings.advance(10.1);
  ASSERT_EQ(casings.pieces().size(), 1u);
  // 0.1 s of free flight: 150 * 0.1 - 800 * 0.1^2 / 2 = 11 units up.
  EXPECT_NEAR(casings.pieces()[0].origin_world.z, middle_of_hall().z + 11, 0.01);
  casings.advance(15);
  const math::Vec3 rest = casings.pieces()[0].origin_world;
  const world::Trace below = world::trace_line(casing_level(), world::ModelIndex{0}, world::Hull::kPoint,
                                               rest, rest - math::Vec3(0, 0, 2));
  EXPECT_LT(below.fraction, 1) << "it lies on something";
  EXPECT_EQ(casings.pieces()[0].angles_deg.x, 0);
  EXPECT_EQ(casings.pieces()[0].alpha, 1);
  casings.advance(16);
  EXPECT_EQ(casings.pieces()[0].origin_world, rest);
  casings.advance(17.5);
  EXPECT_NEAR(casings.pieces()[0].alpha, 0.5, 0.001);
  casings.advance(18);
  EXPECT_TRUE(casings.pieces().empty());
}

TEST(Casings, StayOutsideOfWalls) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    test::Random random(seed);
    Casings casings;
    CasingThrow thrown = thrown_up(seed);
    thrown.velocity = random.in_cube(400);
    casings.throw_casing(casing_level(), thrown);
    for (double time_s = 10; time_s < 18; time_s += 0.05) {
      casings.advance(time_s);
      ASSERT_EQ(casings.pieces().size(), 1u);
      EXPECT_NE(world::point_contents(casing_level(), casings.pieces()[0].origin_world),
                world::Contents::kSolid)
          << "seed " << seed << " at " << time_s;
    }
  }
}

TEST(Casings, AreTheSameAtAnyFrameRate) {
  Casings slow, fast;
  for (Casings* casings : {&slow, &fast}) casings->throw_casing(casing_level(), thrown_up());
  for (double time_s = 10; time_s < 11; time_s += 0.001) fast.advance(time_s);
  fast.advance(11);
  slow.advance(11);
  EXPECT_EQ(fast.pieces()[0].origin_world, slow.pieces()[0].origin_world);
  EXPECT_EQ(fast.pieces()[0].angles_deg, slow.pieces()[0].angles_deg);
}

TEST(Casings, TheOldestGivesWay) {
  Casings casings;
  for (std::size_t i = 0; i < Casings::kMaxCasings + 3; ++i) {
    CasingThrow thrown = thrown_up(i);
    thrown.born_s = 10 + 0.01 * static_cast<double>(i);
    casings.throw_casing(casing_level(), thrown);
  }
  casings.advance(11);
  EXPECT_EQ(casings.pieces().size(), Casings::kMaxCasings);
  casings.advance(18.02);  // the first three would be gone now, and have been replaced
  EXPECT_EQ(casings.pieces().size(), Casings::kMaxCasings);
}

TEST(Casings, NoneStartsInAWall) {
  Casings casings;
  CasingThrow thrown = thrown_up();
  thrown.origin_world = {10000, 10000, 10000};
  casings.throw_casing(casing_level(), thrown);
  casings.advance(10);
  EXPECT_TRUE(casings.pieces().empty());
}

}  // namespace
}  // namespace temblor::client
