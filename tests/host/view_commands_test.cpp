// fog, sky, setpos, entities, and edicts, typed in a running game.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "client/session/client_state.h"
#include "host/frame/host_parts.h"
#include "host/headless_host.h"
#include "host/session/session.h"
#include "platform/posix/udp_socket.h"
#include "server/game/entity_fields.h"
#include "server/server.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

class ViewCommands : public ::testing::Test {
 protected:
  void SetUp() override {
    SKIP_WITHOUT_QUAKEC();
    game_.emplace(std::vector<std::string>{"map small"});
    ASSERT_TRUE(game_->run_until_playing());
  }
  void type(std::string_view line) {
    game_->command(line);
    game_->run(0.3);
  }
  const client::Game& state() { return game_->session().connection()->state().game(); }

  std::optional<HeadlessHost> game_;
};

TEST_F(ViewCommands, FogTakesTheArgumentsOfOtherEngines) {
  type("fog 0.05 1 0.5 0.25");
  ASSERT_TRUE(state().fog);
  EXPECT_FLOAT_EQ(state().fog->density, 0.05f);
  EXPECT_EQ(state().fog->color, math::Vec3(1, 0.5f, 0.25f));
  type("fog 0.1");
  EXPECT_FLOAT_EQ(state().fog->density, 0.1f);
  EXPECT_NEAR(state().fog->color.g, 0.5f, 1e-3);
  type("fog 0 1 0");
  EXPECT_NEAR(state().fog->density, 0.1f, 1e-3);
  EXPECT_EQ(state().fog->color, math::Vec3(0, 1, 0));
  type("fog 0.2 1 1 1 5");
  EXPECT_EQ(state().fog->fade_s, 5);
  type("fog");
  EXPECT_TRUE(game_->has_printed("fog: density"));
  type("fog thick");
  EXPECT_TRUE(game_->has_printed("fog DENSITY, fog RED GREEN BLUE"));
  EXPECT_EQ(state().fog->fade_s, 5) << "a bad number changes nothing";
}

TEST_F(ViewCommands, FogIsThereWhileItIsNotDrawn) {
  type("r_fog 0; fog 0.25 1 0.5 0.25");
  type("fog");
  EXPECT_TRUE(game_->has_printed("fog: density 0.25, color 1 0.5 0.25"));
  type("fog 0 1 0");
  EXPECT_FLOAT_EQ(state().fog->density, 0.25f) << "a new color keeps the density";
}

TEST_F(ViewCommands, SkyChangesTheSkybox) {
  type("sky");
  EXPECT_TRUE(game_->has_printed("sky: the level's own texture"));
  type("sky night_");
  EXPECT_EQ(state().skybox, "night_");
  type("sky");
  EXPECT_TRUE(game_->has_printed("sky: \"night_\""));
  type("sky \"\"");
  EXPECT_EQ(state().skybox, "");
}

TEST_F(ViewCommands, SetposMovesAndTurnsThePlayer) {
  type("setpos 48 256 100 10 45 0");
  const server::Edict player = game_->session().server()->game->player(0);
  EXPECT_EQ(player[server::field::kOrigin], math::Vec3(48, 256, 100)) << "it does not fall";
  EXPECT_NEAR(player[server::field::kViewAngles].y, 45, 1);
  type("setpos");
  EXPECT_TRUE(game_->has_printed("setpos 48 256 100"));
  type("setpos 1 2 nowhere");
  EXPECT_TRUE(game_->has_printed("Usage: setpos X Y Z"));
  type("setpos 1 2 1e30");
  EXPECT_EQ(player[server::field::kOrigin], math::Vec3(48, 256, 100));
}

TEST_F(ViewCommands, ListsEntitiesOfClientAndServer) {
  type("entities");
  EXPECT_TRUE(game_->has_printed(" entit"));
  type("edicts worldspawn");
  EXPECT_TRUE(game_->has_printed("0 worldspawn"));
  EXPECT_TRUE(game_->has_printed("1 entity"));
  type("edicts orldsp");
  EXPECT_EQ(std::ranges::count(game_->lines(), "1 entity"), 2) << "a part of the class is enough";
  type("edictcount");
  EXPECT_TRUE(game_->has_printed("numbers in use"));
}

TEST_F(ViewCommands, PointfileShowsTheLineUntilTheLevelEnds) {
  const auto count = [&] { return game_->host().game.data->presentation.scene().particles.size(); };
  type("pointfile");
  EXPECT_TRUE(game_->has_printed("pointfile: there is no " +
                                 (game_->folder().path() / "id1/maps/small.pts").string()));
  EXPECT_EQ(count(), 0u);
  game_->folder().write("id1/maps/small.pts", "0 0 40\n160 0 40\n");
  type("pointfile");
  EXPECT_TRUE(game_->has_printed("small.pts: 2 points"));
  EXPECT_EQ(count(), 11u);
  game_->run(20);
  EXPECT_EQ(count(), 11u);
  type("restart");
  ASSERT_TRUE(game_->run_until_playing());
  EXPECT_EQ(count(), 0u);
}

TEST_F(ViewCommands, PointfileNamesTheDamagedLine) {
  game_->folder().write("id1/maps/small.pts", "0 0 40\n160 0\n");
  type("pointfile");
  EXPECT_TRUE(game_->has_printed("small.pts: line 2: \"160 0\" is not a point"));
  EXPECT_EQ(game_->host().game.data->presentation.scene().particles.size(), 0u);
}

TEST_F(ViewCommands, ShowbboxesDrawsTheBoxesOfEntities) {
  const auto count = [&] { return game_->host().game.data->presentation.scene().lines.size(); };
  EXPECT_EQ(count(), 0u);
  type("r_showbboxes 1");
  const std::size_t all = count();
  EXPECT_GT(all, 0u);
  // A cross for an entity without size.
  ASSERT_TRUE(game_->session().server()->game->world().edicts.spawn(10).ok());
  game_->run(0.1);
  EXPECT_EQ(count(), all + 3);
  type("r_showbboxes 0");
  EXPECT_EQ(count(), 0u);
  EXPECT_FALSE(game_->has_printed("r_showbboxes shows no boxes"));
}

TEST_F(ViewCommands, ShapesOfGameCodeAreDrawnWhileTheyLast) {
  const auto lines = [&] { return game_->host().game.data->presentation.scene().lines; };
  server::Game& game = *game_->session().server()->game;
  server::DebugShapes& shapes = game.context().debug_shapes;
  shapes.add(server::DebugLine{{0, 0, 40}, {160, 0, 40}, 79}, {game.time_s() + 0.5, true});
  shapes.add(server::DebugText{"L", {100, 0, 40}, 8}, {game.time_s() + 0.5, false});
  game_->run(0.1);
  ASSERT_EQ(lines().size(), 3u);
  EXPECT_EQ(lines()[0].to_world, math::Vec3(160, 0, 40));
  EXPECT_EQ(lines()[0].color, game_->host().game.data->look.palette[79]);
  EXPECT_TRUE(lines()[0].is_depth_tested);
  EXPECT_FALSE(lines()[1].is_depth_tested);
  game_->run(1);
  EXPECT_TRUE(lines().empty());
}

TEST_F(ViewCommands, ShowbboxesSaysOnceWhyThereAreNone) {
  type("record short");
  game_->run(3);
  type("stop; r_showbboxes 1; playdemo short");
  EXPECT_TRUE(game_->host().game.data->presentation.scene().lines.empty());
  const auto count = [&] {
    return std::ranges::count_if(game_->lines(), [](const std::string& line) {
      return line == "r_showbboxes shows no boxes: a demo does not contain them";
    });
  };
  EXPECT_EQ(count(), 1);
  type("r_showbboxes 0");
  type("r_showbboxes 1");
  EXPECT_EQ(count(), 2);
}

TEST_F(ViewCommands, ShowbboxesIsForGamesAlone) {
  game_->host().services.open_socket = [](std::uint16_t) {
    return platform::posix::open_udp_socket({.port = 0, .host = "127.0.0.1"});
  };
  type("maxplayers 2; map small; r_showbboxes 1");
  ASSERT_TRUE(game_->run_until_playing());
  game_->run(0.3);
  EXPECT_TRUE(game_->host().game.data->presentation.scene().lines.empty());
  EXPECT_TRUE(game_->has_printed("they show other players through walls"));
}

TEST(ViewCommandsWithoutGame, SayWhatIsMissing) {
  HeadlessHost game;
  for (const char* line : {"fog 1", "sky x", "bf", "pointfile", "entities"}) game.command(line);
  game.run(0.1);
  EXPECT_TRUE(game.has_printed("fog: start or join a game first"));
  EXPECT_TRUE(game.has_printed("pointfile: start or join a game first"));
  EXPECT_TRUE(game.has_printed("entities: start or join a game first"));
}

}  // namespace
}  // namespace temblor::test
