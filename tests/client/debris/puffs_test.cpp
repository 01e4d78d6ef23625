#include "client/debris/puffs.h"

#include <gtest/gtest.h>

namespace temblor::client {
namespace {

TEST(Puffs, DriftRiseGrowAndFade) {
  Puffs puffs;
  puffs.add({.velocity = {100, 0, 0},
             .rise = 10,
             .born_s = 5,
             .life_s = 2,
             .first_scale = 1,
             .last_scale = 3,
             .opacity = 0.8f});
  puffs.advance(4.9);
  EXPECT_TRUE(puffs.puffs().empty()) << "not born yet";
  puffs.advance(5);
  ASSERT_EQ(puffs.puffs().size(), 1u);
  EXPECT_EQ(puffs.puffs()[0].alpha, 0.8f);
  EXPECT_EQ(puffs.puffs()[0].scale, 1);
  EXPECT_EQ(puffs.puffs()[0].age, 0);
  puffs.advance(6);
  const Puff middle = puffs.puffs()[0];
  EXPECT_NEAR(middle.alpha, 0.4, 0.001);
  EXPECT_NEAR(middle.origin_world.z, 10, 0.001);
  EXPECT_GT(middle.origin_world.x, 20);
  EXPECT_LT(middle.origin_world.x, 26) << "the air stops it after 25 units";
  EXPECT_GT(middle.scale, 2);
  puffs.advance(7);
  EXPECT_TRUE(puffs.puffs().empty());
}

TEST(Puffs, TheOneThatEndsFirstGivesWay) {
  Puffs puffs;
  for (std::size_t i = 0; i <= Puffs::kMaxPuffs; ++i)
    puffs.add({.born_s = 1, .life_s = i == 5 ? 1.0 : 10.0, .first_scale = static_cast<float>(i)});
  puffs.advance(1);
  EXPECT_EQ(puffs.puffs().size(), Puffs::kMaxPuffs);
  for (const Puff& puff : puffs.puffs()) EXPECT_NE(puff.scale, 5);
}

}  // namespace
}  // namespace temblor::client
