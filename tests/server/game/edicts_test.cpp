#include "server/game/edicts.h"

#include <gtest/gtest.h>

#include <limits>

#include "server/test_world.h"

namespace temblor::server {
namespace {

using vm::EntityIndex;

class EdictsTest : public ::testing::Test {
 protected:
  TestWorld world_{hall_text(), 3};
  Edicts& edicts_ = world_.world.edicts;
};

TEST_F(EdictsTest, PlayersComeFirst) {
  EXPECT_EQ(edicts_.count(), 4u);
  EXPECT_EQ(edicts_.spawn(10).value(), EntityIndex{4});
  EXPECT_TRUE(edicts_.is_client(EntityIndex{3}));
  EXPECT_FALSE(edicts_.is_client(EntityIndex{4}));
  EXPECT_FALSE(edicts_.is_client(vm::kWorld));
}

TEST_F(EdictsTest, ANumberIsReusedAfterHalfASecond) {
  const EntityIndex first = edicts_.spawn(10).value(), second = edicts_.spawn(10).value();
  edicts_[first].set(field::kHealth, 50);
  edicts_.free(second, 10);
  edicts_.free(first, 10.2);
  EXPECT_EQ(edicts_.spawn(10.4).value(), EntityIndex{6});
  EXPECT_EQ(edicts_.spawn(10.6).value(), second);
  EXPECT_EQ(edicts_.spawn(10.8).value(), first);
  EXPECT_EQ(edicts_[first][field::kHealth], 0);
  EXPECT_EQ(edicts_.spawn(10.8).value(), EntityIndex{7});
}

TEST_F(EdictsTest, WhileALevelIsSetUpItIsReusedAtOnce) {
  const EntityIndex first = edicts_.spawn(1).value();
  edicts_.free(first, 1);
  EXPECT_EQ(edicts_.spawn(1).value(), first);
}

// Clients are sent a baseline once, and nothing replaces it for as long as the level lasts.
TEST_F(EdictsTest, AReusedNumberKeepsTheBaselineThatClientsHave) {
  const EntityIndex index = edicts_.spawn(1).value();
  edicts_.state(index).baseline.frame = 5;
  edicts_.free(index, 1);
  ASSERT_EQ(edicts_.spawn(1).value(), index);
  EXPECT_EQ(edicts_.state(index).baseline.frame, 5);
}

TEST_F(EdictsTest, AFreeEntityHasNoModelOrPlace) {
  const EntityIndex index = edicts_.spawn(10).value();
  const Edict edict = edicts_[index];
  edict.set(field::kOrigin, {1, 2, 3});
  edict.set(field::kSolid, 2);
  edict.set(field::kModelIndex, 3);
  edict.set(field::kNextThink, 99);
  edict.set(field::kHealth, 77);
  edicts_.free(index, 10);
  EXPECT_TRUE(edicts_.is_free(index));
  EXPECT_EQ(edict[field::kOrigin], math::Vec3(0.0f));
  EXPECT_EQ(edict.solid(), Solid::kNot);
  EXPECT_EQ(edict[field::kModelIndex], 0);
  EXPECT_LT(edict[field::kNextThink], 0);
  EXPECT_EQ(edict[field::kHealth], 77);  // QuakeC may still read it
}

TEST_F(EdictsTest, TheWorldAndPlayersStay) {
  edicts_.free(vm::kWorld, 10);
  edicts_.free(EntityIndex{2}, 10);
  EXPECT_FALSE(edicts_.is_free(vm::kWorld));
  EXPECT_FALSE(edicts_.is_free(EntityIndex{2}));
}

TEST_F(EdictsTest, AreLimited) {
  base::Result<EntityIndex> last = edicts_.spawn(10);
  while (last.ok()) last = edicts_.spawn(10);
  EXPECT_EQ(last.error().code, base::ErrorCode::kTooLarge);
  const std::uint32_t most = edicts_.count();
  edicts_.free(EntityIndex{100}, 10);
  edicts_.free(EntityIndex{100}, 10);
  EXPECT_EQ(edicts_.spawn(11).value(), EntityIndex{100});
  EXPECT_FALSE(edicts_.spawn(11).ok());
  EXPECT_EQ(edicts_.count(), most);
}

TEST_F(EdictsTest, SavedGamesSetTheirNumber) {
  const EntityIndex index = edicts_.spawn(10).value();
  edicts_.free(index, 10);
  ASSERT_TRUE(edicts_.set_count(20).ok());
  EXPECT_EQ(edicts_.count(), 20u);
  EXPECT_FALSE(edicts_.is_free(index));
  EXPECT_FALSE(edicts_.set_count(3).ok());
  EXPECT_FALSE(edicts_.set_count(4000000).ok());
  EXPECT_EQ(edicts_.spawn(11).value(), EntityIndex{20});
}

TEST_F(EdictsTest, NanAndOutOfRangeNumbersCountAsZero) {
  const Edict edict = edicts_[edicts_.spawn(10).value()];
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity(), 3e9f}) {
    edict.set(field::kFlags, bad);
    EXPECT_EQ(edict.flags(), 0);
    edict.set(field::kSolid, bad);
    EXPECT_EQ(edict.solid(), Solid::kNot);
  }
  EXPECT_EQ(edicts_.at(EntityIndex{0xfffffff0}).index(), vm::kWorld);
  EXPECT_EQ(edicts_.at(edict.index()).index(), edict.index());
}

}  // namespace
}  // namespace temblor::server
