// Steps of monsters: where they may stand, how they turn, and whether they reach their goals.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "server/physics/physics.h"
#include "server/test_world.h"

namespace temblor::server {
namespace {

using math::Vec3;
using vm::EntityIndex;

constexpr float kStanding = 24 + kGap;

class MonsterTest : public ::testing::Test {
 protected:
  explicit MonsterTest(const std::string& text = hall_text(
                           // Floors 18, 19, 100 and 16 higher.
                           test::box_text({100, -512, 0}, {512, 0, 18}, "wall") +
                           test::box_text({100, 0, 0}, {512, 512, 19}, "wall") +
                           test::box_text({-512, 200, 0}, {-100, 512, 100}, "wall") +
                           test::box_text({-512, -512, 0}, {-300, -300, 16}, "wall")))
      : world_(text) {}

  Edict monster(const Vec3& origin, int flags = flag::kOnGround) {
    const Edict edict = world_.spawn(origin, kPlayerBox, Solid::kSlideBox, MoveType::kStep);
    edict.set(field::kFlags, static_cast<float>(flag::kMonster | flags));
    return edict;
  }
  bool walk(const Edict& edict, float yaw_deg, float distance) {
    return walk_move(world_.world, edict.index(), yaw_deg, distance).value();
  }

  TestWorld world_;
};

TEST_F(MonsterTest, WalksOnAFloorInTheGivenDirection) {
  const Edict ogre = monster({0, 0, kStanding});
  EXPECT_TRUE(walk(ogre, 0, 10));
  EXPECT_NEAR(glm::distance(ogre[field::kOrigin], Vec3(10, 0, kStanding)), 0, 0.01);
  EXPECT_TRUE(walk(ogre, 135, 10 * std::sqrt(2.0f)));
  EXPECT_NEAR(glm::distance(ogre[field::kOrigin], Vec3(0, 10, kStanding)), 0, 0.01);
  EXPECT_EQ(ogre[field::kGroundEntity], vm::kWorld);
  EXPECT_NEAR(ogre[field::kAbsMin].x, -17, 0.01);  // linked at its new place
}

TEST_F(MonsterTest, InTheAirDoesNotWalk) {
  const Edict ogre = monster({0, 0, 100}, 0);
  EXPECT_FALSE(walk(ogre, 0, 10));
}

TEST_F(MonsterTest, StepsUpEighteenAndNotNineteen) {
  const Edict low = monster({80, -200, kStanding}), high = monster({80, 200, kStanding});
  EXPECT_TRUE(walk(low, 0, 8));
  EXPECT_NEAR(low[field::kOrigin].z, kStanding + 18, 0.1);
  EXPECT_FALSE(walk(high, 0, 8));
  EXPECT_EQ(high[field::kOrigin], Vec3(80, 200, kStanding));
}

TEST_F(MonsterTest, DoesNotWalkOverAnEdgeButStepsDown) {
  const Edict ogre = monster({-120, 300, 100 + kStanding});
  EXPECT_FALSE(walk(ogre, 0, 40));
  EXPECT_EQ(ogre[field::kOrigin].x, -120);
  // Half of its box over the edge is too much already: the corners need a floor.
  EXPECT_FALSE(walk(ogre, 0, 20));
  EXPECT_TRUE(walk(ogre, 0, 3));
  // With partialground it does.
  ogre.set_flag(flag::kPartialGround);
  EXPECT_TRUE(walk(ogre, 0, 40));
  EXPECT_FALSE(ogre.has_flag(flag::kOnGround));

  const Edict down = monster({-310, -400, 16 + kStanding});
  EXPECT_TRUE(walk(down, 0, 40));
  EXPECT_NEAR(down[field::kOrigin].z, kStanding, 0.1);
  // It searches 18 units down from where it stands, which is 1/32 above its floor: 18 is too deep.
  EXPECT_FALSE(walk(monster({110, -200, 18 + kStanding}), 180, 40));
}

TEST_F(MonsterTest, DoesNotWalkIntoWallsOrOthers) {
  const Edict ogre = monster({490, -200, 18 + kStanding});
  EXPECT_FALSE(walk(ogre, 0, 10));
  const Edict other = monster({440, -200, 18 + kStanding});
  EXPECT_FALSE(walk(other, 0, 20));
  EXPECT_TRUE(walk(other, 90, 20));
}

TEST_F(MonsterTest, TouchesTriggersWhereItSteps) {
  const Edict ogre = monster({0, 0, kStanding});
  const vm::FunctionIndex touch = world_.calls.add();
  const Edict trigger =
      world_.spawn({40, 0, 30}, {{-8, -8, -8}, {8, 8, 8}}, Solid::kTrigger, MoveType::kNone);
  trigger.set(field::kTouch, touch);
  EXPECT_TRUE(walk(ogre, 0, 10));
  EXPECT_EQ(world_.calls.count(touch), 0);
  EXPECT_TRUE(walk(ogre, 0, 10));
  EXPECT_EQ(world_.calls.count(touch), 1);
}

TEST_F(MonsterTest, BottomsAreCheckedAtAllCorners) {
  EXPECT_TRUE(check_bottom(world_.world, monster({-200, 300, 100 + kStanding}).index()));
  EXPECT_FALSE(check_bottom(world_.world, monster({-90, 300, 100 + kStanding}).index()));
  EXPECT_FALSE(check_bottom(world_.world, monster({0, 0, 200}).index()));
  // A step of 18 below one half of it is still a floor.
  EXPECT_TRUE(check_bottom(world_.world, monster({108, -200, 18 + kStanding}).index()));
  EXPECT_FALSE(check_bottom(world_.world, monster({108, 200, 19 + kStanding}).index()));
}

TEST_F(MonsterTest, FliersComeToTheirEnemysHeight) {
  const Edict enemy = monster({0, 300, 100});
  const Edict wizard = monster({0, 0, 300}, flag::kFly);
  wizard.set(field::kEnemy, enemy.index());
  EXPECT_TRUE(walk(wizard, 0, 5));
  EXPECT_NEAR(wizard[field::kOrigin].z, 292, 0.01);  // more than 40 above
  wizard.set(field::kOrigin, {0, 0, 135});
  EXPECT_TRUE(walk(wizard, 0, 5));
  EXPECT_NEAR(wizard[field::kOrigin].z, 135, 0.01);  // between
  wizard.set(field::kOrigin, {0, 0, 110});
  EXPECT_TRUE(walk(wizard, 0, 5));
  EXPECT_NEAR(wizard[field::kOrigin].z, 118, 0.01);  // less than 30 above
  // Under a ceiling it stays level.
  enemy.set(field::kOrigin, {0, 300, 500});
  wizard.set(field::kOrigin, {0, 0, 512 - 32 - 4});
  EXPECT_TRUE(walk(wizard, 0, 5));
  EXPECT_NEAR(wizard[field::kOrigin].z, 512 - 32 - 4, 0.01);
}

class FishTest : public MonsterTest {
 protected:
  FishTest() : MonsterTest(flooded_hall_text(200)) {}
};
TEST_F(FishTest, StaysInTheWater) {
  const Edict fish = monster({0, 0, 190}, flag::kSwim);
  const Edict enemy = monster({0, 100, 400});
  EXPECT_TRUE(walk(fish, 0, 5));
  fish.set(field::kEnemy, enemy.index());
  EXPECT_TRUE(walk(fish, 0, 5));
  EXPECT_NEAR(fish[field::kOrigin].z, 198, 0.01);
  EXPECT_FALSE(walk(fish, 0, 5));
  EXPECT_NEAR(fish[field::kOrigin].z, 198, 0.01);
}

TEST_F(MonsterTest, TurnsTheShortWayAtItsYawSpeed) {
  const Edict ogre = monster({0, 0, kStanding});
  ogre.set(field::kYawSpeed, 20);
  const auto turned = [&](float from, float to) {
    ogre.set(field::kAngles, {0, from, 0});
    ogre.set(field::kIdealYaw, to);
    change_yaw(world_.world, ogre.index());
    return ogre[field::kAngles].y;
  };
  constexpr double kPart = 360.0 / 65536;
  EXPECT_NEAR(turned(0, 90), 20, kPart);
  EXPECT_NEAR(turned(0, 350), 350, 2 * kPart);
  EXPECT_NEAR(turned(350, 90), 10, 2 * kPart);
  EXPECT_NEAR(turned(90, 95), 95, kPart);
  EXPECT_NEAR(turned(-90, 250), 250 + 20 - 20, 20 + kPart);
  EXPECT_NEAR(turned(10, 250), 350, 2 * kPart);
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e30f}) {
    EXPECT_TRUE(std::isfinite(turned(bad, 90)));
    const float yaw = turned(90, bad);
    EXPECT_TRUE(yaw >= 0 && yaw < 360) << yaw;
  }
}

TEST_F(MonsterTest, DropsToTheFloorBelowIt) {
  const Edict thing = monster({-300, 300, 300}, 0);
  EXPECT_TRUE(drop_to_floor(world_.world, thing.index()).value());
  EXPECT_NEAR(thing[field::kOrigin].z, 100 + kStanding, 0.01);
  EXPECT_TRUE(thing.has_flag(flag::kOnGround));
  const Edict high = monster({0, 0, 400}, 0);
  EXPECT_FALSE(drop_to_floor(world_.world, high.index()).value());
  EXPECT_EQ(high[field::kOrigin].z, 400);
  const Edict in_rock = monster({-300, 300, 50}, 0);
  EXPECT_FALSE(drop_to_floor(world_.world, in_rock.index()).value());
  // Onto another entity.
  const Edict above = monster({-300, 300, 200}, 0);
  EXPECT_TRUE(drop_to_floor(world_.world, above.index()).value());
  EXPECT_EQ(above[field::kGroundEntity], thing.index());
}

class ChaseTest : public MonsterTest {
 protected:
  // A wall with a way around it at one end.
  ChaseTest() : MonsterTest(hall_text(test::box_text({-16, -512, 0}, {16, 300, 200}, "wall"))) {}
};

TEST_F(ChaseTest, GetsAroundAWall) {
  const Edict prey = monster({200, 100, kStanding});
  const Edict hunter = monster({-200, 100, kStanding});
  hunter.set(field::kGoalEntity, prey.index());
  hunter.set(field::kEnemy, prey.index());
  hunter.set(field::kYawSpeed, 45);
  GameRandom random(7);
  int thoughts = 0;
  const auto is_near = [&] { return glm::distance(hunter[field::kOrigin], prey[field::kOrigin]) < 60; };
  while (!is_near() && thoughts < 2000) {
    ASSERT_TRUE(move_to_goal(world_.world, hunter.index(), 12, random).ok());
    ASSERT_FALSE(is_stuck(world_.world, hunter.index()));
    ASSERT_NEAR(hunter[field::kOrigin].z, kStanding, 0.01);
    ++thoughts;
  }
  EXPECT_TRUE(is_near()) << thoughts;
  // Within reach of its enemy it stays.
  const Vec3 before = hunter[field::kOrigin];
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(move_to_goal(world_.world, hunter.index(), 60, random).ok());
  EXPECT_EQ(hunter[field::kOrigin], before);
}

TEST_F(ChaseTest, StandsStillOnAPillarAndMayFallWhenItIsTakenAway) {
  const Edict prey = monster({200, 100, kStanding});
  const Edict hunter = monster({-200, 100, 200});  // over nothing
  hunter.set(field::kGoalEntity, prey.index());
  hunter.set(field::kYawSpeed, 360);
  GameRandom random(7);
  ASSERT_TRUE(move_to_goal(world_.world, hunter.index(), 12, random).ok());
  EXPECT_EQ(hunter[field::kOrigin], Vec3(-200, 100, 200));
  EXPECT_TRUE(hunter.has_flag(flag::kPartialGround));
  ASSERT_TRUE(move_to_goal(world_.world, hunter.index(), 12, random).ok());
  EXPECT_FALSE(hunter.has_flag(flag::kOnGround));
  EXPECT_NE(hunter[field::kOrigin], Vec3(-200, 100, 200));
}

TEST_F(ChaseTest, AStepIsUndoneWhileItFacesElsewhere) {
  const Edict prey = monster({-200, 400, kStanding});
  const Edict hunter = monster({-200, 100, kStanding});
  hunter.set(field::kGoalEntity, prey.index());
  hunter.set(field::kIdealYaw, 90);
  hunter.set(field::kAngles, {0, 270, 0});
  hunter.set(field::kYawSpeed, 10);
  GameRandom random(9);
  ASSERT_TRUE(move_to_goal(world_.world, hunter.index(), 12, random).ok());
  EXPECT_EQ(hunter[field::kOrigin], Vec3(-200, 100, kStanding));
  EXPECT_NE(hunter[field::kAngles].y, 270);
}

TEST_F(ChaseTest, SurvivesItsRemovalOnTheWay) {
  const vm::FunctionIndex taking =
      world_.calls.add([&](const FakeCalls::Call& call) { remove(world_.world, call.other); });
  const Edict trigger =
      world_.spawn({-200, 0, 100}, {{-100, -100, -100}, {100, 100, 100}}, Solid::kTrigger, MoveType::kNone);
  trigger.set(field::kTouch, taking);
  const EntityIndex hunter = monster({-200, 0, kStanding}).index();
  GameRandom random(3);
  EXPECT_TRUE(move_to_goal(world_.world, hunter, 12, random).ok());
  EXPECT_TRUE(world_.world.edicts.is_free(hunter));
  EXPECT_EQ(world_.calls.count(taking), 1);
}

}  // namespace
}  // namespace temblor::server
