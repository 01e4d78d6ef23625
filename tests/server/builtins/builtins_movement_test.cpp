// Physics on request: the right entity moves, and game code gets the result.
#include <gtest/gtest.h>

#include "server/builtins/builtin_stage.h"

namespace temblor::test {
namespace {

using math::Vec3;
using server::Solid;
namespace field = server::field;

class Movement : public ::testing::Test {
 protected:
  Movement() {
    monster = stage.spawn_box(kHall, Solid::kSlideBox);
    edict().set(field::kMins, Vec3(-16, -16, -24));
    edict().set(field::kMaxs, Vec3(16, 16, 32));
    edict().set(field::kMoveType, static_cast<float>(server::MoveType::kStep));
    stage.set_self(monster);
  }
  server::Edict edict() { return stage.edict(monster); }

  Stage stage;
  vm::EntityIndex monster{};
};

TEST_F(Movement, DroptofloorPutsSelfOnTheFloor) {
  EXPECT_EQ(stage.number("droptofloor"), 1);
  EXPECT_NEAR(edict()[field::kOrigin].z, 24, 0.1);
  EXPECT_TRUE(edict().has_flag(server::flag::kOnGround));
  EXPECT_EQ(edict()[field::kGroundEntity], vm::kWorld);
}

TEST_F(Movement, DroptofloorLooks256Down) {
  edict().set(field::kOrigin, Vec3(1000, 500, 300));  // over the court's floor at -128
  EXPECT_EQ(stage.number("droptofloor"), 0);
  EXPECT_EQ(edict()[field::kOrigin], Vec3(1000, 500, 300));
}

TEST_F(Movement, WalkmoveStepsOnlyFromTheGround) {
  EXPECT_EQ(stage.number("walkmove", 0, 8), 0) << "in the air";
  stage.run("droptofloor");
  EXPECT_EQ(stage.number("walkmove", 90, 8), 1);
  EXPECT_NEAR(edict()[field::kOrigin].y, kHall.y + 8, 1e-3);
  EXPECT_EQ(stage.number("walkmove", 0, 5000), 0) << "through the wall";
  EXPECT_EQ(stage.machine.global_entity(server::global::kSelf), monster);
}

TEST_F(Movement, CheckbottomOfAnyEntity) {
  stage.run("droptofloor");
  stage.set_self(vm::kWorld);
  EXPECT_EQ(stage.number("checkbottom", monster), 1);
  edict().set(field::kOrigin, kHall);
  EXPECT_EQ(stage.number("checkbottom", monster), 0);
}

TEST_F(Movement, ChangeYawTurnsByYawSpeed) {
  edict().set(field::kIdealYaw, 90);
  edict().set(field::kYawSpeed, 20);
  stage.run("ChangeYaw");
  EXPECT_NEAR(edict()[field::kAngles].y, 20, 0.01);
}

TEST_F(Movement, MovetogoalWalksTowardsTheGoal) {
  stage.run("droptofloor");
  const vm::EntityIndex goal = stage.spawn_box({456, 256, 24}, Solid::kTrigger, 4);
  edict().set(field::kGoalEntity, goal);
  edict().set(field::kYawSpeed, 360);
  const float before = glm::distance(edict()[field::kOrigin], Vec3(456, 256, 24));
  for (int i = 0; i < 12; ++i) stage.run("movetogoal", 8);
  EXPECT_LT(glm::distance(edict()[field::kOrigin], Vec3(456, 256, 24)), before - 40);
}

}  // namespace
}  // namespace temblor::test
