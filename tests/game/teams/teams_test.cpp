// Team deathmatch: damage and frags within a team, teams of bots, and the end of a match.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "game/open_ground.h"
#include "game/teams/team_rooms.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
namespace field = server::field;

class Teams : public ::testing::Test {
 protected:
  Teams() : data_(team_hall_text()) {}
  PlayedLevel begin(const std::string& teamplay) { return begin_team_game(data_, teamplay); }

  // Two players of one team, and one of another.
  PlayedLevel begin_with_three(const std::string& teamplay) {
    PlayedLevel game = begin(teamplay);
    for (std::uint32_t slot = 0; slot < 3; ++slot) {
      game.join(slot);
      game.player(slot).set(field::kTeam, slot < 2 ? kRed : kBlue);
    }
    game.run(0.5);
    return game;
  }

  static int count_bots(PlayedLevel& io_game, float team) {
    int count = 0;
    for (std::uint32_t slot = 0; slot < kTeamPlaces; ++slot)
      count += io_game.is_bot(slot) && io_game.player(slot)[field::kTeam] == team;
    return count;
  }

  RoomData data_;
};

// Damage is rounded up to whole points.
TEST_F(Teams, ProtectTeammatesUnlessFriendlyFireIsOn) {
  for (const auto& [teamplay, health] :
       {std::pair("0", 70), std::pair("1", 100), std::pair("2", 70), std::pair("3", 100)}) {
    PlayedLevel game = begin_with_three(teamplay);
    game.player(1).set(field::kTeam, game.player(0)[field::kTeam]);
    game.hurt(2, 1, 30);
    EXPECT_EQ(game.player(1)[field::kHealth], health) << teamplay;
    EXPECT_THAT(game.errors(), IsEmpty());
  }
}

TEST_F(Teams, CountATeamKillAgainstTheKiller) {
  PlayedLevel game = begin_with_three("2");
  game.hurt(2, 1, 200);
  game.tick();
  EXPECT_EQ(game.player(0)[field::kFrags], -1);
  EXPECT_THAT(game.said(), HasSubstr(" was killed by a teammate, "));
  game.hurt(3, 1, 200);
  EXPECT_EQ(game.player(0)[field::kFrags], 0);
}

TEST_F(Teams, BotsFillTheTeamOfAPersonAndAnother) {
  PlayedLevel game = begin("1");
  game.join(0);
  game.player(0).set(field::kTeam, 4);
  game.set("bot_fill", "8");
  game.run(15);
  EXPECT_EQ(count_bots(game, 4), 3);
  EXPECT_EQ(count_bots(game, kRed), 4);
  EXPECT_THAT(game.errors(), IsEmpty());
}

TEST_F(Teams, StayEvenWhenBotsLeave) {
  PlayedLevel game = begin("1");
  game.set("bot_fill", "8");
  game.run(15);
  EXPECT_EQ(count_bots(game, kRed), 4);
  EXPECT_EQ(count_bots(game, kBlue), 4);
  game.set("bot_fill", "4");
  game.run(10);
  EXPECT_EQ(count_bots(game, kRed), 2);
  EXPECT_EQ(count_bots(game, kBlue), 2);
}

TEST_F(Teams, OnlyEnemiesAreKilledByBots) {
  PlayedLevel game = begin("1");
  game.set("bot_fill", "6");
  game.run(90);
  EXPECT_THAT(game.said(), Not(HasSubstr("teammate")));
  float frags = 0;
  for (std::uint32_t slot = 0; slot < kTeamPlaces; ++slot) frags += game.player(slot)[field::kFrags];
  EXPECT_GT(frags, 3);
  EXPECT_THAT(game.errors(), IsEmpty());
}

TEST_F(Teams, WinTogether) {
  PlayedLevel game = begin_with_three("1");
  game.set("fraglimit", "10");
  game.player(0).set(field::kFrags, 4);
  game.player(1).set(field::kFrags, 5);
  game.player(2).set(field::kFrags, 8);
  game.run(0.5);
  EXPECT_EQ(game.global("intermission_running"), 0);
  game.player(1).set(field::kFrags, 6);
  game.run(0.5);
  EXPECT_EQ(game.global("intermission_running"), 1);
  EXPECT_THAT(game.said(), HasSubstr("Red"));
  EXPECT_THAT(game.said(), HasSubstr(" wins with "));
}

TEST_F(Teams, SplitAVictoryIfTheScoresAreEqual) {
  PlayedLevel game = begin_with_three("1");
  game.player(0).set(field::kFrags, 5);
  game.player(2).set(field::kFrags, 5);
  game.call_function("start_intermission", vm::kWorld);
  game.tick();
  EXPECT_THAT(game.said(), HasSubstr("The match is a draw"));
}

// The winning team stands in front of the camera, each in its colors; the others do not.
TEST_F(Teams, StandOnAPodiumInTheEnd) {
  PlayedLevel game = begin_with_three("1");
  game.player(2).set(field::kFrags, 8);
  game.player(1).set(field::kFrags, 9);
  game.call_function("start_intermission", vm::kWorld);
  game.run(1);
  const std::vector<std::uint32_t> figures = game.of_class("podium_figure");
  ASSERT_EQ(figures.size(), 2u);
  EXPECT_EQ(game.edict(figures[0])[field::kColorMap], 2);
  EXPECT_EQ(game.edict(figures[1])[field::kColorMap], 1);
  for (const std::uint32_t figure : figures) {
    const math::Vec3 at = game.edict(figure)[field::kOrigin];
    const math::Vec3 way = at - game.player(0)[field::kOrigin];
    EXPECT_NEAR(at.z, 24, 1);
    EXPECT_LT(glm::length(way), 200);
    const math::Vec3 facing = yaw_direction(game.player(0)[field::kAngles].y);
    EXPECT_GT(glm::dot(glm::normalize(way), facing), 0.8f);
  }
  EXPECT_EQ(game.player(0)[field::kOrigin], game.player(2)[field::kOrigin]);
  EXPECT_THAT(game.errors(), IsEmpty());
}

TEST_F(Teams, StartAtTheirOwnStarts) {
  PlayedLevel game = begin("3");
  for (std::uint32_t slot = 0; slot < 4; ++slot) game.join(slot);
  for (std::uint32_t slot = 0; slot < 4; ++slot)
    EXPECT_EQ(game.player(slot)[field::kOrigin].x < 800, game.player(slot)[field::kTeam] == kRed) << slot;
}

}  // namespace
}  // namespace temblor::test
