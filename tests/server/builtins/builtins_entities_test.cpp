// Entities are made, placed, shaped, copied and removed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "server/builtins/builtin_stage.h"

namespace temblor::test {
namespace {

using math::Vec3;
using server::Solid;
using ::testing::HasSubstr;
namespace field = server::field;

TEST(EntityBuiltins, SpawnGivesAnEntityOfZeros) {
  Stage stage;
  const vm::EntityIndex made = stage.entity("spawn");
  EXPECT_EQ(made, vm::EntityIndex{3}) << "after the players";
  for (const std::uint32_t word : stage.edict(made).words()) ASSERT_EQ(word, 0u);
}

TEST(EntityBuiltins, RemoveFreesAPlaceForLater) {
  Stage stage;
  stage.world.time_s = 10;
  const vm::EntityIndex made = stage.entity("spawn");
  stage.run("remove", made);
  EXPECT_TRUE(stage.world.edicts.is_free(made));
  stage.run("remove", made);
  EXPECT_NE(stage.entity("spawn"), made) << "not within half a second";
  stage.world.time_s = 11;
  EXPECT_EQ(stage.entity("spawn"), made);
}

TEST(EntityBuiltins, TheWorldAndPlayersStay) {
  Stage stage;
  EXPECT_THAT(stage.error("remove", vm::kWorld), HasSubstr("builtin remove: the world cannot be removed"));
  EXPECT_THAT(stage.error("remove", Stage::kPlayer2),
              HasSubstr("builtin remove: entity 2 is a player's and cannot be removed"));
  EXPECT_THAT(stage.error("makestatic", Stage::kPlayer1),
              HasSubstr("builtin makestatic: entity 1 is a player's"));
  EXPECT_FALSE(stage.world.edicts.is_free(Stage::kPlayer2));
}

TEST(EntityBuiltins, ABadEntityIsAnErrorThatNamesTheParameter) {
  Stage stage;
  EXPECT_THAT(stage.error("setorigin", RawWord{77}, kHall),
              HasSubstr("builtin setorigin: parameter 1 is not an entity"));
  EXPECT_THAT(stage.error("copyentity", vm::kWorld, RawWord{0xffffffff}),
              HasSubstr("builtin copyentity: parameter 2 is not an entity"));
}

TEST(EntityBuiltins, SetoriginMovesAndLinksWithoutTouching) {
  Stage stage;
  const vm::EntityIndex trigger = stage.spawn_box(kHall, Solid::kTrigger);
  stage.edict(trigger).set(field::kTouch, vm::FunctionIndex{1});
  const vm::EntityIndex thing = stage.spawn_box({400, 300, 64}, Solid::kBox);
  stage.run("setorigin", thing, kHall);
  EXPECT_EQ(stage.edict(thing)[field::kOrigin], kHall);
  // Expanded by one unit on each side.
  EXPECT_EQ(stage.edict(thing)[field::kAbsMin], kHall - 17.0f);
  EXPECT_EQ(stage.edict(thing)[field::kAbsMax], kHall + 17.0f);
  EXPECT_TRUE(stage.calls.noted.empty());
  std::vector<vm::EntityIndex> found;
  stage.world.areas.find({kHall, kHall}, server::AreaKind::kSolid, found);
  EXPECT_THAT(found, testing::ElementsAre(thing));
}

TEST(EntityBuiltins, SetsizeSetsThreeFields) {
  Stage stage;
  const vm::EntityIndex thing = stage.spawn_box(kHall, Solid::kBox);
  stage.run("setsize", thing, Vec3(-1, -2, -3), Vec3(4, 5, 6));
  EXPECT_EQ(stage.edict(thing)[field::kMins], Vec3(-1, -2, -3));
  EXPECT_EQ(stage.edict(thing)[field::kMaxs], Vec3(4, 5, 6));
  EXPECT_EQ(stage.edict(thing)[field::kSize], Vec3(5, 7, 9));
  EXPECT_EQ(stage.edict(thing)[field::kAbsMax], kHall + Vec3(5, 6, 7));
  EXPECT_THAT(stage.error("setsize", thing, Vec3(0, 0, 1), Vec3(0.0f)),
              HasSubstr("builtin setsize: the box from (0 0 1) to (0 0 0) has mins above maxs in z"));
}

TEST(EntityBuiltins, SetmodelTakesNumberAndBoxOfAPrecachedModel) {
  Stage stage;
  stage.world.models.push_back({.name = "progs/ogre.mdl", .box = {Vec3(-16), Vec3(16)}});
  const vm::EntityIndex thing = stage.spawn();
  stage.run("setmodel", thing, "progs/ogre.mdl");
  EXPECT_EQ(stage.edict(thing)[field::kModelIndex], 3);
  EXPECT_EQ(stage.machine.text(stage.edict(thing)[field::kModel]), "progs/ogre.mdl");
  EXPECT_EQ(stage.edict(thing)[field::kSize], Vec3(32));
  stage.run("setmodel", thing, "*1");
  EXPECT_EQ(stage.edict(thing)[field::kModelIndex], 2);
  EXPECT_EQ(stage.edict(thing)[field::kMins], stage.world.level->models[1].bounds.mins);
  stage.run("setmodel", thing, "");
  EXPECT_EQ(stage.edict(thing)[field::kModelIndex], 0);
  EXPECT_EQ(stage.edict(thing)[field::kSize], Vec3(0.0f));
  EXPECT_THAT(stage.error("setmodel", thing, "progs/dog.mdl"),
              HasSubstr("builtin setmodel: \"progs/dog.mdl\" was not precached"));
}

TEST(EntityBuiltins, SetmodelMakesAPointWithoutTheLevelsBrushModel) {
  Stage stage;
  const vm::EntityIndex thing = stage.spawn();
  stage.run("setmodel", thing, "*1");
  stage.run("setmodel", thing, "*99");
  EXPECT_EQ(stage.edict(thing)[field::kModelIndex], 0);
  EXPECT_EQ(stage.edict(thing)[field::kSize], Vec3(0.0f));
  EXPECT_EQ(stage.printed, "builtin setmodel: the level has no brush model \"*99\"\n");
}

TEST(EntityBuiltins, MakestaticIsSentToJoiningClients) {
  Stage stage({net::Protocol::kFitzQuake, 0});
  const vm::EntityIndex torch = stage.spawn_box(kHall, Solid::kBox);
  const server::Edict edict = stage.edict(torch);
  edict.set(field::kModelIndex, 2);
  edict.set(field::kFrame, 3);
  edict.set(field::kSkin, 1);
  edict.set(field::kColorMap, 4);
  edict.set(field::kAngles, Vec3(0, 90, 0));
  edict.set(kAlphaField, 0.5f);
  stage.run("makestatic", torch);
  EXPECT_TRUE(stage.world.edicts.is_free(torch));
  const auto sent = messages_in<net::SpawnStatic>(stage.outbox.signon().view(), stage.outbox.dialect());
  ASSERT_EQ(sent.size(), 1u);
  const net::Baseline& begun = sent[0].entity;
  EXPECT_EQ(begun.model, 2);
  EXPECT_EQ(begun.frame, 3);
  EXPECT_EQ(begun.skin, 1);
  EXPECT_EQ(begun.colormap, 4);
  EXPECT_EQ(begun.origin, kHall);
  EXPECT_EQ(begun.angles_deg, Vec3(0, 90, 0));
  EXPECT_NEAR(begun.alpha, 0.5f, 0.01f);
  std::vector<vm::EntityIndex> found;
  stage.world.areas.find({kHall, kHall}, server::AreaKind::kSolid, found);
  EXPECT_THAT(found, testing::IsEmpty());
}

TEST(EntityBuiltins, MakestaticOfNonsenseIsDropped) {
  Stage stage;
  const vm::EntityIndex thing = stage.spawn();
  for (const auto number : {field::kModelIndex, field::kFrame, field::kSkin})
    stage.edict(thing).set(number, std::numeric_limits<float>::quiet_NaN());
  stage.edict(thing).set(field::kOrigin, Vec3(std::numeric_limits<float>::infinity()));
  stage.run("makestatic", thing);
  EXPECT_EQ(stage.outbox.signon().size(), 0u);
  EXPECT_EQ(stage.outbox.dropped(), 1u);
}

TEST(EntityBuiltins, CopyentityCopiesAllFieldsAndLinks) {
  Stage stage;
  const vm::EntityIndex from = stage.spawn_box(kHall, Solid::kBox), to = stage.spawn();
  stage.edict(from).set(kScoreField, 12);
  stage.run("copyentity", from, to);
  EXPECT_EQ(stage.edict(to)[kScoreField], 12);
  EXPECT_EQ(stage.edict(to)[field::kOrigin], kHall);
  std::vector<vm::EntityIndex> found;
  stage.world.areas.find({kHall, kHall}, server::AreaKind::kSolid, found);
  EXPECT_THAT(found, testing::UnorderedElementsAre(from, to));
  EXPECT_THAT(stage.error("copyentity", from, vm::kWorld),
              HasSubstr("builtin copyentity: nothing can be copied"));
  stage.run("remove", to);
  EXPECT_THAT(stage.error("copyentity", from, to), HasSubstr("was removed"));
}

// The number of a field of the stage's program.
int find_field_number(Stage& io_stage, std::string_view name) {
  const int count = static_cast<int>(io_stage.number("numentityfields"));
  for (int i = 0; i < count; ++i)
    if (io_stage.text("entityfieldname", i) == name) return i;
  return -1;
}

TEST(EntityBuiltins, FieldsAreReadAndSetAsText) {
  Stage stage;
  const vm::EntityIndex thing = stage.spawn();
  const auto round_trip = [&](std::string_view name, std::string_view text) {
    const int number = find_field_number(stage, name);
    EXPECT_EQ(stage.number("putentityfieldstring", number, thing, text), 1) << name;
    return stage.text("getentityfieldstring", number, thing);
  };
  EXPECT_EQ(round_trip("score", "1.5"), "1.5");
  EXPECT_EQ(round_trip("origin", "1 -2 3.25"), "1 -2 3.25");
  EXPECT_EQ(round_trip("tag", "two \"words\"\n"), "two \"words\"\n");
  EXPECT_EQ(stage.edict(thing)[kScoreField], 1.5f);
  EXPECT_EQ(stage.edict(thing)[field::kOrigin], Vec3(1, -2, 3.25f));
}

TEST(EntityBuiltins, FieldsAsTextSurviveWrongNumbersTextsAndEntities) {
  Stage stage;
  const vm::EntityIndex thing = stage.spawn();
  for (const float number : {-1.0f, 1e9f}) {
    EXPECT_EQ(stage.text("getentityfieldstring", number, thing), "") << number;
    EXPECT_EQ(stage.number("putentityfieldstring", number, thing, "1"), 0) << number;
  }
  const int touch = find_field_number(stage, "touch");
  EXPECT_EQ(stage.number("putentityfieldstring", touch, thing, "no_such_function"), 0);
  EXPECT_THAT(stage.error("getentityfieldstring", 0, RawWord{99}), HasSubstr("parameter 2 is not an entity"));
  stage.run("remove", thing);
  EXPECT_THAT(stage.error("putentityfieldstring", 0, thing, "1"), HasSubstr("was removed"));
}

}  // namespace
}  // namespace temblor::test
