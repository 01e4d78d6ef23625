// Arrivals in the shipped levels: a player who does nothing is hurt by nobody, because nobody sees the start.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "game/played_level.h"

namespace temblor::test {
namespace {

namespace field = server::field;

// Classes and places of the monsters that hunt a player.
std::string list_hunters(PlayedLevel& game) {
  std::string hunters;
  for (std::uint32_t number = 1; number < game.edict_count(); ++number) {
    if (game.is_free(number)) continue;
    const server::Edict edict = game.edict(number);
    const math::Vec3 at = edict[field::kOrigin];
    if (edict.has_flag(server::flag::kMonster) && edict[field::kEnemy] != vm::kWorld)
      hunters +=
          fmt::format("{} at {:.0f} {:.0f} {:.0f}\n", game.text(edict[field::kClassName]), at.x, at.y, at.z);
  }
  return hunters;
}

void expect_unhurt(PlayedLevel& game, std::uint32_t players, double after_s) {
  for (std::uint32_t slot = 0; slot < players; ++slot)
    EXPECT_EQ(game.player(slot)[field::kHealth], 100) << "player " << slot << " after " << after_s << " s";
}

void arrive(const char* map, const PlayedSettings& settings) {
  SCOPED_TRACE(fmt::format("{}, skill {}, {} player{}", map, settings.skill, settings.players,
                           settings.players == 1 ? "" : "s"));
  PlayedLevel game(TEMBLOR_GAMES, map, kProgs, settings);
  for (std::uint32_t slot = 0; slot < settings.players; ++slot) game.join(slot);
  game.run(5);
  expect_unhurt(game, settings.players, 5);
  game.run(25);
  expect_unhurt(game, settings.players, 30);
  EXPECT_EQ(list_hunters(game), "");
  EXPECT_THAT(game.errors(), ::testing::IsEmpty());
}

TEST(ShippedArrivals, AreInCover) {
  for (const char* map : {"start", "t1", "t2", "t3", "t4", "t5", "gallery"}) {
    if (!std::filesystem::exists(std::filesystem::path(TEMBLOR_GAMES) / "id1/maps" /
                                 fmt::format("{}.bsp", map)))
      GTEST_SKIP() << "the shipped game is not completely built";
    for (int skill = 0; skill < 4; ++skill) {
      arrive(map, {.skill = skill});
      arrive(map, {.skill = skill, .kind = server::GameKind::kCooperative, .players = 4});
    }
  }
}

}  // namespace
}  // namespace temblor::test
