// link(): boxes, leaves, and the triggers that an entity touches when it moves.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "artgen/small_level.h"
#include "server/test_world.h"
#include "support/random.h"
#include "world/visibility.h"

namespace temblor::server {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using vm::EntityIndex;

constexpr math::Bounds kLinkCube{{-8, -8, -8}, {8, 8, 8}};

std::vector<EntityIndex> selves(const FakeCalls& calls) {
  std::vector<EntityIndex> result;
  for (const FakeCalls::Call& call : calls.log) result.push_back(call.self);
  return result;
}

class LinkTest : public ::testing::Test {
 protected:
  Edict trigger(const math::Vec3& origin, vm::FunctionIndex touch) {
    const Edict edict = world_.spawn(origin, kLinkCube, Solid::kTrigger, MoveType::kNone);
    edict.set(field::kTouch, touch);
    return edict;
  }
  base::Status link_touching(EntityIndex index) { return link(world_.world, index, TouchTriggers::kYes); }

  TestWorld world_{hall_text()};
};

TEST_F(LinkTest, GrowsBoxesByOneAndItemsByFifteenSideways) {
  const Edict thing = world_.spawn({10, 20, 30}, kLinkCube, Solid::kBox, MoveType::kNone);
  EXPECT_EQ(thing[field::kAbsMin], math::Vec3(1, 11, 21));
  EXPECT_EQ(thing[field::kAbsMax], math::Vec3(19, 29, 39));
  thing.set_flag(flag::kItem);
  ASSERT_TRUE(link_touching(thing.index()).ok());
  EXPECT_EQ(thing[field::kAbsMin], math::Vec3(-13, -3, 22));
  EXPECT_EQ(thing[field::kAbsMax], math::Vec3(33, 43, 38));
}

TEST_F(LinkTest, CallsTriggersInTheirOrder) {
  const vm::FunctionIndex touch = world_.calls.add();
  // Some in one part of the level, and one across its middle: made last, but in the whole level's part.
  const Edict first = trigger({300, 300, 50}, touch), second = trigger({302, 300, 50}, touch);
  const Edict wide =
      world_.spawn({0, 0, 50}, {{-400, -400, -8}, {400, 400, 8}}, Solid::kTrigger, MoveType::kNone);
  wide.set(field::kTouch, touch);
  trigger({-300, 300, 50}, touch);  // elsewhere
  const Edict toucher = world_.spawn({300, 300, 50}, kLinkCube, Solid::kSlideBox, MoveType::kNone);
  ASSERT_TRUE(link_touching(toucher.index()).ok());
  EXPECT_THAT(selves(world_.calls), ElementsAre(wide.index(), first.index(), second.index()));
  EXPECT_EQ(world_.calls.log[0].other, toucher.index());
  EXPECT_EQ(world_.calls.log[0].time_s, world_.world.time_s);
}

TEST_F(LinkTest, IgnoresNontriggersAndTriggersWithoutTouch) {
  const vm::FunctionIndex touch = world_.calls.add();
  trigger({0, 0, 50}, vm::kNoFunction);
  const Edict solid = world_.spawn({0, 0, 50}, kLinkCube, Solid::kBox, MoveType::kNone);
  solid.set(field::kTouch, touch);
  const Edict toucher = world_.spawn({0, 0, 50}, kLinkCube, Solid::kSlideBox, MoveType::kNone);
  ASSERT_TRUE(link_touching(toucher.index()).ok());
  toucher.set(field::kSolid, static_cast<float>(Solid::kNot));
  trigger({0, 0, 50}, touch);
  ASSERT_TRUE(link_touching(toucher.index()).ok());  // a nonsolid entity touches nothing
  EXPECT_THAT(world_.calls.log, IsEmpty());
}

TEST_F(LinkTest, ATriggerIsCheckedAgainWhenItsTurnComes) {
  std::vector<EntityIndex> triggers;
  const vm::FunctionIndex touch = world_.calls.add([&](const FakeCalls::Call&) {
    // The first call removes the second trigger and makes the third solid; the fourth remains.
    remove(world_.world, triggers[1]);
    world_[triggers[2]].set(field::kSolid, static_cast<float>(Solid::kBox));
  });
  for (int i = 0; i < 4; ++i) triggers.push_back(trigger({0, 0, 50}, touch).index());
  const Edict toucher = world_.spawn({0, 0, 50}, kLinkCube, Solid::kSlideBox, MoveType::kNone);
  ASSERT_TRUE(link_touching(toucher.index()).ok());
  EXPECT_THAT(selves(world_.calls), ElementsAre(triggers[0], triggers[3]));
}

TEST_F(LinkTest, EndsWhenTheToucherIsGoneOrHasMovedAway) {
  const vm::FunctionIndex taking =
      world_.calls.add([&](const FakeCalls::Call& call) { remove(world_.world, call.other); });
  trigger({0, 0, 50}, taking);
  trigger({0, 0, 50}, taking);
  const EntityIndex toucher = world_.spawn({0, 0, 50}, kLinkCube, Solid::kSlideBox, MoveType::kNone).index();
  ASSERT_TRUE(link_touching(toucher).ok());
  EXPECT_EQ(world_.calls.count(taking), 1);

  const vm::FunctionIndex teleport = world_.calls.add([&](const FakeCalls::Call& call) {
    world_[call.other].set(field::kOrigin, {-300, -300, 50});
    EXPECT_TRUE(link_touching(call.other).ok());
  });
  trigger({200, 0, 50}, teleport);
  trigger({200, 0, 50}, teleport);
  const EntityIndex traveler =
      world_.spawn({200, 0, 50}, kLinkCube, Solid::kSlideBox, MoveType::kNone).index();
  ASSERT_TRUE(link_touching(traveler).ok());
  EXPECT_EQ(world_.calls.count(teleport), 1);
}

TEST_F(LinkTest, APlayerWhoLeavesTheLevelInATouchFunctionSurvivesNewEntities) {
  // Words move in memory when there are more entities than before.
  const vm::FunctionIndex spawning = world_.calls.add([&](const FakeCalls::Call&) {
    for (int i = 0; i < 500; ++i) ASSERT_TRUE(world_.world.edicts.spawn(world_.world.time_s).ok());
  });
  for (int i = 0; i < 3; ++i) trigger({0, 0, 50}, spawning);
  const EntityIndex toucher = world_.spawn({0, 0, 50}, kLinkCube, Solid::kSlideBox, MoveType::kNone).index();
  ASSERT_TRUE(link_touching(toucher).ok());
  EXPECT_EQ(world_.calls.count(spawning), 3);
  EXPECT_EQ(world_[toucher][field::kOrigin], math::Vec3(0, 0, 50));
}

TEST_F(LinkTest, PassesOnErrorsOfQuakeC) {
  world_.calls.failing = world_.calls.add();
  const vm::FunctionIndex touch = world_.calls.add();
  trigger({0, 0, 50}, world_.calls.failing);
  trigger({0, 0, 50}, touch);
  const Edict toucher = world_.spawn({0, 0, 50}, kLinkCube, Solid::kSlideBox, MoveType::kNone);
  EXPECT_FALSE(link_touching(toucher.index()).ok());
  EXPECT_EQ(world_.calls.count(touch), 0);
  EXPECT_TRUE(world_.world.scratch.found.empty());
}

TEST(LinkLeaves, AreThoseOfAllPointsOfTheBox) {
  auto level = world::make_level(artgen::make_small_level(), "small").value();
  TestWorld world(level);
  test::Random random(33);
  const math::Bounds bounds = level->world().bounds;
  const Edict edict = world.spawn({0, 0, 0}, kLinkCube, Solid::kBox, MoveType::kNone);
  edict.set(field::kModelIndex, 1);
  int checked = 0;
  for (int i = 0; i < 300; ++i) {
    const float half = static_cast<float>(random.log_uniform(1, 100));
    math::Vec3 origin;
    for (int axis = 0; axis < 3; ++axis)
      origin[axis] = static_cast<float>(random.uniform(bounds.mins[axis], bounds.maxs[axis]));
    edict.set(field::kOrigin, origin);
    edict.set(field::kMins, math::Vec3(-half));
    edict.set(field::kMaxs, math::Vec3(half));
    ASSERT_TRUE(link(world.world, edict.index(), TouchTriggers::kNo).ok());
    const EdictState& state = world.world.edicts.state(edict.index());
    if (state.is_in_too_many_leaves) {
      EXPECT_THAT(state.leaves, IsEmpty());
      continue;
    }
    for (int k = 0; k < 40; ++k) {
      const world::LeafIndex leaf = world::find_leaf(*level, origin + random.in_cube(half));
      if (level->leaf(leaf).contents == world::Contents::kSolid) continue;
      ++checked;
      EXPECT_NE(std::ranges::find(state.leaves, leaf), state.leaves.end());
    }
    auto sorted = state.leaves;
    std::ranges::sort(sorted);
    EXPECT_EQ(std::ranges::adjacent_find(sorted), sorted.end());
  }
  EXPECT_GT(checked, 500);
  // An entity without a model is invisible.
  edict.set(field::kModelIndex, 0);
  ASSERT_TRUE(link(world.world, edict.index(), TouchTriggers::kNo).ok());
  EXPECT_THAT(world.world.edicts.state(edict.index()).leaves, IsEmpty());
}

}  // namespace
}  // namespace temblor::server
