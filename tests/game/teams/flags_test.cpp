// Capture the flag: the states of the flags, sides, and bots that play it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "game/teams/team_rooms.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
namespace field = server::field;

enum FlagState { kHome, kCarried, kDropped };
constexpr int kDimLight = 8, kBlueLight = 64;

class Flags : public ::testing::Test {
 protected:
  // Slot 0 is red, slot 1 is blue.
  Flags() : data_(team_hall_text()), game_(begin_team_game(data_, "3")) {
    game_.join(0);
    game_.join(1);
    game_.run(1);
    red_ = game_.of_class("item_flag_team1").at(0);
    blue_ = game_.of_class("item_flag_team2").at(0);
  }

  float state(std::uint32_t flag) { return game_.edict_number(flag, "flag_state"); }
  math::Vec3 place(std::uint32_t flag) { return game_.edict(flag)[field::kOrigin]; }
  void move_to(std::uint32_t slot, const math::Vec3& at) {
    game_.put(game_.player(slot), at);
    game_.run(0.2);
  }
  void kill(std::uint32_t slot, std::uint32_t by) { game_.hurt(slot + 1, by + 1, 400); }

  RoomData data_;
  PlayedLevel game_;
  std::uint32_t red_ = 0, blue_ = 0;
};

TEST_F(Flags, PlayersAreSplitIntoSides) {
  EXPECT_EQ(game_.player(0)[field::kTeam], kRed);
  EXPECT_EQ(game_.player(1)[field::kTeam], kBlue);
}

TEST_F(Flags, AreCaptured) {
  move_to(0, kRedBase);
  EXPECT_EQ(state(red_), kHome) << "nobody takes the own flag";
  move_to(0, kBlueBase);
  EXPECT_EQ(state(blue_), kCarried);
  EXPECT_THAT(game_.said(), HasSubstr(" took the "));
  move_to(0, {600, 300, 24});
  EXPECT_LT(glm::length(place(blue_) - game_.player(0)[field::kOrigin]), 40) << "it is on the carrier's back";
  EXPECT_EQ(game_.edict(blue_).whole(field::kEffects), kDimLight | kBlueLight);
  move_to(0, kRedBase);
  EXPECT_EQ(state(blue_), kHome);
  EXPECT_NEAR(place(blue_).x, kBlueBase.x, 1);
  EXPECT_EQ(game_.global("red_captures"), 1);
  EXPECT_EQ(game_.global("blue_captures"), 0);
  EXPECT_EQ(game_.player(0)[field::kFrags], 5);
  EXPECT_THAT(game_.said(), HasSubstr(" captured the "));
  EXPECT_THAT(game_.errors(), IsEmpty());
}

// The text that was stuffed into a client, without the messages' bytes 9 and 0.
std::string find_captures(std::string sent) {
  std::erase_if(sent, [](char c) { return c == '\t' || c == '\0'; });
  const std::size_t at = sent.rfind("//temblor captures 4 ");
  return at == std::string::npos ? "" : sent.substr(at);
}

TEST_F(Flags, SendTheCapturesToPlayers) {
  for (const std::uint32_t slot : {0u, 1u})
    EXPECT_THAT(find_captures(game_.sent_to(slot)),
                HasSubstr("//temblor captures 4 0\n//temblor captures 8 0\n"));
  move_to(0, kBlueBase);
  move_to(0, kRedBase);
  for (const std::uint32_t slot : {0u, 1u})
    EXPECT_THAT(find_captures(game_.sent_to(slot)),
                HasSubstr("//temblor captures 4 1\n//temblor captures 8 0\n"));
}

TEST_F(Flags, AreNotCapturedWhileTheOwnFlagIsAway) {
  move_to(0, kBlueBase);
  move_to(1, kRedBase);
  EXPECT_EQ(state(red_), kCarried);
  move_to(0, kRedBase);
  EXPECT_EQ(state(blue_), kCarried);
  EXPECT_EQ(game_.global("red_captures"), 0);
}

TEST_F(Flags, AreDroppedInDeathAndReturnedByATouch) {
  move_to(0, kBlueBase);
  move_to(0, {600, 300, 24});
  kill(0, 1);
  EXPECT_EQ(game_.player(1)[field::kFrags], 2) << "one more for a carrier";
  game_.run(2);
  EXPECT_EQ(state(blue_), kDropped);
  EXPECT_LT(glm::length(place(blue_) - math::Vec3(600, 300, 0)), 100);
  move_to(1, place(blue_) + math::Vec3(0, 0, 24));
  EXPECT_EQ(state(blue_), kHome);
  EXPECT_NEAR(place(blue_).x, kBlueBase.x, 1);
  EXPECT_EQ(game_.player(1)[field::kFrags], 3);
  EXPECT_THAT(game_.said(), HasSubstr(" returned the "));
}

TEST_F(Flags, ReturnByThemselves) {
  move_to(0, kBlueBase);
  move_to(0, {600, 300, 24});
  kill(0, 1);
  game_.run(39);
  EXPECT_EQ(state(blue_), kDropped);
  game_.run(2);
  EXPECT_EQ(state(blue_), kHome);
}

TEST_F(Flags, StayWhenTheirCarrierLeaves) {
  move_to(0, kBlueBase);
  move_to(0, {600, 300, 24});
  game_.call_function("ClientKill", vm::EntityIndex{1});
  game_.run(1);
  EXPECT_EQ(state(blue_), kDropped);
  EXPECT_NEAR(place(blue_).x, 600, 50);
}

TEST_F(Flags, RefuseColorsThatMakeTheSidesUneven) {
  game_.player(0).set(field::kTeam, 3);
  game_.run(0.2);
  EXPECT_EQ(game_.player(0)[field::kTeam], kRed);
  game_.player(0).set(field::kTeam, kBlue);
  game_.run(0.2);
  EXPECT_EQ(game_.player(0)[field::kTeam], kRed) << "blue would have two players, red none";
}

TEST_F(Flags, EndTheMatchAtTheCaptureLimit) {
  game_.set("capturelimit", "1");
  game_.run(0.2);
  EXPECT_EQ(game_.global("intermission_running"), 0);
  move_to(0, kBlueBase);
  move_to(0, kRedBase);
  EXPECT_EQ(game_.global("intermission_running"), 1);
  EXPECT_THAT(game_.said(), HasSubstr(" wins with "));
}

TEST(FlagGame, KnowsWhereBlueIsInTheStockPalette) {
  const RoomData data(team_hall_text(), HasTremor::kNo);
  PlayedLevel game = begin_team_game(data, "3");
  game.join(0);
  game.join(1);
  game.run(0.5);
  EXPECT_EQ(game.player(0)[field::kTeam], kRed);
  EXPECT_EQ(game.player(1)[field::kTeam], kStockBlue);
  EXPECT_THAT(game.errors(), IsEmpty());
}

TEST(FlagGame, UsesStockSoundsWithoutItsArt) {
  const RoomData data(team_hall_text());
  const auto hear_capture = [&] {
    PlayedLevel game = begin_team_game(data, "3");
    game.join(0);
    game.run(1);
    game.put(game.player(0), kBlueBase);
    game.run(0.5);
    EXPECT_THAT(game.said(), HasSubstr(" took the "));
    EXPECT_THAT(game.printed(), Not(HasSubstr("precache")));
    EXPECT_THAT(game.errors(), IsEmpty());
    return game.has_sound("flags/taken.wav");
  };
  EXPECT_TRUE(hear_capture());
  std::filesystem::remove(data.path() / "id1/progs/flag.mdl");
  EXPECT_FALSE(hear_capture());
}

TEST(FlagGame, NeedsItsVariable) {
  const RoomData data(team_hall_text());
  for (const char* teamplay : {"0", "1", "2"})
    EXPECT_THAT(begin_team_game(data, teamplay).of_class("item_flag_team1"), IsEmpty()) << teamplay;
}

TEST(FlagGame, IsPlayedByBots) {
  const RoomData data(team_hall_text());
  PlayedLevel game = begin_team_game(data, "3");
  game.set("bot_fill", "6");
  game.run(240);
  EXPECT_GE(game.global("red_captures"), 1);
  EXPECT_GE(game.global("blue_captures"), 1);
  EXPECT_THAT(game.said(), HasSubstr(" returned the "));
  EXPECT_THAT(game.errors(), IsEmpty());
}

}  // namespace
}  // namespace temblor::test
