// Players in a hall: jumps, stops, stairs and water, compared with the formulas.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "server/test_world.h"

namespace temblor::server {
namespace {

using math::Vec3;
using vm::EntityIndex;

constexpr double kPlayerTick = 1.0 / 72;
constexpr float kPlayerStanding = 24 + kGap;
const PlayerCommand kNothing{};
const PlayerCommand kForward{.forward = 400};

TEST(Player, JumpsAsHighAsTheFormulaSays) {
  TestWorld world(hall_text());
  const Edict player = world.player({0, 0, kPlayerStanding});
  world.command_and_tick(kNothing, 2);
  ASSERT_TRUE(player.has_flag(flag::kOnGround));
  Vec3 velocity = player[field::kVelocity];
  velocity.z += 270;
  player.set(field::kVelocity, velocity);
  float highest = 0;
  int ticks = 0;
  do {
    world.command_and_tick(kNothing);
    highest = std::max(highest, player[field::kOrigin].z);
    ++ticks;
  } while (!player.has_flag(flag::kOnGround) && ticks < 200);
  // v v / 2 g, minus what gravity takes away in half a tick of rising.
  EXPECT_NEAR(highest - kPlayerStanding, 270.0 * 270 / 1600 - 270 * kPlayerTick / 2, 0.1);
  EXPECT_NEAR(ticks * kPlayerTick, 2 * 270.0 / 800, 2 * kPlayerTick);
}

TEST(Player, RunsAtFullSpeedAndStopsWithinTheFormulasDistance) {
  TestWorld world(hall_text());
  const Edict player = world.player({-400, 0, kPlayerStanding});
  world.command_and_tick(kForward, 72);
  EXPECT_NEAR(player[field::kVelocity].x, 320, 0.1);
  const float from = player[field::kOrigin].x;
  world.command_and_tick(kNothing, 72);
  EXPECT_EQ(player[field::kVelocity].x, 0);
  const double distance = player[field::kOrigin].x - from;
  EXPECT_LT(distance, (320.0 - 100) / 4 + 100.0 * 100 / 800);
  EXPECT_GT(distance, (320.0 - 100) / 4 + 100.0 * 100 / 800 - 320 * kPlayerTick);
}

TEST(Player, StopsInAShorterDistanceAtAnEdge) {
  double ways[2];
  for (const bool has_edge : {false, true}) {
    TestWorld world(hall_text(test::box_text({-512, -512, 0}, {has_edge ? 0.0 : 512.0, 512, 100}, "wall")));
    const Edict player = world.player({-200, 0, 100 + kPlayerStanding});
    world.command_and_tick(kNothing, 2);
    player.set(field::kOrigin, {-30, 0, 100 + kPlayerStanding});
    player.set(field::kVelocity, {320, 0, 0});
    world.command_and_tick(kNothing, 72);
    ways[has_edge ? 1 : 0] = player[field::kOrigin].x + 30;
    EXPECT_NEAR(player[field::kOrigin].z, 100 + kPlayerStanding, 0.1);
  }
  EXPECT_LT(ways[1], 0.8 * ways[0]);
}

class PlayerSteps : public ::testing::TestWithParam<int> {};
TEST_P(PlayerSteps, AreClimbedUpToEighteenUnits) {
  TestWorld world(
      hall_text(test::box_text({0, -512, 0}, {512, 512, static_cast<double>(GetParam())}, "wall")));
  const Edict player = world.player({-100, 0, kPlayerStanding});
  world.command_and_tick(kForward, 72);
  const bool climbs = GetParam() <= 18;
  EXPECT_EQ(player[field::kOrigin].x > 0, climbs);
  EXPECT_NEAR(player[field::kOrigin].z, double{kPlayerStanding} + (climbs ? GetParam() : 0), 0.2);
  // But not if the server forbids it.
  world.world.settings.no_step = true;
  player.set(field::kOrigin, {-100, 0, kPlayerStanding});
  world.command_and_tick(kForward, 72);
  EXPECT_LT(player[field::kOrigin].x, 0);
}
INSTANTIATE_TEST_SUITE_P(Heights, PlayerSteps, ::testing::Values(8, 18, 19));

TEST(Player, SwimsAndSinks) {
  TestWorld world(flooded_hall_text(400));
  const Edict player = world.player({-400, 0, 200});
  world.command_and_tick(kNothing);
  EXPECT_EQ(player[field::kWaterLevel], 3);
  EXPECT_EQ(player[field::kWaterType], -3);
  world.command_and_tick(kForward, 144);
  EXPECT_NEAR(player[field::kVelocity].x, 320 * 0.7, 0.5);
  world.command_and_tick(kNothing, 400);
  EXPECT_NEAR(player[field::kOrigin].z, kPlayerStanding, 0.1);  // has reached the ground
  player.set(field::kOrigin, {0, 0, 300});
  player.set(field::kVelocity, {0, 0, 0});
  world.command_and_tick(kNothing, 100);
  EXPECT_NEAR(player[field::kVelocity].z, -60 * 0.7, 0.5);
  world.command_and_tick({.up = 200}, 50);
  EXPECT_NEAR(player[field::kVelocity].z, 200 * 0.7, 0.5);
}

TEST(Player, WaterLevelsAreFeetMiddleAndEyes) {
  TestWorld world(flooded_hall_text(100));
  world.world.settings.gravity = 0;
  const Edict player = world.player({0, 0, 200});
  for (const auto& [feet, level] :
       {std::pair{99.5f, 0}, {98.0f, 1}, {73.0f, 1}, {71.0f, 2}, {55.0f, 2}, {53.0f, 3}}) {
    player.set(field::kOrigin, {0, 0, feet + 24});
    player.set(field::kVelocity, {0, 0, 0});
    world.tick();
    EXPECT_EQ(player[field::kWaterLevel], level) << feet;
    EXPECT_EQ(player[field::kWaterType], level > 0 ? -3 : -1) << feet;
  }
}

TEST(Player, JumpsOutOfWaterAtTheVelocityOfGameCode) {
  TestWorld world(flooded_hall_text(100));
  const Edict player = world.player({0, 0, 80});
  world.command_and_tick(kNothing);
  player.set_flag(flag::kWaterJump);
  player.set(field::kTeleportTime, static_cast<float>(world.world.time_s) + 2);
  player.set(field::kMoveDirection, {0, 150, 0});
  player.set(field::kVelocity, {0, 0, 225});
  // Neither gravity nor the player's input has an effect.
  world.command_and_tick(kForward, 10);
  EXPECT_EQ(player[field::kVelocity], Vec3(0, 150, 225));
  world.command_and_tick(kForward, 60);
  EXPECT_FALSE(player.has_flag(flag::kWaterJump));
  EXPECT_EQ(player[field::kTeleportTime], 0);
}

TEST(Player, DoesNotMoveBackwardRightAfterATeleport) {
  TestWorld world(hall_text());
  const Edict player = world.player({0, 0, kPlayerStanding});
  world.command_and_tick(kNothing, 2);
  player.set(field::kTeleportTime, static_cast<float>(world.world.time_s) + 0.5f);
  world.command_and_tick({.forward = -400}, 30);
  EXPECT_EQ(player[field::kOrigin].x, 0);
  world.command_and_tick({.forward = -400}, 30);
  EXPECT_LT(player[field::kOrigin].x, -10);
}

TEST(Player, ItsModelTurnsAndLeansAndPunchesFade) {
  TestWorld world(hall_text());
  const Edict player = world.player({0, 0, kPlayerStanding});
  player.set(field::kVelocity, {0, -100, 0});
  player.set(field::kPunchAngle, {-4, 0, 0});
  move_player(world.world, player.index(), {.view_angles_deg = {30, 0, 0}});
  EXPECT_NEAR(player[field::kPunchAngle].x, -4 + 10 * kPlayerTick, 1e-4);
  EXPECT_EQ(player[field::kViewAngles], Vec3(30, 0, 0));
  EXPECT_NEAR(player[field::kAngles].x, -(30 - 4 + 10 * kPlayerTick) / 3, 1e-3);
  EXPECT_NEAR(player[field::kAngles].z, 4, 0.01);
  player.set(field::kFixAngle, 1);
  move_player(world.world, player.index(), {.view_angles_deg = {0, 90, 0}});
  EXPECT_EQ(player[field::kAngles].y, 0);
  // A dead player can only look around.
  player.set(field::kHealth, 0);
  player.set(field::kVelocity, {0, 0, 0});
  move_player(world.world, player.index(), {.view_angles_deg = {0, 45, 0}, .forward = 400});
  EXPECT_EQ(player[field::kVelocity], Vec3(0.0f));
  EXPECT_EQ(player[field::kViewAngles].y, 45);
}

TEST(Player, FliesThroughWallsWithoutClipping) {
  TestWorld world(hall_text());
  const Edict player = world.player({0, 0, 100});
  player.set(field::kMoveType, static_cast<float>(MoveType::kNoClip));
  world.command_and_tick({.forward = 400, .up = 0}, 216);
  EXPECT_NEAR(player[field::kOrigin].x, 3 * 320, 1);
  EXPECT_NEAR(player[field::kOrigin].z, 100, 0.01);
}

TEST(Player, GetsUnstuck) {
  TestWorld world(hall_text(test::box_text({100, -512, 0}, {512, 512, 200}, "wall")));
  const Edict player = world.player({0, 0, kPlayerStanding});
  world.command_and_tick(kNothing, 2);
  // Back to where it last was free.
  player.set(field::kOrigin, {150, 0, kPlayerStanding});
  world.command_and_tick(kNothing, 2);
  EXPECT_NEAR(player[field::kOrigin].x, 0, 0.1);
  // One unit to the side.
  player.set(field::kOrigin, {84.5f, 0, kPlayerStanding});
  player.set(field::kOldOrigin, {150, 0, kPlayerStanding});
  world.command_and_tick(kNothing, 2);
  EXPECT_NEAR(player[field::kOrigin].x, 83.5, 0.1);
  // Up to 17 units up.
  player.set(field::kOrigin, {0, 0, kPlayerStanding - 10});
  player.set(field::kOldOrigin, {150, 0, kPlayerStanding});
  world.command_and_tick(kNothing, 2);
  EXPECT_GT(player[field::kOrigin].z, kPlayerStanding - 0.1);
}

TEST(Player, PreThinkAndPostThinkRunOnlyWhileActive) {
  TestWorld world(hall_text(), 2);
  const vm::FunctionIndex start = world.calls.add(), before = world.calls.add(), after = world.calls.add();
  world.functions = {start, before, after};
  world.player({0, 0, kPlayerStanding});
  constexpr bool kOnlyFirst[] = {true, false};
  ASSERT_TRUE(run_physics(world.world, world.functions, kOnlyFirst, world.force_retouch).ok());
  ASSERT_EQ(world.calls.log.size(), 3u);
  EXPECT_EQ(world.calls.log[0].function, start);
  EXPECT_EQ(world.calls.log[0].self, vm::kWorld);
  EXPECT_EQ(world.calls.log[1].function, before);
  EXPECT_EQ(world.calls.log[1].self, EntityIndex{1});
  EXPECT_EQ(world.calls.log[2].function, after);
  EXPECT_NEAR(world.world.time_s, 10 + kPlayerTick, 1e-9);
}

TEST(Walker, OtherEntitiesWalkAlike) {
  TestWorld world(hall_text(test::box_text({0, -512, 0}, {512, 512, 16}, "wall")));
  const Edict bot = world.spawn({-40, 0, kPlayerStanding}, kPlayerBox, Solid::kSlideBox, MoveType::kWalk);
  bot.set_flag(flag::kOnGround);
  for (int i = 0; i < 30; ++i) {
    bot.set(field::kVelocity, {200, 0, bot[field::kVelocity].z});
    world.tick();
  }
  EXPECT_GT(bot[field::kOrigin].x, 0);
  EXPECT_NEAR(bot[field::kOrigin].z, kPlayerStanding + 16, 0.1);
}

}  // namespace
}  // namespace temblor::server
