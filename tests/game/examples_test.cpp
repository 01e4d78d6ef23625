// The example mods do what their README says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "game/open_ground.h"
#include "support/game_data.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
namespace field = server::field;

std::filesystem::path program_path(std::string_view name) {
  return std::filesystem::path(TEMBLOR_GAMES) / name / "progs.dat";
}

// Puts the second player on open ground in front of the first; returns the direction to it.
float face_each_other(PlayedLevel& io_game) {
  io_game.join(0);
  io_game.join(1);
  io_game.run(1);
  const float yaw = take_a_stand(io_game);
  io_game.put(io_game.player(1), io_game.player(0)[field::kOrigin] + yaw_direction(yaw) * 200.0f);
  io_game.input(0).command.view_angles_deg = {0, yaw, 0};
  io_game.run(0.5);
  return yaw;
}

// The health of the second player after a rocket was fired 30 degrees past it.
float health_after_rocket(const std::filesystem::path& data, std::string_view program) {
  PlayedLevel game(data, "lqdm1", program_path(program),
                   {.kind = server::GameKind::kDeathmatch, .players = 2});
  const float yaw = face_each_other(game);
  const server::Edict shooter = game.player(0);
  shooter.set(field::kItems, 32 + 4096);
  shooter.set(field::kAmmoRockets, 1);
  shooter.set(field::kImpulse, 7);
  game.input(0).command.view_angles_deg = {0, yaw + 30, 0};
  game.run(0.1);
  game.input(0).buttons = kAttack;
  game.run(3);
  EXPECT_EQ(shooter[field::kAmmoRockets], 0);
  EXPECT_THAT(game.errors(), IsEmpty());
  return game.player(1)[field::kHealth];
}

TEST(Examples, HomingRocketsTurnTowardTheirTarget) {
  DATA_FOLDER_OR_SKIP(data);
  EXPECT_LT(health_after_rocket(data, "homing_rockets"), health_after_rocket(data, "id1"));
}

TEST(Examples, TheCraftFliesWhereItsPilotLooks) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "start", program_path("flying_craft"), {.players = 1});
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
  game.input(0).command.view_angles_deg = {-45, 90, 0};  // up, and along y
  game.run(0.5);
  EXPECT_GT(craft[field::kOrigin][2], from[2] + 30);
  // The pilot sits on it.
  EXPECT_LT(glm::length(pilot[field::kOrigin] - craft[field::kOrigin]), 40);
  game.input(0).buttons = kJump;
  game.run(0.1);
  game.input(0).buttons = 0;
  game.run(2);
  EXPECT_EQ(pilot.move_type(), server::MoveType::kWalk);
  EXPECT_TRUE(pilot.has_flag(server::flag::kOnGround));
  EXPECT_EQ(craft[field::kVelocity], math::Vec3(0.0f));
  EXPECT_THAT(game.errors(), IsEmpty());
}

TEST(Examples, AlertersStickAndScreech) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "lqdm1", program_path("alerter"),
                   {.kind = server::GameKind::kDeathmatch, .players = 2});
  const float yaw = face_each_other(game);
  game.player(0).set(field::kImpulse, 101);
  game.run(2);
  ASSERT_THAT(game.of_class("alerter"), SizeIs(1));
  EXPECT_THAT(game.said(), HasSubstr("Here I am!"));
  const server::Edict alerter = game.edict(game.of_class("alerter")[0]);
  game.put(game.player(1), game.player(0)[field::kOrigin] + yaw_direction(yaw) * 100.0f);
  game.run(0.2);
  EXPECT_LT(glm::length(alerter[field::kOrigin] - game.player(1)[field::kOrigin]), 40);
  game.run(22);
  EXPECT_THAT(game.of_class("alerter"), IsEmpty());  // its battery is empty
  EXPECT_THAT(game.errors(), IsEmpty());
}

}  // namespace
}  // namespace temblor::test
