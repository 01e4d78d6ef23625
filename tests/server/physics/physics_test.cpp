// A whole tick: the order of entities, and the calls of game code.
#include "server/physics/physics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>

#include "server/test_world.h"

namespace temblor::server {
namespace {

using ::testing::ElementsAre;
using vm::EntityIndex;

constexpr math::Bounds kPhysicsCube{{-8, -8, -8}, {8, 8, 8}};
constexpr double kPhysicsTick = 1.0 / 72;

class PhysicsTest : public ::testing::Test {
 protected:
  EntityIndex thinker(float think_s, vm::FunctionIndex think, MoveType type = MoveType::kNone) {
    const Edict edict = world_.spawn({0, 0, 100}, kPhysicsCube, Solid::kNot, type);
    edict.set(field::kThink, think);
    edict.set(field::kNextThink, think_s);
    return edict.index();
  }
  std::vector<EntityIndex> thought() const {
    std::vector<EntityIndex> selves;
    for (const FakeCalls::Call& call : world_.calls.log) selves.push_back(call.self);
    return selves;
  }

  TestWorld world_{hall_text()};
  static constexpr float kNow = 10;
};

TEST_F(PhysicsTest, ThinksRunInTheTickThatContainsTheirTime) {
  const vm::FunctionIndex think = world_.calls.add([&](const FakeCalls::Call& call) {
    EXPECT_EQ(world_[call.self][field::kNextThink], 0);
    EXPECT_EQ(call.other, vm::kWorld);
  });
  const EntityIndex late = thinker(kNow - 5, think), soon = thinker(kNow + 0.01f, think),
                    next = thinker(kNow + 0.02f, think);
  thinker(0, think);
  thinker(-1, think);
  world_.tick();
  ASSERT_THAT(thought(), ElementsAre(late, soon));
  EXPECT_EQ(world_.calls.log[0].time_s, kNow);
  EXPECT_EQ(world_.calls.log[1].time_s, double{kNow + 0.01f});
  world_.tick();
  EXPECT_THAT(thought(), ElementsAre(late, soon, next));
  world_.tick(20);
  EXPECT_EQ(world_.calls.log.size(), 3u);
}

TEST_F(PhysicsTest, EveryMoveTypeThinks) {
  const vm::FunctionIndex think = world_.calls.add();
  std::vector<EntityIndex> all;
  for (const MoveType type : {MoveType::kNone, MoveType::kWalk, MoveType::kStep, MoveType::kFly,
                              MoveType::kToss, MoveType::kNoClip, MoveType::kFlyMissile, MoveType::kBounce,
                              MoveType::kFollow, static_cast<MoveType>(11), static_cast<MoveType>(-7)})
    all.push_back(thinker(kNow + 0.001f, think, type));
  world_.tick();
  EXPECT_EQ(thought(), all);
}

TEST_F(PhysicsTest, AnEntityMadeInATickTakesPartInIt) {
  const vm::FunctionIndex second = world_.calls.add();
  EntityIndex made{};
  const vm::FunctionIndex first =
      world_.calls.add([&](const FakeCalls::Call&) { made = thinker(kNow + 0.001f, second); });
  thinker(kNow, first);
  world_.tick();
  EXPECT_EQ(world_.calls.count(second), 1);
  EXPECT_EQ(thought().back(), made);
}

TEST_F(PhysicsTest, ARemovedEntityDoesNothingMore) {
  std::vector<EntityIndex> others;
  const vm::FunctionIndex never = world_.calls.add();
  const vm::FunctionIndex taking = world_.calls.add([&](const FakeCalls::Call& call) {
    remove(world_.world, call.self);
    for (const EntityIndex other : others) remove(world_.world, other);
  });
  for (const MoveType type : {MoveType::kNone, MoveType::kWalk, MoveType::kStep, MoveType::kFly,
                              MoveType::kNoClip, MoveType::kBounce, MoveType::kFollow})
    thinker(kNow, taking, type);
  others.push_back(thinker(kNow, never));
  world_.tick(3);
  EXPECT_EQ(world_.calls.count(never), 0);
  EXPECT_EQ(world_.calls.count(taking), 7);
}

TEST_F(PhysicsTest, RetouchingCountsDown) {
  const vm::FunctionIndex touch = world_.calls.add();
  const Edict trigger = world_.spawn({0, 0, 100}, kPhysicsCube, Solid::kTrigger, MoveType::kNone);
  trigger.set(field::kTouch, touch);
  world_.spawn({0, 0, 100}, kPhysicsCube, Solid::kBox, MoveType::kNone);
  world_.tick(3);
  EXPECT_EQ(world_.calls.count(touch), 0);
  world_.force_retouch = std::bit_cast<std::uint32_t>(2.0f);
  world_.tick(5);
  EXPECT_EQ(world_.calls.count(touch), 2);
  EXPECT_EQ(std::bit_cast<float>(world_.force_retouch), 0);
}

TEST_F(PhysicsTest, AFailureAnywhereEndsTheTick) {
  const vm::FunctionIndex later = world_.calls.add(), bad = world_.calls.add();
  world_.calls.failing = bad;
  world_.player({0, 0, 100});
  thinker(kNow, later);
  for (const TickFunctions& functions :
       {TickFunctions{bad, {}, {}}, TickFunctions{{}, bad, {}}, TickFunctions{{}, {}, bad}}) {
    world_.functions = functions;
    EXPECT_FALSE(world_.try_tick().ok());
  }
  EXPECT_EQ(world_.calls.count(later), 0);
  EXPECT_EQ(world_.world.time_s, kNow);
}

TEST_F(PhysicsTest, TheWorldItselfIsAPusherAndThinks) {
  const vm::FunctionIndex think = world_.calls.add();
  const Edict ground = world_.world.edicts.world();
  ground.set(field::kThink, think);
  ground.set(field::kNextThink, 0.1f);  // by its own clock
  world_.tick(static_cast<int>(0.2 / kPhysicsTick));
  EXPECT_EQ(world_.calls.count(think), 1);
}

}  // namespace
}  // namespace temblor::server
