// The shipped levels, run for a while by the server's Game: all entities stand on a floor, and all names
// resolve.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "game/played_level.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::filesystem::path shipped_base() {
  const char* elsewhere = std::getenv("TEMBLOR_SHIPPED_BASE");
  return elsewhere != nullptr ? elsewhere : TEMBLOR_GAMES;
}

std::vector<std::string> shipped_levels() {
  std::vector<std::string> names;
  const std::filesystem::path folder = std::filesystem::path(TEMBLOR_GAMES) / "id1/maps";
  if (std::filesystem::is_directory(folder))
    for (const auto& file : std::filesystem::directory_iterator(folder))
      if (file.path().extension() == ".bsp" && !file.path().filename().string().starts_with("b_"))
        names.push_back(file.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

void run_a_while(const std::string& name, const PlayedSettings& settings) {
  SCOPED_TRACE(name + (settings.kind == server::GameKind::kSingle ? " alone, skill " : ", skill ") +
               std::to_string(settings.skill));
  PlayedLevel game(shipped_base(), name, kProgs, settings);
  for (std::uint32_t slot = 0; slot < settings.players; ++slot) game.join(slot);
  game.run(4);
  EXPECT_THAT(game.errors(), IsEmpty());
  EXPECT_THAT(game.notes(), IsEmpty());
  EXPECT_THAT(game.printed(), Not(HasSubstr("is stuck")));
  EXPECT_THAT(game.printed(), Not(HasSubstr("has no floor below it")));
  EXPECT_THAT(game.printed(), Not(HasSubstr("stands in the air")));
  EXPECT_THAT(game.printed(), Not(HasSubstr("no entity is named")));
}

TEST(ShippedLevels, AreSoundInEveryKindOfGame) {
  if (!std::filesystem::exists(shipped_base() / "id1/progs/player.mdl") || shipped_levels().empty())
    GTEST_SKIP() << "the shipped game is not completely built";
  for (const std::string& name : shipped_levels()) {
    for (int skill = 0; skill < 3; ++skill) run_a_while(name, {.skill = skill});
    run_a_while(name, {.kind = server::GameKind::kCooperative, .players = 4});
    run_a_while(name, {.kind = server::GameKind::kDeathmatch, .players = 8});
  }
}

// The menu lists every folder with a progs.dat or levels beside id1 as a mod.
TEST(ShippedLevels, LeaveNoOtherFoldersThanGames) {
  std::vector<std::string> games;
  for (const auto& entry : std::filesystem::directory_iterator(TEMBLOR_GAMES))
    if (std::filesystem::exists(entry.path() / "progs.dat") || std::filesystem::exists(entry.path() / "maps"))
      games.push_back(entry.path().filename().string());
  EXPECT_THAT(games, ::testing::UnorderedElementsAre("alerter", "flying_craft", "homing_rockets", "id1"))
      << "delete the other folders below " << TEMBLOR_GAMES;
}

}  // namespace
}  // namespace temblor::test
