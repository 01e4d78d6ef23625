// trigger_onlyregistered: the ways into the episodes of the registered game.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

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

// The hall as e1m7, whose exit leads back to the level start.
class EpisodeEnd : public ::testing::Test {
 protected:
  EpisodeEnd()
      : data_(hall_text({0, -128, 0}, {600, 128, 128}, {},
                        entity_text("trigger_changelevel", "\"map\" \"start\"",
                                    box_text({300, -128, 0}, {320, 128, 128}, "wall")))) {}

  // Leaves the level, and presses a button until the next one is requested. Returns the messages that each
  // press led to: f for a finale, s for the order form.
  std::string leave(std::string_view map, server::GameKind kind = server::GameKind::kSingle) {
    const std::filesystem::path maps = data_.path() / "id1/maps";
    std::filesystem::copy_file(maps / "room.bsp", maps / (std::string(map) + ".bsp"));
    PlayedLevel game(data_.path(), map, kProgs, {.kind = kind});
    game.join(0);
    game.run(0.5);
    game.put(game.player(0), {310, 0, 25});
    game.run(1);
    std::string shown;
    for (int press = 0; press < 6 && !game.change_level(); ++press) {
      const std::size_t before = game.said().size();
      game.run(6);
      game.input(0).buttons = 1;
      game.run(0.2);
      game.input(0).buttons = 0;
      const std::string said = game.said().substr(before);
      if (said.starts_with("\x1f")) {
        shown += 'f';
        text_ = said.substr(1, said.find('\0') - 1);
      } else if (said.starts_with("\x21")) {
        shown += 's';
      }
    }
    EXPECT_EQ(game.change_level(), "start");
    EXPECT_THAT(game.errors(), IsEmpty());
    return shown;
  }

  RoomData data_;
  std::string text_;
};

TEST_F(EpisodeEnd, OffersTheRegisteredGameWithoutIt) {
  EXPECT_EQ(leave("e1m7"), "fs");
  EXPECT_THAT(text_, ::testing::HasSubstr("registered game"));
}

TEST_F(EpisodeEnd, ReturnsToTheHallInTheRegisteredGame) {
  data_.folder().write("id1/gfx/pop.lmp", std::string(256, '\0'));
  EXPECT_EQ(leave("e1m7"), "f");
  EXPECT_THAT(text_, ::testing::HasSubstr("hall"));
  EXPECT_EQ(leave("e4m7"), "f");
}

TEST_F(EpisodeEnd, OfOurGameHasNoOrderForm) {
  EXPECT_EQ(leave("t5"), "f");
  EXPECT_THAT(text_, ::testing::HasSubstr("Seismograph"));
}

TEST_F(EpisodeEnd, ShowsOnlyScoresElsewhere) {
  EXPECT_EQ(leave("e1m6"), "");
  EXPECT_EQ(leave("e1m7", server::GameKind::kDeathmatch), "");
}

}  // namespace
}  // namespace temblor::test
