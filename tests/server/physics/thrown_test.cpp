// Entities that fall, fly and bounce, compared with the formulas.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "server/test_world.h"

namespace temblor::server {
namespace {

using math::Vec3;
using ::testing::IsEmpty;
using vm::EntityIndex;

constexpr math::Bounds kThrownCube{{-8, -8, -8}, {8, 8, 8}};
constexpr double kThrownTick = 1.0 / 72;

TEST(Thrown, FallsAsLongAsTheHeightSays) {
  TestWorld world(hall_text());
  const Edict gib = world.spawn({0, 0, 408}, kThrownCube, Solid::kNot, MoveType::kToss);
  int ticks = 0;
  while (!gib.has_flag(flag::kOnGround) && ticks < 500) {
    world.tick();
    ++ticks;
  }
  // 400 units: after n ticks it has fallen g / 72 / 72 * n (n + 1) / 2.
  const double n = (std::sqrt(1 + 8 * 400 * 72 * 72 / 800.0) - 1) / 2;
  EXPECT_EQ(ticks, static_cast<int>(std::ceil(n)));
  EXPECT_NEAR(ticks * kThrownTick, std::sqrt(2 * 400 / 800.0), 2 * kThrownTick);
  EXPECT_NEAR(gib[field::kOrigin].z, 8 + kGap, 0.01);
  EXPECT_EQ(gib[field::kVelocity], Vec3(0.0f));
  EXPECT_EQ(gib[field::kGroundEntity], vm::kWorld);
  // It lies still until game code clears the flag.
  gib.set(field::kVelocity, {100, 0, 100});
  world.tick(10);
  EXPECT_EQ(gib[field::kOrigin].x, 0);
  gib.clear_flag(flag::kOnGround);
  world.tick();
  EXPECT_GT(gib[field::kOrigin].x, 1);
}

TEST(Thrown, FallsByItsOwnGravityIfThereIsSuchAField) {
  TestWorld world(hall_text());
  world.world.gravity_field = Field<float>{kSystemFieldWords};
  const Edict light = world.spawn({0, 0, 400}, kThrownCube, Solid::kNot, MoveType::kToss);
  const Edict plain = world.spawn({50, 0, 400}, kThrownCube, Solid::kNot, MoveType::kToss);
  light.set(*world.world.gravity_field, 0.25f);
  world.tick(20);
  EXPECT_NEAR(light[field::kVelocity].z, 0.25f * plain[field::kVelocity].z, 1e-3);
  EXPECT_NEAR(plain[field::kVelocity].z, -800 * 20 * kThrownTick, 1e-2);
}

TEST(Thrown, WeightlessThingsFlyStraightAndTurn) {
  TestWorld world(hall_text());
  for (const MoveType type : {MoveType::kFly, MoveType::kFlyMissile}) {
    const Edict rocket = world.spawn({-300, 0, 200}, kNoBox, Solid::kBox, type);
    rocket.set(field::kVelocity, {360, 0, 0});
    rocket.set(field::kAngularVelocity, {0, 72, 0});
    world.tick(72);
    EXPECT_NEAR(rocket[field::kOrigin].x, 60, 0.01);
    EXPECT_EQ(rocket[field::kOrigin].z, 200);
    EXPECT_NEAR(rocket[field::kAngles].y, 72, 0.01);
    remove(world.world, rocket.index());
  }
}

TEST(Thrown, BouncesWithHalfOfItsSpeedAndComesToRest) {
  TestWorld world(hall_text());
  const Edict grenade = world.spawn({0, 0, 308}, kThrownCube, Solid::kBox, MoveType::kBounce);
  grenade.set(field::kVelocity, {100, 0, 0});
  float fastest_down = 0;
  while (grenade[field::kVelocity].z <= 0) {
    fastest_down = std::min(fastest_down, grenade[field::kVelocity].z);
    world.tick();
  }
  // It hits the floor with one more tick's gravity; 1.5 times that velocity is taken away.
  EXPECT_NEAR(grenade[field::kVelocity].z, -0.5 * (fastest_down - 800 * kThrownTick), 0.1);
  EXPECT_EQ(grenade[field::kVelocity].x, 100);
  for (int i = 0; i < 400 && !grenade.has_flag(flag::kOnGround); ++i) {
    grenade.set(field::kVelocity, {0, 0, grenade[field::kVelocity].z});
    world.tick();
  }
  EXPECT_TRUE(grenade.has_flag(flag::kOnGround));
  EXPECT_NEAR(grenade[field::kOrigin].z, 8 + kGap, 0.01);
}

TEST(Thrown, ABounceUnderSixtyRests) {
  for (const auto& [speed, rests] : {std::pair{100.0f, true}, {140.0f, false}}) {
    TestWorld world(hall_text());
    world.world.settings.gravity = 0;
    const Edict grenade = world.spawn({0, 0, 9}, kThrownCube, Solid::kBox, MoveType::kBounce);
    grenade.set(field::kVelocity, {0, 0, -speed});
    world.tick();
    EXPECT_EQ(grenade.has_flag(flag::kOnGround), rests);
    EXPECT_NEAR(grenade[field::kVelocity].z, rests ? 0 : speed / 2, 0.01);
  }
}

TEST(Thrown, TouchesWhatItMeetsAndIsTouchedByIt) {
  TestWorld world(hall_text());
  const vm::FunctionIndex touch = world.calls.add();
  const Edict rocket = world.spawn({-100, 0, 100}, kNoBox, Solid::kBox, MoveType::kFlyMissile);
  const Edict box = world.spawn({0, 0, 100}, kThrownCube, Solid::kBox, MoveType::kNone);
  rocket.set(field::kVelocity, {1000, 0, 0});
  rocket.set(field::kTouch, touch);
  box.set(field::kTouch, touch);
  world.tick(8);
  ASSERT_EQ(world.calls.log.size(), 2u);
  EXPECT_EQ(world.calls.log[0].self, rocket.index());
  EXPECT_EQ(world.calls.log[0].other, box.index());
  EXPECT_EQ(world.calls.log[1].self, box.index());
  EXPECT_EQ(world.calls.log[1].other, rocket.index());
}

TEST(Thrown, AMissileCanRemoveItselfInItsTouch) {
  TestWorld world(hall_text());
  const EntityIndex rocket = world.spawn({-100, 0, 100}, kNoBox, Solid::kBox, MoveType::kFlyMissile).index();
  world[rocket].set(field::kVelocity, {2000, 0, 0});
  const vm::FunctionIndex touch = world.calls.add([&](const FakeCalls::Call& call) {
    EXPECT_EQ(call.other, vm::kWorld);
    remove(world.world, call.self);
  });
  world[rocket].set(field::kTouch, touch);
  world.tick(40);
  EXPECT_EQ(world.calls.count(touch), 1);
  EXPECT_TRUE(world.world.edicts.is_free(rocket));
}

TEST(Thrown, VelocityIsLimitedAndFinite) {
  TestWorld world(hall_text());
  const Edict gib = world.spawn({0, 0, 200}, kNoBox, Solid::kNot, MoveType::kFly);
  gib.set(field::kVelocity, {1e9f, std::nanf(""), -1e9f});
  world.tick();
  EXPECT_NEAR(gib[field::kOrigin].x, 2000 * kThrownTick, 0.01);
  EXPECT_NEAR(gib[field::kOrigin].z, 200 - 2000 * kThrownTick, 0.01);
  EXPECT_EQ(gib[field::kVelocity].y, 0);
}

TEST(Thrown, SplashesOnlyWhenItMeetsTheBottomOfWater) {
  TestWorld world(flooded_hall_text(200));
  const Edict gib = world.spawn({0, 0, 300}, kThrownCube, Solid::kNot, MoveType::kToss);
  gib.set(field::kWaterType, -1);
  world.tick(45);
  EXPECT_THAT(world.world.sounds, IsEmpty());
  EXPECT_LT(gib[field::kOrigin].z, 200);
  world.tick(25);
  ASSERT_EQ(world.world.sounds.size(), 1u);
  EXPECT_EQ(world.world.sounds[0].entity, gib.index());
  EXPECT_EQ(world.world.sounds[0].name, "misc/h2ohit1.wav");
  EXPECT_EQ(gib[field::kWaterType], -3);
  EXPECT_EQ(gib[field::kWaterLevel], 1);
}

TEST(Monster, FallsThinksAndLandsWithASound) {
  TestWorld world(hall_text());
  const Edict ogre = world.spawn({0, 0, 424}, kLargeBox, Solid::kSlideBox, MoveType::kStep);
  ogre.set_flag(flag::kMonster);
  const vm::FunctionIndex think = world.calls.add();
  ogre.set(field::kThink, think);
  ogre.set(field::kNextThink, 10.5f);
  world.tick(72);
  EXPECT_TRUE(ogre.has_flag(flag::kOnGround));
  EXPECT_NEAR(ogre[field::kOrigin].z, 24 + kGap, 0.01);
  EXPECT_EQ(world.calls.count(think), 1);
  ASSERT_EQ(world.world.sounds.size(), 1u);
  EXPECT_EQ(world.world.sounds[0].name, "demon/dland2.wav");
  // Not a second time, and not from a small height.
  world.world.sounds.clear();
  ogre.clear_flag(flag::kOnGround);
  ogre.set(field::kOrigin, {0, 0, 26});
  world.tick(30);
  EXPECT_TRUE(ogre.has_flag(flag::kOnGround));
  EXPECT_THAT(world.world.sounds, IsEmpty());
}

TEST(Monster, SplashesOnItsWayInAndOut) {
  TestWorld world(flooded_hall_text(200));
  const Edict fish = world.spawn({0, 0, 100}, kThrownCube, Solid::kSlideBox, MoveType::kStep);
  fish.set_flag(flag::kSwim);
  world.tick();
  EXPECT_THAT(world.world.sounds, IsEmpty());
  EXPECT_EQ(fish[field::kWaterType], -3);
  fish.set(field::kOrigin, {0, 0, 300});
  world.tick();
  EXPECT_EQ(world.world.sounds.size(), 1u);
  EXPECT_EQ(fish[field::kWaterType], -1);
  EXPECT_EQ(fish[field::kWaterLevel], -1);  // the original's slip: contents instead of 0
  fish.set(field::kOrigin, {0, 0, 100});
  world.tick(3);
  EXPECT_EQ(world.world.sounds.size(), 2u);
}

TEST(Ghost, GoesThroughEverythingAndTouchesNothing) {
  TestWorld world(hall_text());
  const vm::FunctionIndex touch = world.calls.add();
  const Edict trigger = world.spawn({100, 0, 100}, kThrownCube, Solid::kTrigger, MoveType::kNone);
  trigger.set(field::kTouch, touch);
  const Edict ghost = world.spawn({0, 0, 100}, kThrownCube, Solid::kSlideBox, MoveType::kNoClip);
  ghost.set(field::kVelocity, {1000, 0, 0});
  ghost.set(field::kAngularVelocity, {0, 0, 90});
  world.tick(72);
  EXPECT_NEAR(ghost[field::kOrigin].x, 1000, 0.1);
  EXPECT_NEAR(ghost[field::kAngles].z, 90, 0.01);
  EXPECT_NEAR(ghost[field::kAbsMin].x, 1000 - 9, 0.1);
  EXPECT_EQ(world.calls.count(touch), 0);
}

TEST(Follower, KeepsItsOffsetFromTheEntityThatItFollows) {
  TestWorld world(hall_text());
  const Edict carrier = world.spawn({0, 0, 100}, kThrownCube, Solid::kBox, MoveType::kFly);
  const Edict follower = world.spawn({0, 0, 0}, kThrownCube, Solid::kNot, MoveType::kFollow);
  follower.set(field::kAimEntity, carrier.index());
  follower.set(field::kViewOffset, {20, 0, 5});
  carrier.set(field::kVelocity, {72, 0, 0});
  world.tick();
  EXPECT_NEAR(glm::distance(follower[field::kOrigin], Vec3(21, 0, 105)), 0, 1e-3);
  // A quarter turn since the start: what was ahead is now to the left.
  carrier.set(field::kAngles, {0, 90, 0});
  follower.set(field::kViewAngles, {0, 10, 0});
  world.tick();
  EXPECT_NEAR(glm::distance(follower[field::kOrigin], Vec3(2, 20, 105)), 0, 1e-3);
  EXPECT_NEAR(follower[field::kAngles].y, 100, 1e-3);
  follower.set(field::kAimEntity, EntityIndex{0xffffffff});
  world.tick();
  EXPECT_NEAR(glm::distance(follower[field::kOrigin], Vec3(20, 0, 5)), 0, 1e-3);
}

}  // namespace
}  // namespace temblor::server
