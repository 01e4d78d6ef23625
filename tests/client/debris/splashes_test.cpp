// Splashes in the pool of a level built in code.
#include "client/debris/splashes.h"

#include <gtest/gtest.h>

#include "artgen/small_level.h"
#include "support/levels/drawable_level.h"

namespace temblor::client {
namespace {

const world::Level& pool_level() {
  static const auto small = test::small_level().level;
  return *small;
}

math::Bounds pool_bounds() {
  for (const artgen::SmallLevelBox& box : artgen::small_level_boxes())
    if (box.contents == static_cast<std::int32_t>(world::Contents::kWater)) return box.bounds;
  ADD_FAILURE() << "the level has no pool";
  return {};
}

TEST(Splashes, SurfacesAreFoundFromBothSides) {
  const math::Bounds pool = pool_bounds();
  const math::Vec3 middle = (pool.mins + pool.maxs) * 0.5f;
  const math::Vec3 above(middle.x + 3, middle.y, pool.maxs.z + 17);
  const std::optional<Crossing> in = find_crossing(pool_level(), above, middle);
  ASSERT_TRUE(in);
  EXPECT_TRUE(in->enters);
  EXPECT_EQ(in->liquid, world::Contents::kWater);
  EXPECT_NEAR(in->surface_world.z, pool.maxs.z, 1.0 / 16);
  const std::optional<Crossing> out = find_crossing(pool_level(), middle, above);
  ASSERT_TRUE(out);
  EXPECT_FALSE(out->enters);
  EXPECT_EQ(out->surface_world, in->surface_world);
  EXPECT_FALSE(find_crossing(pool_level(), above, above + math::Vec3(0, 0, 5)));
  EXPECT_FALSE(find_crossing(pool_level(), middle, middle + math::Vec3(0, 0, 1)));
  EXPECT_FALSE(find_crossing(pool_level(), middle, {10000, 0, 0})) << "the end is in a wall";
}

TEST(Splashes, DropsFallBackAndBubblesRiseToTheSurface) {
  ParticlePool pool;
  pool.set_capacity(1000);
  Puffs puffs;
  EffectRandom random(3);
  const BurstContext burst{pool, random, 1};
  const Crossing crossing{{0, 0, 100}, world::Contents::kWater, true};
  spawn_splash(burst, crossing, 1, puffs);
  spawn_bubbles(burst, crossing.surface_world, {0, 0, 60}, 10, puffs);
  std::size_t most_bubbles = 0, rings = 0;
  for (double time_s = 1; time_s < 5; time_s += 0.02) {
    pool.advance(time_s);
    puffs.advance(time_s);
    for (const float z : pool.cloud().z) EXPECT_GT(z, 99);
    std::size_t bubbles = 0;
    for (const Puff& puff : puffs.puffs()) {
      if (puff.picture == PuffPicture::kBubble) {
        ++bubbles;
        EXPECT_LT(puff.origin_world.z, 100.01);
      } else {
        ++rings;
        EXPECT_EQ(puff.picture, PuffPicture::kRing);
        EXPECT_NEAR(puff.origin_world.z, 100, 1);
      }
    }
    most_bubbles = std::max(most_bubbles, bubbles);
  }
  EXPECT_GE(most_bubbles, 6u);
  EXPECT_GT(rings, 0u);
  EXPECT_EQ(pool.size(), 0u);
  EXPECT_TRUE(puffs.puffs().empty());
}

TEST(Splashes, ASwimmerSplashesNowAndThen) {
  SplashTimes times;
  EXPECT_TRUE(times.begin(4, 1));
  EXPECT_FALSE(times.begin(4, 1 + SplashTimes::kPause_s / 2));
  EXPECT_TRUE(times.begin(5, 1 + SplashTimes::kPause_s / 2));
  EXPECT_TRUE(times.begin(4, 1 + SplashTimes::kPause_s));
}

}  // namespace
}  // namespace temblor::client
