// The stock levels, visited by a player who goes to every entity, uses every third one, and shoots all the
// time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "game/played_level.h"
#include "support/effort.h"
#include "support/game_data.h"

namespace temblor::test {
namespace {

using ::testing::AnyOf;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
namespace field = server::field;

class Levels : public ::testing::TestWithParam<std::string> {};

void arm(server::Edict player) {
  player.set_flag(server::flag::kGodMode);
  player.set(field::kItems, 127 + 4096 + 131072 + 262144);  // all weapons, both keys
  for (const auto ammo : {field::kAmmoShells, field::kAmmoNails, field::kAmmoRockets, field::kAmmoCells})
    player.set(ammo, 100);
}

void visit(PlayedLevel& io_game, std::uint32_t number) {
  const server::Edict player = io_game.player(0), visited = io_game.edict(number);
  const math::Vec3 at = (visited[field::kAbsMin] + visited[field::kAbsMax]) * 0.5f;
  arm(player);
  player.set(field::kVelocity, math::Vec3(0.0f));
  player.set(field::kImpulse, static_cast<float>(1 + number % 8));
  io_game.input(0).buttons = kAttack;
  if (number % 3 == 0) io_game.use(number, 1);
  io_game.put(player, at);
  io_game.input(0).command.view_angles_deg[1] = static_cast<float>(number * 37 % 360);
  io_game.input(0).command.forward = 200;
  io_game.run(0.5);
}

void visit_everything(PlayedLevel& io_game) {
  const std::uint32_t count = io_game.edict_count();
  for (std::uint32_t number = 3; number < count && io_game.errors().empty(); ++number)
    // An exit would end the visit.
    if (!io_game.is_free(number) &&
        io_game.text(io_game.edict(number)[field::kClassName]) != "trigger_changelevel")
      visit(io_game, number);
}

TEST_P(Levels, RunWithoutErrorsWhileEverythingIsTouchedAndUsed) {
  DATA_FOLDER_OR_SKIP(data);
  for (const server::GameKind kind : {server::GameKind::kCooperative, server::GameKind::kDeathmatch}) {
    PlayedLevel game(data, GetParam(), kProgs, {.skill = 2, .kind = kind, .players = 2});
    game.join(0);
    game.join(1);
    game.run(1);
    visit_everything(game);
    game.run(5);
    EXPECT_THAT(game.errors(), IsEmpty());
    EXPECT_THAT(game.printed(), Not(HasSubstr("precache")));  // no sound lacks its precache
    EXPECT_THAT(game.unknown_classes(), IsEmpty());
    // Two unused keys: one is a client setting.
    EXPECT_THAT(game.notes(), Each(AnyOf(HasSubstr("wateralpha"), HasSubstr("credits_"))));
  }
}

// A player who cannot die visits all places in turn, for five minutes: the monsters there fight it and each
// other.
TEST_P(Levels, RunForFiveMinutesOfFighting) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, GetParam(), kProgs, {.skill = 3});
  game.join(0);
  game.run(1);
  const float monsters = game.global("total_monsters");
  const double end_s = effort(300, 20);
  for (std::uint32_t number = 3; game.time_s() < end_s && game.errors().empty();
       number = number + 1 < game.edict_count() ? number + 1 : 3)
    if (!game.is_free(number) && game.text(game.edict(number)[field::kClassName]) != "trigger_changelevel")
      visit(game, number);
  EXPECT_THAT(game.errors(), IsEmpty());
  EXPECT_THAT(game.printed(), Not(HasSubstr("precache")));
  // Three ogres of one level stand in solid until they are teleported.
  EXPECT_TRUE(GetParam() == "lq_e1m2" || game.printed().find("is stuck") == std::string::npos);
  EXPECT_TRUE(kQuick || monsters == 0 || game.global("killed_monsters") > 0);
}

TEST_P(Levels, AreTheSameTwice) {
  DATA_FOLDER_OR_SKIP(data);
  std::vector<std::uint64_t> ends;
  for (int i = 0; i < 2; ++i) {
    PlayedLevel game(data, GetParam(), kProgs, {.skill = 1});
    game.join(0);
    game.input(0).command.forward = 200;
    game.run(10);
    ends.push_back(game.state_hash());
  }
  EXPECT_EQ(ends[0], ends[1]);
}

INSTANTIATE_TEST_SUITE_P(All, Levels,
                         ::testing::Values("start", "start_e0", "lq_e0m1", "lq_e0m2", "lq_e0m3", "lq_e0m9",
                                           "lq_e1m2", "lq_end", "lqdm1", "lqdm3", "lqdm5", "lqdm11",
                                           "lqdm12"),
                         [](const auto& level) { return level.param; });

}  // namespace
}  // namespace temblor::test
