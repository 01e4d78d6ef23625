// The shipped levels, played from their start to their exit on every skill, alone and in pairs that cannot be
// hurt, and alone by a player who can. TEMBLOR_PLAYER_SEEDS is the number of games of the former (default 1).
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
  std::uint32_t players;  // 0: alone
};

std::string make_name(const Game& game) {
  return fmt::format("{}Skill{}{}", game.map, game.skill,
                     game.players > 0 ? fmt::format("Of{}", game.players) : std::string());
}

std::uint64_t seeds() {
  const char* text = std::getenv("TEMBLOR_PLAYER_SEEDS");
  return text != nullptr ? std::strtoull(text, nullptr, 10) : 1;
}

// All games of this process share it, because most of them need the same few graphs.
player::GraphCache& graphs() {
  static player::GraphCache graphs;
  return graphs;
}

player::RunSetup make_run_setup(const Game& game, std::uint64_t seed) {
  player::RunSetup setup;
  setup.graphs = &graphs();
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
  }
};

// Tests routes, doors, keys, and exits. The players cannot be hurt, so fights do not matter (README.md).
TEST_P(ShippedLevels, ArePlayedToTheirExit) {
  for (std::uint64_t seed = 1; seed <= seeds(); ++seed) {
    const player::RunReport report = player::play_level(make_run_setup(GetParam(), seed)).value();
    EXPECT_TRUE(report.reached_exit) << "seed " << seed << "\n" << player::as_text(report);
    EXPECT_THAT(report.deaths, IsEmpty())
        << "seed " << seed << ": players must not kill each other at the start";
    EXPECT_THAT(report.stuck_monsters, IsEmpty()) << "seed " << seed;
    EXPECT_THAT(report.errors, IsEmpty()) << "seed " << seed;
  }
}

TEST_P(ShippedLevels, HaveReachableSecrets) {
  if (GetParam().players > 0) GTEST_SKIP() << "one player is enough to find secrets";
  player::RunSetup setup = make_run_setup(GetParam(), 1);
  setup.visits_secrets = true;
  const player::RunReport report = player::play_level(setup).value();
  EXPECT_EQ(report.found_secrets, report.secrets) << player::as_text(report);
}

// Three games of a player who can be hurt. It fights worse than people do, so it need not win on the higher
// skills, but the levels must let it live as long as this.
TEST_P(ShippedLevels, ArePlayedByMortals) {
  if (GetParam().players > 0) GTEST_SKIP() << "one player is enough to see how dangerous a level is";
  constexpr std::size_t kMaxDeaths[] = {2, 6, 10, 12};  // by skill, of one game
  constexpr int kMustWin = 1;                           // on this skill and below
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    player::RunSetup setup = make_run_setup(GetParam(), seed);
    setup.has_god = setup.session.can_cheat = false;
    if (GetParam().skill > kMustWin) setup.limit_s = 600;
    const player::RunReport report = player::play_level(setup).value();
    SCOPED_TRACE(fmt::format("seed {}\n{}", seed, player::as_text(report)));
    EXPECT_LE(report.deaths.size(), kMaxDeaths[GetParam().skill]);
    EXPECT_TRUE(report.reached_exit || GetParam().skill > kMustWin);
    EXPECT_THAT(report.idle_monsters, IsEmpty());
    EXPECT_THAT(report.stuck_monsters, IsEmpty());
    EXPECT_THAT(report.errors, IsEmpty());
  }
}

std::vector<Game> games() {
  std::vector<Game> games;
  for (const char* map : {"start", "t1", "t2", "t3"})
    for (int skill = 0; skill < 4; ++skill) games.push_back({map, skill, 0});
  for (const char* map : {"t1", "t2", "t3"})
    for (int skill = 0; skill < 4; ++skill) games.push_back({map, skill, 2});
  return games;
}

INSTANTIATE_TEST_SUITE_P(All, ShippedLevels, ::testing::ValuesIn(games()),
                         [](const auto& game) { return make_name(game.param); });

bool is_built(const char* map) {
  return std::filesystem::exists(std::filesystem::path(TEMBLOR_SHIPPED_FOLDER) / "id1/maps" /
                                 fmt::format("{}.bsp", map));
}

TEST(ShippedStart, LeadsToEachLevel) {
  if (!is_built("start")) GTEST_SKIP() << "start has not been built";
  for (const char* map : {"t1", "t2", "t3", "gallery", "tdm1"}) {
    player::RunSetup setup = make_run_setup({"start", 1, 0}, 1);
    setup.exit_map = map;
    const player::RunReport report = player::play_level(setup).value();
    EXPECT_TRUE(report.reached_exit) << map << "\n" << player::as_text(report);
    EXPECT_EQ(report.exit, map);
  }
}

TEST(ShippedArenas, ArePlayedAgainstBots) {
  for (const char* map : {"tdm1", "tdm2"}) {
    if (!is_built(map)) GTEST_SKIP() << map << " has not been built";
    player::RunSetup setup = make_run_setup({map, 1, 0}, 2);
    setup.has_god = setup.session.can_cheat = false;
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
  player::RunSetup setup = make_run_setup({"gallery", 1, 0}, 1);
  setup.visits_stops = true;
  const player::RunReport report = player::play_level(setup).value();
  EXPECT_TRUE(report.reached_exit) << player::as_text(report);
  EXPECT_THAT(report.problems, IsEmpty());
  EXPECT_GT(report.kills, 0) << "the gratings of the last bay did not open";
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
  player::RunSetup setup = make_run_setup({"gallery", 1, 0}, 1);
  setup.records = true;
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
