// The small mods do what their README says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "game/played_level.h"
#include "support/game_data.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
namespace field = server::field;

std::filesystem::path program_of(std::string_view name) {
  return std::filesystem::path(TEMBLOR_GAMES) / name / "progs.dat";
}

// Two players of a deathmatch, 400 units apart along x on the same floor, the first with his back turned.
void face_off(PlayedLevel& io_game) {
  io_game.join(0);
  io_game.join(1);
  io_game.run(1);
}

TEST(Examples, RocketsThatHomeTurnAfterTheirPrey) {
  DATA_FOLDER_OR_SKIP(data);
  // Fired 25 degrees past somebody who stands there, common rockets miss and these do not.
  for (const bool homes : {false, true}) {
    PlayedLevel game(data, "start", program_of(homes ? "homing_rockets" : "quakec"),
                     {.deathmatch = 1, .players = 2});
    face_off(game);
    const math::Vec3 place(-1152, -672, 8.03125f);
    game.put(game.player(0), place);
    game.put(game.player(1), place + math::Vec3(0, 300, 0));
    const server::Edict shooter = game.player(0);
    shooter.set(field::kItems, 32 + 4096);
    shooter.set(field::kAmmoRockets, 1);
    shooter.set(field::kImpulse, 7);
    game.command(0).view_angles_deg = {0, 65, 0};
    game.run(0.1);
    shooter.set(field::kButton0, 1);
    for (int i = 0; i < 60; ++i) { game.run(0.05); for (auto r : game.of_class("rocket")) std::printf("%d: %g %g %g v %g %g\n", homes, game.edict(r)[field::kOrigin][0], game.edict(r)[field::kOrigin][1], game.edict(r)[field::kOrigin][2], game.edict(r)[field::kVelocity][0], game.edict(r)[field::kVelocity][1]); }
    std::printf("player 1 %g %g %g rockets %g\n", game.player(1)[field::kOrigin][0],game.player(1)[field::kOrigin][1],game.player(1)[field::kOrigin][2], shooter[field::kAmmoRockets]);
    if (homes)
      EXPECT_LE(game.player(1)[field::kHealth], 0);
    else
      EXPECT_GT(game.player(1)[field::kHealth], 40);
    EXPECT_THAT(game.errors(), IsEmpty());
  }
}

TEST(Examples, TheCraftFliesWhereItsPilotLooks) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "start", program_of("flying_craft"), {.players = 1});
  game.join(0);
  game.run(1);
  const server::Edict pilot = game.player(0);
  pilot.set(field::kImpulse, 100);
  game.run(0.5);
  ASSERT_THAT(game.of_class("vehicle_craft"), SizeIs(1));
  const server::Edict craft = game.edict(game.of_class("vehicle_craft")[0]);
  game.put(pilot, craft[field::kOrigin]);
  game.run(0.5);
  const math::Vec3 from = craft[field::kOrigin];
  game.command(0).view_angles_deg = {-45, 90, 0};  // up, and along y
  game.run(0.5);
  EXPECT_GT(craft[field::kOrigin][2], from[2] + 30);
  // He sits on it.
  EXPECT_LT(glm::length(pilot[field::kOrigin] - craft[field::kOrigin]), 40);
  pilot.set(field::kButton2, 1);
  game.run(0.1);
  pilot.set(field::kButton2, 0);
  game.run(2);
  EXPECT_EQ(pilot.move_type(), server::MoveType::kWalk);
  EXPECT_TRUE(pilot.has_flag(server::flag::kOnGround));
  EXPECT_EQ(craft[field::kVelocity], math::Vec3(0.0f));
  EXPECT_THAT(game.errors(), IsEmpty());
}

TEST(Examples, AlertersStickAndScreech) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "start", program_of("alerter"), {.deathmatch = 1, .players = 2});
  face_off(game);
  const math::Vec3 place(-1152, -672, 8.03125f);
  game.put(game.player(0), place);
  game.put(game.player(1), place + math::Vec3(0, 200, 0));
  game.command(0).view_angles_deg = {0, 90, 0};
  game.run(0.1);
  game.player(0).set(field::kImpulse, 101);
  game.run(2);
  ASSERT_THAT(game.of_class("alerter"), SizeIs(1));
  EXPECT_THAT(game.said(), HasSubstr("Here I am!"));
  const server::Edict alerter = game.edict(game.of_class("alerter")[0]);
  game.put(game.player(1), place + math::Vec3(0, 100, 0));
  game.run(0.2);
  EXPECT_LT(glm::length(alerter[field::kOrigin] - game.player(1)[field::kOrigin]), 40);
  game.run(22);
  EXPECT_THAT(game.of_class("alerter"), IsEmpty());  // its battery
  EXPECT_THAT(game.errors(), IsEmpty());
}

}  // namespace
}  // namespace temblor::test
