// The pitch that the game suggests to players on stairs.
#include "server/game/ideal_pitch.h"

#include <gtest/gtest.h>

#include "server/test_world.h"

namespace temblor::server {
namespace {

constexpr double kTread_units = 12;  // the distance between the probes

// A flight of stairs that rises eastward from x = 0, by `rise_units` per step.
std::string stairs_text(double rise_units) {
  std::string brushes;
  for (int i = 0; i < 12; ++i)
    brushes += test::box_text({i * kTread_units, -64, 0}, {400, 64, (i + 1) * rise_units}, "wall");
  return hall_text(brushes);
}

float pitch_at(TestWorld& io_world, const math::Vec3& origin, float yaw_deg) {
  const Edict player = io_world.player(origin);
  io_world.tick(8);
  player.set(field::kAngles, math::Vec3{0, yaw_deg, 0});
  player.set(field::kViewOffset, math::Vec3{0, 0, 22});
  player.set(field::kIdealPitch, 7.0f);
  set_ideal_pitch(io_world.world, player.index());
  return player[field::kIdealPitch];
}

TEST(IdealPitch, IsALevelLookOnAFloor) {
  TestWorld world(hall_text());
  EXPECT_EQ(pitch_at(world, {-200, 0, 25}, 0), 0);
}

// Pitch is positive downward: on the way up the stairs it is negative, 0.8
// degrees for each unit that a step rises.
TEST(IdealPitch, LooksUpAFlightOfStairs) {
  TestWorld world(stairs_text(4));
  EXPECT_FLOAT_EQ(pitch_at(world, {-20, 0, 25}, 0), -4 * 0.8f);
}

TEST(IdealPitch, LooksDownAFlightOfStairs) {
  TestWorld world(stairs_text(8));
  EXPECT_FLOAT_EQ(pitch_at(world, {170, 0, 12 * 8 + 25}, 180), 8 * 0.8f);
}

TEST(IdealPitch, FollowsItsScale) {
  TestWorld world(stairs_text(4));
  world.world.ideal_pitch_scale = 0.5f;
  EXPECT_FLOAT_EQ(pitch_at(world, {-20, 0, 25}, 0), -4 * 0.5f);
}

TEST(IdealPitch, StaysAsItIsBeforeAWall) {
  TestWorld world(hall_text());
  EXPECT_EQ(pitch_at(world, {480, 0, 25}, 0), 7);
}

}  // namespace
}  // namespace temblor::server
