// The shipped levels, played from their start to their exit on every skill. TEMBLOR_PLAYER_SEEDS: how many
// games of each (1).
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "game/player/run.h"

namespace temblor::test {
namespace {

using ::testing::IsEmpty;

struct Game {
  const char* map;
  int skill;
  std::uint32_t players;  // 0: alone
};

std::string name_of(const Game& game) {
  return fmt::format("{}Skill{}{}", game.map, game.skill,
                     game.players > 0 ? fmt::format("Of{}", game.players) : std::string());
}

std::uint64_t seeds() {
  const char* text = std::getenv("TEMBLOR_PLAYER_SEEDS");
  return text != nullptr ? std::strtoull(text, nullptr, 10) : 1;
}

player::RunSetup setup_of(const Game& game, std::uint64_t seed) {
  player::RunSetup setup;
  setup.session.base_folder = TEMBLOR_SHIPPED_FOLDER;
  setup.session.map = game.map;
  setup.session.skill = game.skill;
  setup.session.seed = seed;
  setup.session.players = std::max(game.players, 1u);
  setup.session.cooperative = game.players > 0;
  setup.session.can_cheat = setup.has_god = true;
  setup.limit_s = 900;
  return setup;
}

class ShippedLevels : public ::testing::TestWithParam<Game> {
 protected:
  void SetUp() override {
    const std::filesystem::path file =
        std::filesystem::path(TEMBLOR_SHIPPED_FOLDER) / "id1/maps" / fmt::format("{}.bsp", GetParam().map);
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " has not been built";
    // He does not manage the lift from the crystals among its hardest monsters, nor the mine in twos.
    if (std::string_view(GetParam().map) == "t3" && (GetParam().skill == 3 || GetParam().players > 0))
      GTEST_SKIP() << "issue 7: the scripted player does not get through t3 on skill 3 and in company yet";
  }
};

// Whether its ways, doors, keys and exit work; who wins the fights is another matter (README.md).
TEST_P(ShippedLevels, ArePlayedToTheirExit) {
  for (std::uint64_t seed = 1; seed <= seeds(); ++seed) {
    const player::RunReport report = player::play_level(setup_of(GetParam(), seed)).value();
    EXPECT_TRUE(report.reached_exit) << "seed " << seed << "\n" << player::as_text(report);
    EXPECT_THAT(report.stuck_monsters, IsEmpty()) << "seed " << seed;
    EXPECT_THAT(report.errors, IsEmpty()) << "seed " << seed;
  }
}

TEST_P(ShippedLevels, GiveUpAllTheirSecrets) {
  if (GetParam().players > 0 || GetParam().skill != 1) GTEST_SKIP() << "secrets are looked for once";
  player::RunSetup setup = setup_of(GetParam(), 1);
  setup.visits_secrets = true;
  const player::RunReport report = player::play_level(setup).value();
  EXPECT_EQ(report.found_secrets, report.secrets) << player::as_text(report);
}

std::vector<Game> games() {
  std::vector<Game> games;
  for (const char* map : {"start", "t1", "t2", "t3"})
    for (int skill = 0; skill < 4; ++skill) games.push_back({map, skill, 0});
  for (const char* map : {"t1", "t2", "t3"}) games.push_back({map, 1, 2});
  return games;
}

INSTANTIATE_TEST_SUITE_P(All, ShippedLevels, ::testing::ValuesIn(games()),
                         [](const auto& game) { return name_of(game.param); });

}  // namespace
}  // namespace temblor::test
