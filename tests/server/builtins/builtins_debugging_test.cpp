// Functions with which game code prints its state, and stops itself.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/builtins/builtin_stage.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
namespace field = server::field;

TEST(DebugBuiltins, EprintShowsEveryFieldThatIsNotZero) {
  Stage stage;
  const vm::EntityIndex thing = stage.spawn();
  stage.set_text(thing, field::kClassName, "door");
  stage.edict(thing).set(field::kOrigin, math::Vec3(1, 2, 3));
  stage.edict(thing).set(field::kEnemy, Stage::kPlayer2);
  stage.edict(thing).set(field::kTouch, stage.look_up_function("spawn"));
  stage.edict(thing).set(kScoreField, 1.5f);
  stage.run("eprint", thing);
  EXPECT_EQ(stage.printed,
            "entity 3:\n"
            "  origin          '  1.0   2.0   3.0'\n"
            "  classname       \"door\"\n"
            "  enemy           entity 2\n"
            "  touch           spawn()\n"
            "  score             1.5\n");
}

TEST(DebugBuiltins, EprintSurvivesBadValues) {
  Stage stage;
  const vm::EntityIndex thing = stage.spawn();
  for (std::uint32_t& word : stage.edict(thing).words()) word = 0xfffffff0;
  stage.run("eprint", thing);
  EXPECT_THAT(stage.printed, HasSubstr("enemy           entity 4294967280"));
  EXPECT_THAT(stage.printed, HasSubstr("touch           0xfffffff0"));
}

TEST(DebugBuiltins, CoredumpShowsAllEntities) {
  Stage stage;
  stage.world.time_s = 10;
  const vm::EntityIndex thing = stage.spawn();
  stage.run("remove", thing);
  stage.run("coredump");
  for (const char* line : {"entity 0:\n", "entity 1:\n", "entity 2:\n", "entity 3: removed\n"})
    EXPECT_THAT(stage.printed, HasSubstr(line));
}

TEST(DebugBuiltins, ErrorEndsTheCall) {
  Stage stage;
  const vm::EntityIndex thing = stage.spawn();
  stage.edict(thing).set(kScoreField, 7);
  stage.set_self(thing);
  EXPECT_THAT(stage.error("error", "no ", "such thing\n"), HasSubstr("builtin error: no such thing"));
  EXPECT_THAT(stage.printed, HasSubstr("no such thing"));
  EXPECT_THAT(stage.printed, HasSubstr("score           7"));
  EXPECT_FALSE(stage.world.edicts.is_free(thing));
  EXPECT_THAT(stage.error("break"), HasSubstr("builtin break: the program stops here"));
}

TEST(DebugBuiltins, ObjerrorRemovesSelfAndContinues) {
  Stage stage;
  const vm::EntityIndex thing = stage.spawn();
  stage.set_self(thing);
  stage.run("objerror", "no target\n");
  EXPECT_TRUE(stage.world.edicts.is_free(thing));
  EXPECT_THAT(stage.printed, HasSubstr("no target"));
  for (const vm::EntityIndex lasting : {vm::kWorld, Stage::kPlayer1}) {
    stage.set_self(lasting);
    EXPECT_THAT(stage.error("objerror", "broken"), HasSubstr("builtin objerror: broken (entity"));
    EXPECT_FALSE(stage.world.edicts.is_free(lasting));
  }
}

TEST(DebugBuiltins, TraceonShowsStatementsUntilTraceoff) {
  Stage stage;
  stage.run("traceon");
  stage.printed.clear();
  stage.run("random");
  EXPECT_THAT(stage.printed, HasSubstr("CALL"));
  stage.run("traceoff");
  stage.printed.clear();
  stage.run("random");
  EXPECT_EQ(stage.printed, "");
}

}  // namespace
}  // namespace temblor::test
