// trigger_onlyregistered: the ways into the episodes of the registered game.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "game/room_level.h"

namespace temblor::test {
namespace {

using ::testing::IsEmpty;
namespace field = server::field;

class OnlyRegistered : public ::testing::Test {
 protected:
  OnlyRegistered()
      : data_(hall_text(
            {0, -128, 0}, {600, 128, 128}, {},
            entity_text("trigger_onlyregistered", "\"message\" \"Not here\"\n\"target\" \"witness\"",
                        box_text({300, -128, 0}, {320, 128, 128}, "wall")) +
                entity_text("func_wall", "\"targetname\" \"witness\"",
                            box_text({580, 100, 0}, {590, 110, 10}, "wall")))) {}

  // Plays the level; the player walks into the trigger.
  void walk_in() {
    game_ = std::make_unique<PlayedLevel>(data_.path(), "room", kProgs);
    game_->join(0);
    game_->run(0.5);
    game_->put(game_->player(0), {310, 0, 25});
    game_->run(0.5);
  }
  bool was_used() { return game_->edict(game_->of_class("func_wall").at(0))[field::kFrame] == 1; }

  RoomData data_;
  std::unique_ptr<PlayedLevel> game_;
};

TEST_F(OnlyRegistered, ShowsItsMessageWithoutTheRegisteredGame) {
  walk_in();
  EXPECT_EQ(game_->variable("registered"), 0);
  EXPECT_FALSE(was_used());
  EXPECT_THAT(game_->errors(), IsEmpty());
}

TEST_F(OnlyRegistered, FiresWithTheMarkOfTheRegisteredGame) {
  data_.folder().write("id1/gfx/pop.lmp", std::string(256, '\0'));
  walk_in();
  EXPECT_EQ(game_->variable("registered"), 1);
  EXPECT_TRUE(was_used());
  EXPECT_THAT(game_->errors(), IsEmpty());
}

}  // namespace
}  // namespace temblor::test
