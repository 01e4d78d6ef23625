// func_hammer: its blows, the waves that they send over the floor, and its last fall.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "game/room_level.h"

namespace temblor::test {
namespace {

using ::testing::IsEmpty;
namespace field = server::field;

// A hammer in the middle of a hall, over a floor at 0, and in the east a stand of 40 units. Its waves begin
// 120 units from its middle, toward the east in its first blow.
class Hammers : public ::testing::Test {
 protected:
  void begin(const std::string& keys) {
    const std::string entities =
        entity_text("func_hammer",
                    "\"targetname\" \"last\"\n\"target\" \"lamp\"\n\"height\" \"100\"\n\"wait\" \"1\"\n"
                    "\"speed\" \"200\"\n\"lip\" \"120\"\n\"count\" \"300\"\n" +
                        keys,
                    box_text({-32, -32, 140}, {32, 32, 200}, "wall")) +
        entity_text("func_wall", "\"targetname\" \"lamp\"", box_text({0, 300, 0}, {10, 310, 10}, "wall")) +
        entity_text("func_wall", "", box_text({200, -300, 0}, {300, -200, 40}, "wall"));
    data_ = std::make_unique<RoomData>(hall_text({-400, -400, 0}, {400, 400, 256}, {}, entities));
    game_ = std::make_unique<PlayedLevel>(data_->path(), "room", kProgs);
    game_->join(0);
  }

  float health_after_blow(const math::Vec3& place) {
    game_->put(game_->player(0), place);
    game_->run(4);
    return game_->player(0)[field::kHealth];
  }
  float hammer_height() { return game_->edict(game_->of_class("func_hammer").at(0))[field::kOrigin].z; }

  std::unique_ptr<RoomData> data_;
  std::unique_ptr<PlayedLevel> game_;
};

TEST_F(Hammers, HurtPlayersInTheLanesOfTheirWaves) {
  begin("\"dmg\" \"36\"");
  const float health = health_after_blow({250, 0, 25});
  EXPECT_LT(health, 100);
  EXPECT_GT(health, 60) << "one wave hits once";
  EXPECT_THAT(game_->errors(), IsEmpty());
}

TEST_F(Hammers, SparePlayersOnAStand) {
  begin("\"dmg\" \"36\"");
  EXPECT_EQ(health_after_blow({250, -250, 65}), 100) << "the wave to the southeast climbs up to 24 units";
}

TEST_F(Hammers, SparePlayersBetweenTheLanes) {
  begin("\"dmg\" \"36\"");
  EXPECT_EQ(health_after_blow({250, -110, 25}), 100);
}

TEST_F(Hammers, OnlyMoveWithoutDamage) {
  begin("");
  EXPECT_EQ(health_after_blow({250, 0, 25}), 100);
  EXPECT_THAT(game_->of_class("tremor_wave"), IsEmpty());
}

TEST_F(Hammers, FallByTheirHeightAndRiseAgain) {
  begin("");
  float lowest = 0, highest = -1000;
  for (int i = 0; i < 60; ++i) {
    game_->run(0.1);
    lowest = std::min(lowest, hammer_height());
    if (lowest < -99) highest = std::max(highest, hammer_height());
  }
  EXPECT_FLOAT_EQ(lowest, -100);
  EXPECT_FLOAT_EQ(highest, 0);
}

TEST_F(Hammers, FallForGoodWhenUsed) {
  begin("\"dmg\" \"36\"");
  game_->use(game_->of_class("func_hammer").at(0), 1);
  game_->run(1);
  EXPECT_FLOAT_EQ(hammer_height(), -300);
  EXPECT_EQ(health_after_blow({250, 0, 25}), 100);
  EXPECT_FLOAT_EQ(hammer_height(), -300);
}

}  // namespace
}  // namespace temblor::test
