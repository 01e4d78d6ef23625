// Doors and lifts: what they carry, what blocks them, and their own clock.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/test_world.h"

namespace temblor::server {
namespace {

using math::Vec3;
using vm::EntityIndex;

constexpr math::Bounds kPusherCube{{-8, -8, -8}, {8, 8, 8}};
constexpr float kPusherTick = 1.0f / 72;

// A plate in the middle of the hall, with its upper side at 16.
const std::string kLift = hall_text({}, door_text({-100, -100, 0}, {100, 100, 16}));
// A block at the height of a player.
const std::string kDoor = hall_text({}, door_text({-100, -100, 20}, {-60, 100, 100}));

TEST(Pusher, MovesOnlyUntilItsNextThink) {
  TestWorld world(kLift);
  const Edict lift = world.spawn_pusher(1, {0, 0, 72});
  lift.set(field::kNextThink, 0);
  world.tick(10);
  EXPECT_EQ(lift[field::kOrigin].z, 0);
  EXPECT_EQ(lift[field::kLocalTime], 0);
}

TEST(Pusher, StopsExactlyAtItsNextThink) {
  TestWorld world(kLift);
  const Edict lift = world.spawn_pusher(1, {0, 0, 100});
  const EntityIndex index = lift.index();
  const vm::FunctionIndex think = world.calls.add([&](const FakeCalls::Call& call) {
    EXPECT_NEAR(world[index][field::kOrigin].z, 50, 1e-4);
    EXPECT_EQ(call.time_s, world.world.time_s);
  });
  lift.set(field::kThink, think);
  lift.set(field::kNextThink, 0.5f);  // by its own clock, which began at 0
  world.tick(72);
  EXPECT_EQ(world.calls.count(think), 1);
  EXPECT_EQ(lift[field::kNextThink], 0);
  EXPECT_FLOAT_EQ(lift[field::kLocalTime], 0.5f);
  EXPECT_NEAR(lift[field::kOrigin].z, 50, 1e-4);
}

// Its clock counts seconds in single precision: the later, the coarser. A lift that overshot would stop
// inside its rider, which would then fall through.
TEST(Pusher, StopsAtItsNextThinkLateInAGameToo) {
  for (const float begin_s : {348.0f, 3600.0f}) {
    TestWorld world(kLift);
    const Edict lift = world.spawn_pusher(1, {0, 0, -260});
    const EntityIndex index = lift.index();
    lift.set(field::kOrigin, {0, 0, 496});
    lift.set(field::kLocalTime, begin_s);
    const float end_s = begin_s + 496.0f / 260;
    const vm::FunctionIndex think = world.calls.add([&](const FakeCalls::Call&) {
      // Its position follows from the total time on its clock.
      EXPECT_NEAR(world[index][field::kOrigin].z, 496 - 260 * (end_s - begin_s), 0.005);
    });
    lift.set(field::kThink, think);
    lift.set(field::kNextThink, end_s);
    world.tick(3 * 72);
    EXPECT_EQ(world.calls.count(think), 1);
  }
}

TEST(Pusher, CarriesItsRiders) {
  for (const Vec3 velocity : {Vec3(0, 0, 60), Vec3(90, 30, 0), Vec3(0, 0, -30)}) {
    TestWorld world(kLift);
    const Edict lift = world.spawn_pusher(1, velocity);
    lift.set(field::kOrigin, {0, 0, 60});
    ASSERT_TRUE(link(world.world, lift.index(), TouchTriggers::kNo).ok());
    const Edict player = world.player({0, 0, 76 + 24 + kGap});
    world.tick(2);
    ASSERT_TRUE(player.has_flag(flag::kOnGround));
    ASSERT_EQ(player[field::kGroundEntity], lift.index());
    const Vec3 lift_before = lift[field::kOrigin], before = player[field::kOrigin];
    world.tick(60);
    const Vec3 lift_way = lift[field::kOrigin] - lift_before;
    EXPECT_NEAR(glm::distance(lift_way, velocity * 60.0f * kPusherTick), 0, 0.01);
    EXPECT_NEAR(glm::distance(player[field::kOrigin] - before, lift_way), 0, 0.1);
  }
}

TEST(Pusher, PushesWhatIsInItsWayAndNothingElse) {
  TestWorld world(kDoor);
  const Edict door = world.spawn_pusher(1, {60, 0, 0});
  const Edict in_the_way = world.spawn({-40, 0, 60}, kPusherCube, Solid::kBox, MoveType::kFly);
  const Edict beside = world.spawn({-40, 200, 60}, kPusherCube, Solid::kBox, MoveType::kFly);
  const Edict fixed = world.spawn({-40, -50, 60}, kPusherCube, Solid::kBox, MoveType::kNone);
  in_the_way.set_flag(flag::kOnGround);
  world.tick(72);
  EXPECT_NEAR(in_the_way[field::kOrigin].x, -60 + 60 + 8, 1.1);
  EXPECT_FALSE(in_the_way.has_flag(flag::kOnGround));  // only walkers stay on the ground
  EXPECT_EQ(beside[field::kOrigin].x, -40);
  EXPECT_EQ(fixed[field::kOrigin].x, -40);
  EXPECT_NEAR(door[field::kOrigin].x, 60, 0.01);
}

class BlockedPusher : public ::testing::Test {
 protected:
  BlockedPusher() {
    blocked_ = world_.calls.add([&](const FakeCalls::Call& call) { blocker_ = call.other; });
    world_[door_].set(field::kBlocked, blocked_);
  }

  // Between the door and this wall there is room for 60 units.
  TestWorld world_{hall_text(test::box_text({0, -200, 0}, {30, 200, 200}, "wall"),
                             door_text({-100, -100, 20}, {-60, 100, 100}))};
  EntityIndex door_ = world_.spawn_pusher(1, {60, 0, 0}).index();
  vm::FunctionIndex blocked_{};
  EntityIndex blocker_{};
};

TEST_F(BlockedPusher, StaysAndReportsItsBlocker) {
  // So thin that it counts as a point, at its lower corner.
  const Edict loose = world_.spawn({-49.7f, 60, 60}, {{0, 0, 0}, {2, 2, 2}}, Solid::kBox, MoveType::kFly);
  const Edict box = world_.spawn({-18, 0, 60}, kPlayerBox, Solid::kBox, MoveType::kFly);
  world_.tick(60);
  const Edict door = world_[door_];
  EXPECT_GT(world_.calls.count(blocked_), 20);
  EXPECT_NEAR(box[field::kOrigin].x, -16, 0.9);
  EXPECT_EQ(blocker_, box.index());
  // Its position follows from whole ticks of 5/6 unit each, and its clock agrees.
  EXPECT_LE(door[field::kOrigin].x, 60 - 32);
  EXPECT_GT(door[field::kOrigin].x, 60 - 32 - 2 * 60 * kPusherTick);
  EXPECT_NEAR(door[field::kLocalTime] * 60, door[field::kOrigin].x, 0.01);
  // The other entity was moved, and put back if the blocked push had moved it: it is at the door.
  EXPECT_GT(loose[field::kOrigin].x, -42);
  EXPECT_NEAR(loose[field::kOrigin].x, door[field::kOrigin].x - 60, 60 * kPusherTick + 0.1);
  EXPECT_FALSE(is_stuck(world_.world, loose.index()));
}

TEST_F(BlockedPusher, CrushesCorpsesFlat) {
  const Edict corpse = world_.spawn({-18, 0, 60}, kPlayerBox, Solid::kTrigger, MoveType::kToss);
  corpse.set(field::kVelocity, {0, 0, 0});
  world_.world.settings.gravity = 0;
  world_.tick(60);
  EXPECT_EQ(world_.calls.count(blocked_), 0);
  EXPECT_EQ(corpse[field::kMins].x, 0);
  EXPECT_EQ(corpse[field::kMins], corpse[field::kMaxs]);
  EXPECT_NEAR(world_[door_][field::kOrigin].x, 50, 0.01);
}

TEST_F(BlockedPusher, ContinuesWhenQuakeCRemovesTheBlocker) {
  const EntityIndex box = world_.spawn({-18, 0, 60}, kPlayerBox, Solid::kBox, MoveType::kFly).index();
  world_[door_].set(field::kBlocked,
                    world_.calls.add([&](const FakeCalls::Call& call) { remove(world_.world, call.other); }));
  world_.tick(60);
  EXPECT_TRUE(world_.world.edicts.is_free(box));
  EXPECT_GT(world_[door_][field::kOrigin].x, 48);
}

TEST_F(BlockedPusher, PassesOnErrorsOfQuakeCAndForgetsWhatItMoved) {
  world_.spawn({-18, 0, 60}, kPlayerBox, Solid::kBox, MoveType::kFly);
  world_.calls.failing = blocked_;
  bool failed = false;
  for (int i = 0; i < 60 && !failed; ++i) failed = !world_.try_tick().ok();
  EXPECT_TRUE(failed);
  EXPECT_TRUE(world_.world.scratch.moved.empty());
}

TEST(Pusher, ANonsolidOneCarriesItsRidersAndStaysNonsolid) {
  TestWorld world(kLift);
  const Edict lift = world.spawn_pusher(1, {0, 60, 0});
  lift.set(field::kSolid, static_cast<float>(Solid::kTrigger));
  const Edict rider = world.spawn({0, 0, 200}, kPusherCube, Solid::kBox, MoveType::kBounce);
  rider.set_flag(flag::kOnGround);
  rider.set(field::kGroundEntity, lift.index());
  world.tick();
  EXPECT_NEAR(rider[field::kOrigin].y, 60 * kPusherTick, 0.01);
  EXPECT_EQ(lift.solid(), Solid::kTrigger);
}

}  // namespace
}  // namespace temblor::server
