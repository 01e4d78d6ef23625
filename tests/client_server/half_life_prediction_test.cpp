// Players in Half-Life's levels: prediction of crouching and of the water of brush entities, and the places
// where others see crouching players.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "client/prediction/predicted_player.h"
#include "client_server/predicted_game.h"
#include "client_server/served_game.h"
#include "compiler/drafts.h"
#include "formats/levels/bsp.h"
#include "support/levels/room_map.h"
#include "support/programs/quakec.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

using math::Vec3;
namespace field = server::field;

#define SKIP_WITHOUT_GAME() \
  if (!std::filesystem::exists(TEMBLOR_GAME_PROGRAM)) GTEST_SKIP() << "the game's QuakeC is not compiled"

// 200 ms from key to answer.
constexpr NetworkConditions kSlowNetwork{.delay_s = 0.1};
constexpr std::int16_t kAhead = 300, kDown = -200, kUp = 200;
constexpr std::uint8_t kJumpButton = 2;
constexpr net::Move kWalk{.forward = kAhead}, kCrouchedWalk{.forward = kAhead, .up = kDown};

// A hall along x with additional brushes and entities.
base::ByteVector hall_level(const std::string& brushes, const std::string& entities) {
  const std::string map =
      entity_text("worldspawn", "", walls_text({0, -128, 0}, {1024, 128, 256}, "wall") + brushes) +
      point_text("info_player_start", {64, 0, 36}) + entities;
  compiler::DraftResult result = compile_draft(map, {.half_life = true});
  CHECK(!result.leak, "the hall leaks");
  for (formats::BspMiptex& texture : result.draft.bsp.miptexes) texture.name.clear();
  return formats::write_bsp(result.draft.bsp, formats::BspVersion::k30).value();
}

class HalfLifeHall {
 public:
  explicit HalfLifeHall(const std::string& brushes, const std::string& entities = {}) {
    folder_.write("id1/maps/hall.bsp", hall_level(brushes, entities));
  }
  const std::filesystem::path& path() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
};

// Behind x = 512 only a crouching player has space.
std::string low_passage() {
  return box_text({512, -128, 40}, {1024, 128, 256}, "wall");
}

void expect_small_corrections(PredictedGame& io_game) {
  const client::PredictionReport& report = io_game.prediction().report();
  EXPECT_LT(report.largest_units, 0.1f);
  EXPECT_EQ(report.teleport_units, 0);
  EXPECT_LT(glm::distance(io_game.shown()->origin_world, Vec3(io_game.player()[field::kOrigin])), 0.05f);
}

TEST(HalfLifePrediction, PlayersCrouchAndStandUpWithoutCorrections) {
  SKIP_WITHOUT_GAME();
  const HalfLifeHall hall("");
  PredictedGame game(hall.path(), "hall", kSlowNetwork);
  ASSERT_TRUE(game.join());
  game.prediction().reset_report();
  for (int i = 0; i < 3; ++i) {
    game.run(0.4, kWalk);
    game.run(0.7, kCrouchedWalk);
  }
  const float pace = game.shown()->velocity.x;
  EXPECT_NEAR(pace, 100, 1);
  game.run(0.5);
  expect_small_corrections(game);
}

TEST(HalfLifePrediction, PaceAndEyesFallWithTheKey) {
  SKIP_WITHOUT_GAME();
  const HalfLifeHall hall("");
  PredictedGame game(hall.path(), "hall", kSlowNetwork);
  ASSERT_TRUE(game.join());
  game.run(0.8, kWalk);
  const float walking = game.shown()->velocity.x;
  EXPECT_EQ(game.shown()->crouching_eyes_z, 22);
  game.run(0.05, kCrouchedWalk);
  EXPECT_LT(*game.shown()->crouching_eyes_z, 20);
  EXPECT_LT(game.shown()->velocity.x, walking - 20);
  EXPECT_GT(game.player()[field::kVelocity].x, walking - 1) << "the server has not received the key yet";
  game.run(1, kCrouchedWalk);
  EXPECT_EQ(game.shown()->crouching_eyes_z, 6);
  game.run(1);
  EXPECT_EQ(game.shown()->crouching_eyes_z, 22);
}

TEST(HalfLifePrediction, CrouchingPlayersFitThroughPassagesAndStayLowInThem) {
  SKIP_WITHOUT_GAME();
  for (const bool is_entity : {false, true}) {
    const HalfLifeHall hall(is_entity ? std::string() : low_passage(),
                            is_entity ? entity_text("func_wall", "", low_passage()) : std::string());
    PredictedGame game(hall.path(), "hall", kSlowNetwork);
    ASSERT_TRUE(game.join());
    game.prediction().reset_report();
    game.run(3, kWalk);
    EXPECT_NEAR(game.shown()->origin_world.x, 512 - 16, 1) << "standing";
    game.run(2, kCrouchedWalk);
    EXPECT_GT(game.shown()->origin_world.x, 560);
    game.run(1.5, kWalk);  // it cannot stand up
    EXPECT_NEAR(game.shown()->velocity.x, 100, 1);
    game.run(6, {.forward = -kAhead});
    EXPECT_LT(game.shown()->origin_world.x, 400);
    game.run(0.5);
    expect_small_corrections(game);
  }
}

// A pool of a brush entity, 128 units deep.
TEST(HalfLifePrediction, PlayersSwimInWaterEntitiesWithoutCorrections) {
  SKIP_WITHOUT_GAME();
  const HalfLifeHall hall(
      "", entity_text("func_water", "\"skin\" \"-3\"", box_text({256, -128, 0}, {768, 128, 128}, "wall")));
  PredictedGame game(hall.path(), "hall", kSlowNetwork);
  ASSERT_TRUE(game.join());
  game.prediction().reset_report();
  game.run(2, kWalk);
  EXPECT_EQ(game.player()[field::kWaterLevel], 3);
  game.run(0.4, {.forward = kAhead, .up = kUp});
  game.run(0.6, {.forward = -kAhead, .up = kDown});
  game.run(1.5, {.buttons = kJumpButton});
  EXPECT_GT(game.shown()->origin_world.z, 100) << "swims up";
  game.run(4);  // it sinks to the floor
  expect_small_corrections(game);
}

// The water comes down from the ceiling when the player walks through the trigger, and fills the floor. While
// it moves, the client sees it later than the server.
TEST(HalfLifePrediction, PlayersSwimWhereWaterHasMoved) {
  SKIP_WITHOUT_GAME();
  const HalfLifeHall hall(
      "",
      entity_text("func_water", R"("targetname" "sea" "angles" "90 0 0" "speed" "200" "wait" "-1")",
                  box_text({256, -128, 128}, {768, 128, 256}, "wall")) +
          entity_text("trigger_once", R"("target" "sea")", box_text({112, -128, 0}, {128, 128, 64}, "wall")));
  PredictedGame game(hall.path(), "hall", kSlowNetwork);
  ASSERT_TRUE(game.join());
  game.put_player({400, 0, 24.03125f});
  game.run(0.2);
  EXPECT_EQ(game.player()[field::kWaterLevel], 0);
  game.put_player({64, 0, 24.03125f});
  game.run(2.5, kWalk);
  EXPECT_EQ(game.player()[field::kWaterLevel], 3);
  game.run(1);
  game.prediction().reset_report();
  game.run(1, {.buttons = kJumpButton});
  game.run(0.6, {.forward = -kAhead, .up = kDown});
  game.run(4);
  EXPECT_EQ(game.player()[field::kWaterLevel], 3);
  expect_small_corrections(game);
}

// Where a client sees a player.
float seen_z(ServedGame& io_served, std::size_t client, std::size_t player) {
  std::vector<client::EntityPlace> places;
  io_served.client(client).state().copy_latest_places(places);
  const auto place = std::ranges::find(places, player + 1, &client::EntityPlace::number);
  return place == places.end() ? NAN : place->origin_world.z;
}

TEST(HalfLifeSnapshots, OthersSeeACrouchingPlayerAsLowAsItsEyes) {
  SKIP_WITHOUT_QUAKEC();
  const base::ByteVector level = hall_level("", "");
  ServedGame served(small_program(), {.files = {{"id1/maps/hall.bsp", std::string(base::as_text(level))}}});
  served.command("map hall\n");
  for (const std::size_t player : {served.add_client("first"), served.add_client("second")})
    ASSERT_TRUE(served.run_until_playing(player)) << player;
  const auto expect_seen = [&](float drop) {
    for (const std::size_t viewer : {0u, 1u})
      for (const std::size_t player : {0u, 1u}) {
        const float z = Vec3(served.game().player(player)[field::kOrigin]).z;
        EXPECT_NEAR(seen_z(served, viewer, player), viewer == player ? z : z - drop, 0.2)
            << viewer << " sees " << player;
      }
  };
  served.run(1);
  expect_seen(0);
  served.run(1, {.up = kDown});
  expect_seen(16);
  // The dead lie, and need no help.
  served.game().player(1).set(field::kHealth, 0.0f);
  served.run(0.1, {.up = kDown});
  const float dead_z = Vec3(served.game().player(1)[field::kOrigin]).z;
  EXPECT_NEAR(seen_z(served, 0, 1), dead_z, 0.2);
}

}  // namespace
}  // namespace temblor::test
