// The shipped levels, played from their start to their exit on every skill, alone and in pairs.
// TEMBLOR_PLAYER_SEEDS is the number of games of each (default: one of players who cannot be hurt, three of
// others).
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <span>

#include "client/demo/demo_session.h"
#include "scripted_player/session/run.h"

namespace temblor::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

struct Game {
  const char* map;
  int skill;
};

std::uint64_t seeds(std::uint64_t otherwise) {
  const char* text = std::getenv("TEMBLOR_PLAYER_SEEDS");
  return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}

// All games of this process share it, because most of them need the same few graphs.
player::GraphCache& graphs() {
  static player::GraphCache graphs;
  return graphs;
}

player::RunSetup make_mortal_setup(const Game& game, std::uint64_t seed) {
  player::RunSetup setup;
  setup.graphs = &graphs();
  setup.session.base_folder = TEMBLOR_SHIPPED_FOLDER;
  setup.session.map = game.map;
  setup.session.skill = game.skill;
  setup.session.seed = seed;
  setup.limit_s = 900;
  return setup;
}

player::RunSetup make_god_setup(const Game& game, std::uint64_t seed) {
  player::RunSetup setup = make_mortal_setup(game, seed);
  setup.session.can_cheat = setup.has_god = true;
  return setup;
}

// Checks that hold in any game.
void expect_working_monsters(const player::RunReport& report) {
  EXPECT_THAT(report.idle_monsters, IsEmpty());
  EXPECT_THAT(report.stuck_monsters, IsEmpty());
  EXPECT_THAT(report.errors, IsEmpty());
}

class ShippedLevels : public ::testing::TestWithParam<Game> {
 protected:
  void SetUp() override {
    const std::filesystem::path file =
        std::filesystem::path(TEMBLOR_SHIPPED_FOLDER) / "id1/maps" / fmt::format("{}.bsp", GetParam().map);
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " has not been built";
  }

  // Plays a game with each seed. Notes how many were won, and the deaths, in the test's report.
  struct Outcome {
    std::uint64_t games = 0, won = 0;
    std::size_t deaths = 0;
    std::string text;
  };
  Outcome play(const player::RunSetup& first) {
    Outcome outcome;
    for (player::RunSetup setup = first; setup.session.seed <= seeds(3); ++setup.session.seed) {
      const player::RunReport report = player::play_level(setup).value();
      const std::string text = fmt::format("seed {}\n{}", setup.session.seed, player::as_text(report));
      SCOPED_TRACE(text);
      expect_working_monsters(report);
      ++outcome.games;
      outcome.won += report.reached_exit;
      outcome.deaths += report.deaths.size();
      outcome.text += text;
    }
    ::testing::Test::RecordProperty("games_won", static_cast<int>(outcome.won));
    ::testing::Test::RecordProperty("deaths", static_cast<int>(outcome.deaths));
    return outcome;
  }
};

// Tests routes, doors, keys, secrets, and exits. The player cannot be hurt, so fights do not matter.
TEST_P(ShippedLevels, HaveReachableSecretsAndExits) {
  for (std::uint64_t seed = 1; seed <= seeds(1); ++seed) {
    player::RunSetup setup = make_god_setup(GetParam(), seed);
    setup.visits_secrets = true;
    const player::RunReport report = player::play_level(setup).value();
    SCOPED_TRACE(fmt::format("seed {}\n{}", seed, player::as_text(report)));
    EXPECT_TRUE(report.reached_exit);
    EXPECT_EQ(report.found_secrets, report.secrets);
    EXPECT_THAT(report.deaths, IsEmpty());
    expect_working_monsters(report);
  }
}

// Each death restarts the level, so a player alone need not win on the higher skills. It fights worse than
// people do, but the levels must let it live as long as this.
TEST_P(ShippedLevels, ArePlayedByMortals) {
  constexpr std::size_t kMaxDeaths[] = {1, 4, 7, 8};  // by skill, of one game
  constexpr int kMustWin = 1;                         // on this skill and below
  player::RunSetup setup = make_mortal_setup(GetParam(), 1);
  if (GetParam().skill > kMustWin) setup.limit_s = 480;
  const Outcome outcome = play(setup);
  EXPECT_LE(outcome.deaths, kMaxDeaths[GetParam().skill] * outcome.games) << outcome.text;
  if (GetParam().skill <= kMustWin) {
    EXPECT_EQ(outcome.won, outcome.games) << outcome.text;
  }
}

// A death in a pair does not restart the level, so pairs must win.
TEST_P(ShippedLevels, ArePlayedByPairs) {
  constexpr std::size_t kMaxDeaths = 4;  // of both players, in one game
  player::RunSetup setup = make_mortal_setup(GetParam(), 1);
  setup.session.players = 2;
  setup.session.cooperative = true;
  const Outcome outcome = play(setup);
  EXPECT_LE(outcome.deaths, kMaxDeaths * outcome.games) << outcome.text;
  EXPECT_EQ(outcome.won, outcome.games) << outcome.text;
}

// The maps of a skill follow each other, so that the process of a shard plays the same maps on all skills,
// and floods each once.
std::vector<Game> games() {
  std::vector<Game> games;
  for (int skill = 0; skill < 4; ++skill)
    for (const char* map : {"start", "t1", "t2", "t3", "t4", "t5"}) games.push_back({map, skill});
  return games;
}

INSTANTIATE_TEST_SUITE_P(All, ShippedLevels, ::testing::ValuesIn(games()), [](const auto& game) {
  return fmt::format("{}Skill{}", game.param.map, game.param.skill);
});

bool is_built(const char* map) {
  return std::filesystem::exists(std::filesystem::path(TEMBLOR_SHIPPED_FOLDER) / "id1/maps" /
                                 fmt::format("{}.bsp", map));
}

TEST(ShippedStart, LeadsToEachLevel) {
  if (!is_built("start")) GTEST_SKIP() << "start has not been built";
  for (const char* map : {"t1", "t2", "t3", "t4", "t5", "gallery", "tdm1"}) {
    player::RunSetup setup = make_god_setup({"start", 1}, 1);
    setup.exit_map = map;
    const player::RunReport report = player::play_level(setup).value();
    EXPECT_TRUE(report.reached_exit) << map << "\n" << player::as_text(report);
    EXPECT_EQ(report.exit, map);
  }
}

TEST(ShippedArenas, ArePlayedAgainstBots) {
  for (const char* map : {"tdm1", "tdm2", "tdm3", "tdm4"}) {
    if (!is_built(map)) GTEST_SKIP() << map << " has not been built";
    player::RunSetup setup = make_mortal_setup({map, 1}, 2);
    setup.session.bots = 7;
    setup.limit_s = 60;
    const player::RunReport report = player::play_level(setup).value();
    EXPECT_GE(report.frags, 1) << map;
    EXPECT_THAT(report.problems, IsEmpty()) << map;
    EXPECT_THAT(report.errors, IsEmpty()) << map;
  }
}

TEST(ShippedGallery, CanBeTouredBayByBay) {
  if (!is_built("gallery")) GTEST_SKIP() << "gallery has not been built";
  player::RunSetup setup = make_god_setup({"gallery", 1}, 1);
  setup.visits_stops = true;
  const player::RunReport report = player::play_level(setup).value();
  EXPECT_TRUE(report.reached_exit) << player::as_text(report);
  EXPECT_THAT(report.problems, IsEmpty());
  EXPECT_GT(report.kills, 0) << "the gratings of the last bay did not open";
}

// The monsters behind the gratings fight on every skill. A death begins the tour again.
TEST(ShippedGallery, IsTouredByMortals) {
  if (!is_built("gallery")) GTEST_SKIP() << "gallery has not been built";
  constexpr std::size_t kMaxDeaths[] = {1, 1, 2, 3};  // by skill, of one game
  for (int skill = 0; skill < 4; ++skill) {
    std::size_t deaths = 0;
    for (std::uint64_t seed = 1; seed <= seeds(3); ++seed) {
      player::RunSetup setup = make_mortal_setup({"gallery", skill}, seed);
      setup.visits_stops = true;
      setup.limit_s = 300;
      const player::RunReport report = player::play_level(setup).value();
      SCOPED_TRACE(fmt::format("skill {}, seed {}\n{}", skill, seed, player::as_text(report)));
      expect_working_monsters(report);
      deaths += report.deaths.size();
    }
    ::testing::Test::RecordProperty(fmt::format("deaths_on_skill_{}", skill), static_cast<int>(deaths));
    EXPECT_LE(deaths, kMaxDeaths[skill] * seeds(3)) << "skill " << skill;
  }
}

// The kinds of marks on the faces of some models.
std::set<render::MarkKind> list_kinds(const render::MarkSet& marks, std::span<const world::Model> models) {
  std::set<render::MarkKind> kinds;
  for (const world::Model& model : models)
    for (std::uint32_t i = 0; i < model.face_count; ++i)
      for (const render::Mark& mark :
           marks.marks_on_face(base::to_index<world::FaceIndex>(model.first_face + i)))
        kinds.insert(mark.kind);
  return kinds;
}

TEST(ShippedGallery, ShowsMarksFromTheStart) {
  if (!is_built("gallery")) GTEST_SKIP() << "gallery has not been built";
  player::RunSetup setup = make_god_setup({"gallery", 1}, 1);
  setup.session.records = true;
  setup.limit_s = 1;
  const player::RunReport report = player::play_level(setup).value();
  const assets::Library library(vfs::FileSystem::open(TEMBLOR_SHIPPED_FOLDER).value());
  client::Presentation presentation(library);
  auto session = client::DemoSession::open(report.demo, "gallery.dem", presentation).value();
  ASSERT_TRUE(session.seek(session.begin_s() + 0.5, {}).value());
  EXPECT_THAT(presentation.take_notes(), IsEmpty()) << "a picture may be missing";
  const std::span<const world::Model> models = presentation.scene().level->models;
  using enum render::MarkKind;
  EXPECT_THAT(list_kinds(*presentation.scene().marks, models.first(1)),
              ElementsAre(kBulletHole, kScorch, kSplatter, kPicture));
  EXPECT_THAT(list_kinds(*presentation.scene().marks, models.subspan(1)),
              ElementsAre(kBulletHole, kSplatter, kPicture))
      << "the board";
}

}  // namespace
}  // namespace temblor::test
