// Traces, visibility, and aiming. The small level's hall is open from 0 to 512 in x and y and to 192 in
// z, with a pillar at (96..128, 96..128); its pool holds water below -144.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "server/builtins/builtin_stage.h"
#include "world/visibility.h"

namespace temblor::test {
namespace {

using math::Vec3;
using server::Solid;
using ::testing::HasSubstr;
namespace field = server::field;
namespace global = server::global;

constexpr Vec3 kFrom(256, 256, 64);

TEST(TraceBuiltins, TracelineReportsWhatItMet) {
  Stage stage;
  stage.run("traceline", kFrom, Vec3(256, 256, -64), 0, vm::kWorld);
  EXPECT_EQ(stage.machine.global_float(global::kTraceFraction), (64 - 1 / 32.0f) / 128);
  EXPECT_EQ(stage.machine.global_vector(global::kTraceEnd), Vec3(256, 256, 1 / 32.0f));
  EXPECT_EQ(stage.machine.global_vector(global::kTracePlaneNormal), Vec3(0, 0, 1));
  EXPECT_EQ(stage.machine.global_float(global::kTracePlaneDistance), 0);
  EXPECT_EQ(stage.machine.global_entity(global::kTraceEntity), vm::kWorld);
  EXPECT_EQ(stage.machine.global_float(global::kTraceInOpen), 1);
  EXPECT_EQ(stage.machine.global_float(global::kTraceInWater), 0);
  EXPECT_EQ(stage.machine.global_float(global::kTraceAllSolid), 0);
  EXPECT_EQ(stage.machine.global_float(global::kTraceStartSolid), 0);
}

TEST(TraceBuiltins, TracelineKindsAndOwnPassing) {
  Stage stage;
  const vm::EntityIndex monster = stage.spawn_box({356, 256, 64}, Solid::kSlideBox);
  const auto met = [&](int kind, vm::EntityIndex passing) {
    stage.run("traceline", kFrom, Vec3(456, 256, 64), kind, passing);
    return std::pair(stage.machine.global_entity(global::kTraceEntity),
                     stage.machine.global_float(global::kTraceFraction));
  };
  EXPECT_EQ(met(0, Stage::kPlayer1).first, monster);
  EXPECT_LT(met(0, Stage::kPlayer1).second, 0.42f);
  EXPECT_EQ(met(1, Stage::kPlayer1), std::pair(vm::kWorld, 1.0f));
  EXPECT_EQ(met(0, vm::kWorld), std::pair(vm::kWorld, 1.0f))
      << "the world passes through entities without an owner";
  EXPECT_EQ(met(0, monster), std::pair(vm::kWorld, 1.0f));
  // 25 units from a monster's middle: a missile's box meets it, a line does not.
  stage.edict(monster).set_flag(server::flag::kMonster);
  stage.run("setorigin", monster, Vec3(356, 281, 64));
  EXPECT_EQ(met(0, Stage::kPlayer1).first, vm::kWorld);
  EXPECT_EQ(met(2, Stage::kPlayer1).first, monster);
}

TEST(TraceBuiltins, TraceboxIsAsWideAsItsBox) {
  Stage stage;
  // Past the pillar, 20 units from its side.
  const Vec3 from(48, 148, 64), to(256, 148, 64);
  stage.run("traceline", from, to, 0, vm::kWorld);
  EXPECT_EQ(stage.machine.global_float(global::kTraceFraction), 1);
  stage.run("tracebox", from, Vec3(-32, -32, -24), Vec3(32, 32, 64), to, 0, vm::kWorld);
  EXPECT_LT(stage.machine.global_float(global::kTraceFraction), 0.1f);
  EXPECT_THAT(stage.error("tracebox", from, from, from, to, 0, RawWord{99}),
              HasSubstr("builtin tracebox: parameter 6 is not an entity"));
}

TEST(TraceBuiltins, Pointcontents) {
  Stage stage;
  EXPECT_EQ(stage.number("pointcontents", kFrom), -1);
  EXPECT_EQ(stage.number("pointcontents", Vec3(256, 256, -64)), -2);
  EXPECT_EQ(stage.number("pointcontents", Vec3(1200, 200, -200)), -3);
  EXPECT_EQ(stage.number("pointcontents", Vec3(1000, 300, 400)), -6);
}

// Players whose eyes are at their origins.
class Checking : public ::testing::Test {
 protected:
  Checking() {
    stage.world.time_s = 5;
    for (const vm::EntityIndex player : {Stage::kPlayer1, Stage::kPlayer2}) {
      stage.edict(player).set(field::kOrigin, kFrom);
      stage.edict(player).set(field::kHealth, 100);
    }
    monster = stage.spawn();
    stage.edict(monster).set(field::kOrigin, Vec3(300, 256, 64));
    stage.set_self(monster);
  }
  vm::EntityIndex check() { return stage.entity("checkclient"); }

  Stage stage;
  vm::EntityIndex monster{};
};

TEST_F(Checking, PlayersTakeTurnsOfATenthOfASecond) {
  const vm::EntityIndex first = check();
  const vm::EntityIndex second = first == Stage::kPlayer1 ? Stage::kPlayer2 : Stage::kPlayer1;
  EXPECT_NE(first, vm::kWorld);
  stage.world.time_s = 5.09;
  EXPECT_EQ(check(), first);
  stage.world.time_s = 5.11;
  EXPECT_EQ(check(), second);
  stage.world.time_s = 5.22;
  EXPECT_EQ(check(), first);
}

TEST_F(Checking, TheDeadAndUnnoticedAreSkippedIfThereAreOthers) {
  stage.edict(Stage::kPlayer1).set(field::kHealth, 0);
  for (int i = 0; i < 4; ++i, stage.world.time_s += 0.2) EXPECT_EQ(check(), Stage::kPlayer2);
  stage.edict(Stage::kPlayer1).set(field::kHealth, 100);
  stage.edict(Stage::kPlayer1).set_flag(server::flag::kNoTarget);
  for (int i = 0; i < 4; ++i, stage.world.time_s += 0.2) EXPECT_EQ(check(), Stage::kPlayer2);
}

TEST_F(Checking, ADeadPlayerIsNotFoundAnyMore) {
  const vm::EntityIndex first = check();
  stage.edict(first).set(field::kHealth, 0);
  EXPECT_EQ(check(), vm::kWorld);
}

// The same level, with a PVS in which every leaf sees one leaf only.
std::shared_ptr<const world::Level> level_that_sees(const world::Level& level, world::LeafIndex seen) {
  auto blind = std::make_shared<world::Level>(level);
  const std::size_t bit = base::to_size(seen) - 1, bytes = (blind->visible_leaf_count + 7) / 8;
  blind->visibility.clear();
  for (std::size_t i = 0; i < bytes; ++i) {
    const auto byte = static_cast<std::uint8_t>(i == bit / 8 ? 1 << bit % 8 : 0);
    blind->visibility.push_back(byte);
    if (byte == 0) blind->visibility.push_back(1);  // one byte of zeros
  }
  for (world::Leaf& leaf : blind->leaves) leaf.visibility_offset = 0;
  return blind;
}

TEST(TraceBuiltins, CheckpvsFindsWhetherAnEntityMayBeSeen) {
  Stage stage;
  const Vec3 cellar(432, 1000, 40);
  const vm::EntityIndex thing = stage.spawn_box(cellar, Solid::kSlideBox, 4);
  stage.world.level = level_that_sees(*stage.world.level, world::find_leaf(*stage.world.level, cellar));
  for (const int model : {0, 1}) {
    SCOPED_TRACE(model);
    stage.edict(thing).set(field::kModelIndex, static_cast<float>(model));
    stage.run("setorigin", thing, cellar);
    EXPECT_EQ(stage.number("checkpvs", kFrom, thing), 1);
    stage.run("setorigin", thing, kFrom);
    EXPECT_EQ(stage.number("checkpvs", kFrom, thing), 0);
  }
  EXPECT_THAT(stage.error("checkpvs", kFrom, RawWord{99}), HasSubstr("parameter 2 is not an entity"));
}

TEST_F(Checking, OnlyFromWhereThePlayerSees) {
  const Vec3 cellar(432, 1000, 40), court(1000, 500, 0);
  stage.world.level = level_that_sees(*stage.world.level, world::find_leaf(*stage.world.level, cellar));
  EXPECT_EQ(check(), vm::kWorld) << "the hall is not the cellar";
  stage.edict(monster).set(field::kOrigin, court);
  EXPECT_EQ(check(), vm::kWorld);
  // The viewer's eye counts, not its origin.
  stage.edict(monster).set(field::kViewOffset, cellar - court);
  EXPECT_NE(check(), vm::kWorld);
  stage.edict(monster).set(field::kOrigin, Vec3(256, 256, -500));
  stage.edict(monster).set(field::kViewOffset, Vec3(0.0f));
  EXPECT_EQ(check(), vm::kWorld) << "nobody is visible from solid";
}

// A player at kFrom looking along +x.
class Aiming : public ::testing::Test {
 protected:
  Aiming() {
    stage.edict(Stage::kPlayer1).set(field::kOrigin, kFrom);
    stage.run("makevectors", Vec3(0.0f));
  }
  vm::EntityIndex target(const Vec3& origin) {
    const vm::EntityIndex made = stage.spawn_box(origin, Solid::kSlideBox, 8);
    stage.edict(made).set(field::kTakeDamage, 2);
    return made;
  }
  Vec3 aim() { return stage.vector("aim", Stage::kPlayer1, 1000); }

  Stage stage;
};

TEST_F(Aiming, StraightAheadWhereNobodyIs) {
  EXPECT_EQ(aim(), Vec3(1, 0, 0));
}

TEST_F(Aiming, UpAndDownButNotAside) {
  // 50 up at a distance of 200: a cosine of 0.97, and more from the shot's start 20 units up.
  const vm::EntityIndex made = target(kFrom + Vec3(200, 0, 50));
  const Vec3 expected = glm::normalize(Vec3(200, 0, 50));
  EXPECT_LT(glm::distance(aim(), expected), 1e-5f);
  stage.run("setorigin", made, kFrom + Vec3(200, 40, 50));
  EXPECT_LT(glm::distance(aim(), expected), 1e-5f);
}

TEST_F(Aiming, OnlyWithinSvAim) {
  target(kFrom + Vec3(100, 60, 20));  // a cosine of 0.857
  EXPECT_EQ(aim(), Vec3(1, 0, 0));
  stage.variables.add_float("sv_aim", 0.93, 0, 2, "Cosine of the largest aiming angle.");
  EXPECT_EQ(aim(), Vec3(1, 0, 0));
  ASSERT_TRUE(stage.variables.set("sv_aim", "0.8").ok());
  EXPECT_LT(glm::distance(aim(), glm::normalize(Vec3(100, 0, 20))), 1e-5f);
}

TEST_F(Aiming, NotThroughWallsNorAtEntitiesWithoutAimedDamage) {
  const vm::EntityIndex made = target(kFrom + Vec3(200, 0, 50));
  stage.edict(made).set(field::kTakeDamage, 1);
  EXPECT_EQ(aim(), Vec3(1, 0, 0));
  stage.edict(made).set(field::kTakeDamage, 2);
  stage.spawn_box(kFrom + Vec3(100, 0, 34), Solid::kBox, 8);  // between them, over the straight line
  EXPECT_EQ(aim(), Vec3(1, 0, 0));
}

TEST_F(Aiming, NotAtTheOwnTeamInTeamPlay) {
  const vm::EntityIndex made = target(kFrom + Vec3(200, 0, 50));
  for (const vm::EntityIndex of_team : {made, Stage::kPlayer1}) stage.edict(of_team).set(field::kTeam, 5);
  EXPECT_NE(aim(), Vec3(1, 0, 0)) << "without teamplay";
  stage.variables.add_int("teamplay", 1, 0, 3, "Teams.");
  EXPECT_EQ(aim(), Vec3(1, 0, 0));
  stage.edict(made).set(field::kTeam, 6);
  EXPECT_NE(aim(), Vec3(1, 0, 0));
}

TEST_F(Aiming, TheOneInTheMiddleWins) {
  target(kFrom + Vec3(200, 0, 60));
  target(kFrom + Vec3(200, 0, 40));
  target(kFrom + Vec3(200, 50, 20));
  EXPECT_LT(glm::distance(aim(), glm::normalize(Vec3(200, 0, 40))), 1e-5f);
}

}  // namespace
}  // namespace temblor::test
