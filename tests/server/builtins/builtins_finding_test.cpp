// Searches for entities.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/builtins/builtin_stage.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using math::Vec3;
using server::Solid;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
namespace field = server::field;

std::vector<vm::EntityIndex> chain_from(Stage& io_stage, vm::EntityIndex first) {
  std::vector<vm::EntityIndex> chain;
  for (vm::EntityIndex at = first; at != vm::kWorld && chain.size() < 100;
       at = io_stage.edict(at)[field::kChain])
    chain.push_back(at);
  return chain;
}

// Five entities after the players, the third of which is removed.
class Finding : public ::testing::Test {
 protected:
  Finding() {
    stage.world.time_s = 10;
    for (vm::EntityIndex& entity : entities) entity = stage.spawn();
    stage.run("remove", entities[2]);
  }
  Stage stage;
  std::array<vm::EntityIndex, 5> entities{};
};

TEST_F(Finding, FindContinuesAfterItsStartAndSkipsTheRemoved) {
  for (const vm::EntityIndex entity : entities) stage.set_text(entity, kTagField, "door");
  stage.set_text(entities[1], kTagField, "Door");
  EXPECT_EQ(stage.entity("find", vm::kWorld, kTagField, "door"), entities[0]);
  EXPECT_EQ(stage.entity("find", entities[0], kTagField, "door"), entities[3]);
  EXPECT_EQ(stage.entity("find", entities[3], kTagField, "door"), entities[4]);
  EXPECT_EQ(stage.entity("find", entities[4], kTagField, "door"), vm::kWorld);
  EXPECT_EQ(stage.entity("find", vm::kWorld, kTagField, "do"), vm::kWorld);
  EXPECT_EQ(stage.entity("find", vm::kWorld, kTagField, ""), Stage::kPlayer1) << "empty is equal to empty";
}

TEST_F(Finding, FindfloatAndFindflags) {
  stage.edict(entities[1]).set(kScoreField, 6);
  stage.edict(entities[3]).set(kScoreField, 5);
  EXPECT_EQ(stage.entity("findfloat", vm::kWorld, kScoreField, 5), entities[3]);
  EXPECT_EQ(stage.entity("findfloat", vm::kWorld, kScoreField, 7), vm::kWorld);
  EXPECT_EQ(stage.entity("findflags", vm::kWorld, kScoreField, 2), entities[1]);
  EXPECT_EQ(stage.entity("findflags", entities[1], kScoreField, 4 + 8), entities[3]);
  EXPECT_EQ(stage.entity("findflags", vm::kWorld, kScoreField, 8), vm::kWorld);
}

TEST_F(Finding, ChainsRunFromTheLastFoundToTheFirst) {
  for (const std::size_t i : {0, 1, 2, 4}) {
    stage.set_text(entities[i], kTagField, "x");
    stage.edict(entities[i]).set(kScoreField, 1);
  }
  const auto expected = ElementsAre(entities[4], entities[1], entities[0]);
  EXPECT_THAT(chain_from(stage, stage.entity("findchain", kTagField, "x")), expected);
  EXPECT_THAT(chain_from(stage, stage.entity("findchainfloat", kScoreField, 1)), expected);
  EXPECT_EQ(stage.entity("findchain", kTagField, "y"), vm::kWorld);
}

TEST_F(Finding, NextentPassesOverTheRemoved) {
  std::vector<vm::EntityIndex> met;
  for (vm::EntityIndex at = stage.entity("nextent", vm::kWorld); at != vm::kWorld && met.size() < 100;
       at = stage.entity("nextent", at))
    met.push_back(at);
  EXPECT_THAT(
      met, ElementsAre(Stage::kPlayer1, Stage::kPlayer2, entities[0], entities[1], entities[3], entities[4]));
}

TEST_F(Finding, ABadFieldIsAnError) {
  EXPECT_THAT(stage.error("find", vm::kWorld, RawWord{kStageEntityWords}, "x"),
              HasSubstr("builtin find: parameter 2 is not a field"));
  EXPECT_THAT(stage.error("findchain", RawWord{0xffffffff}, "x"),
              HasSubstr("builtin findchain: parameter 1 is not a field"));
  EXPECT_THAT(stage.error("find", RawWord{1000}, kTagField, "x"), HasSubstr("parameter 1 is not an entity"));
}

TEST_F(Finding, FindradiusMeasuresToTheMiddleAndSkipsNonsolidEntities) {
  const auto place = [&](std::size_t i, const Vec3& origin, Solid solid) {
    stage.edict(entities[i]).set(field::kOrigin, origin);
    stage.edict(entities[i]).set(field::kSolid, static_cast<float>(solid));
  };
  place(0, {100, 0, 0}, Solid::kTrigger);
  place(1, {101, 0, 0}, Solid::kBox);
  place(3, {0, 0, 0}, Solid::kNot);
  // Its middle is 40 units from its origin.
  place(4, {130, 0, 0}, Solid::kBsp);
  stage.edict(entities[4]).set(field::kMins, Vec3(-80, 0, 0));
  EXPECT_THAT(chain_from(stage, stage.entity("findradius", Vec3(0.0f), 100)),
              ElementsAre(entities[4], entities[0]));
  EXPECT_THAT(chain_from(stage, stage.entity("findradius", Vec3(0.0f), -1)), IsEmpty());
}

TEST_F(Finding, FindradiusIsWhatAWalkOverAllEntitiesFinds) {
  Random random(11);
  for (int i = 0; i < 100; ++i) stage.spawn_box(random.in_cube(300), static_cast<Solid>(random.below(4)));
  for (int i = 0; i < 50; ++i) {
    const Vec3 center = random.in_cube(300);
    const auto radius = static_cast<float>(random.uniform(0, 400));
    std::vector<vm::EntityIndex> expected;
    for (std::size_t k = stage.world.edicts.count(); k-- > 1;) {
      const auto index = base::to_index<vm::EntityIndex>(k);
      const server::Edict edict = stage.edict(index);
      if (!stage.world.edicts.is_free(index) && edict.solid() != Solid::kNot &&
          glm::length(edict[field::kOrigin] - center) <= radius)
        expected.push_back(index);
    }
    std::vector<vm::EntityIndex> found;
    for (vm::EntityIndex at = stage.entity("findradius", center, radius); at != vm::kWorld;
         at = stage.edict(at)[field::kChain])
      found.push_back(at);
    ASSERT_EQ(found, expected);
  }
}

}  // namespace
}  // namespace temblor::test
