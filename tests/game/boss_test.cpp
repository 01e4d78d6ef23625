// monster_boss and event_lightning, which only the last level of an episode of id's game has.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "game/room_level.h"

namespace temblor::test {
namespace {

using ::testing::IsEmpty;
namespace field = server::field;

// A hall with the boss between two electrodes. A wall whose frame changes shows that the boss's targets
// fired.
class Boss : public ::testing::Test {
 protected:
  void begin(int skill) {
    const auto electrode = [](double y) {
      return entity_text(
          "func_door",
          "\"target\" \"lightning\"\n\"targetname\" \"electrode\"\n\"angle\" \"-2\"\n\"wait\" \"-1\"\n"
          "\"speed\" \"400\"\n\"spawnflags\" \"4\"",
          box_text({560, y, 500}, {592, y + 32, 600}, "wall"));
    };
    const std::string entities =
        entity_text("monster_boss",
                    "\"origin\" \"576 0 24\"\n\"targetname\" \"boss\"\n\"target\" \"witness\"") +
        electrode(-300) + electrode(268) +
        entity_text("event_lightning", "\"origin\" \"576 300 300\"\n\"targetname\" \"switch\"") +
        entity_text("func_wall", "\"targetname\" \"witness\"",
                    box_text({1100, 100, 0}, {1110, 110, 10}, "wall"));
    data_ = std::make_unique<RoomData>(hall_text({0, -400, 0}, {1200, 400, 640}, {}, entities));
    game_ = std::make_unique<PlayedLevel>(data_->path(), "room", kProgs, PlayedSettings{.skill = skill});
    game_->join(0);
    game_->put(game_->player(0), {100, 0, 25});
    game_->player(0).set_flag(server::flag::kGodMode);
    game_->run(0.5);
    boss_ = game_->of_class("monster_boss").at(0);
  }
  void use_all(std::string_view name) {
    for (const std::uint32_t number : game_->of_class(name)) game_->use(number, 1);
  }
  void open_electrodes() {
    use_all("func_door");
    game_->run(2);
  }
  float health() { return game_->edict(boss_)[field::kHealth]; }

  std::unique_ptr<RoomData> data_;
  std::unique_ptr<PlayedLevel> game_;
  std::uint32_t boss_ = 0;
};

TEST_F(Boss, RisesWhenCalledAndThrowsAtThePlayer) {
  begin(1);
  EXPECT_EQ(game_->edict(boss_)[field::kModelIndex], 0) << "waits unseen";
  game_->use(boss_, 1);
  game_->run(0.5);
  EXPECT_GT(game_->edict(boss_)[field::kModelIndex], 0);
  bool threw = false;
  for (int i = 0; i < 60 && !threw; ++i) {
    game_->run(0.1);
    threw = !game_->of_class("lava_ball").empty();
  }
  EXPECT_TRUE(threw);
  EXPECT_THAT(game_->errors(), IsEmpty());
}

TEST_F(Boss, DiesOfThreeBoltsBetweenOpenElectrodes) {
  begin(1);
  game_->use(boss_, 1);
  game_->run(2);
  EXPECT_EQ(health(), 3);
  use_all("event_lightning");
  game_->run(4);
  EXPECT_EQ(health(), 3) << "the electrodes are closed";
  for (const int left : {2, 1, 0}) {
    open_electrodes();
    use_all("event_lightning");
    game_->run(0.3);
    EXPECT_EQ(health(), left);
    use_all("event_lightning");
    game_->run(0.3);
    EXPECT_EQ(health(), left) << "the bolt is still there";
    game_->run(2);  // the electrodes close
  }
  game_->run(3);
  EXPECT_THAT(game_->of_class("monster_boss"), IsEmpty());
  EXPECT_EQ(game_->global("killed_monsters"), game_->global("total_monsters"));
  EXPECT_EQ(game_->edict(game_->of_class("func_wall").at(0))[field::kFrame], 1) << "its targets fired";
  EXPECT_THAT(game_->errors(), IsEmpty());
}

TEST_F(Boss, DiesOfOneBoltOnEasy) {
  begin(0);
  game_->use(boss_, 1);
  game_->run(2);
  open_electrodes();
  use_all("event_lightning");
  game_->run(5);
  EXPECT_THAT(game_->of_class("monster_boss"), IsEmpty());
  EXPECT_THAT(game_->errors(), IsEmpty());
}

}  // namespace
}  // namespace temblor::test
