// Precaches: the names that a level needs before it begins.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/builtins/builtin_stage.h"

namespace temblor::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// A stage that loads every model but progs/none.mdl, and counts.
class Precaching : public ::testing::Test {
 protected:
  explicit Precaching(const net::Dialect& dialect = {}) : stage(dialect) {
    stage.context.load_model = [this](std::string_view name) -> base::Result<server::ServerModel> {
      ++loaded;
      if (name == "progs/none.mdl")
        return base::error(base::ErrorCode::kNotFound, "progs/none.mdl: not there");
      return server::ServerModel{.name = "as the loader calls it", .box = {math::Vec3(-16), math::Vec3(16)}};
    };
  }
  Stage stage;
  int loaded = 0;
};
class WidePrecaching : public Precaching {
 protected:
  WidePrecaching() : Precaching({net::Protocol::kFitzQuake, 0}) {}
};

TEST_F(Precaching, SoundsAreNumberedInOrderAndOnce) {
  EXPECT_EQ(stage.text("precache_sound", "a.wav"), "a.wav");
  stage.run("precache_sound2", "b.wav");
  stage.run("precache_sound", "a.wav");
  EXPECT_THAT(stage.precache.sounds, ElementsAre("", "a.wav", "b.wav"));
}

TEST_F(Precaching, ModelsAreLoadedOnce) {
  EXPECT_EQ(stage.text("precache_model", "progs/ogre.mdl"), "progs/ogre.mdl");
  stage.run("precache_model2", "progs/ogre.mdl");
  stage.run("precache_model", "*1");  // the level's own
  EXPECT_EQ(loaded, 1);
  ASSERT_EQ(stage.world.models.size(), 4u);
  EXPECT_EQ(stage.world.models[3].name, "progs/ogre.mdl");
}

TEST_F(Precaching, AModelThatCannotBeLoadedIsReportedAndTheLevelContinues) {
  stage.run("precache_model", "progs/none.mdl");
  EXPECT_THAT(stage.printed, HasSubstr("builtin precache_model: progs/none.mdl: not there"));
  ASSERT_EQ(stage.world.models.size(), 4u);
  EXPECT_EQ(stage.world.models[3].name, "progs/none.mdl");
  EXPECT_EQ(stage.world.models[3].box.maxs, math::Vec3(16.0f));
}

TEST_F(Precaching, FilesAreNamedOnly) {
  EXPECT_EQ(stage.text("precache_file", "maps/end.bsp"), "maps/end.bsp");
  EXPECT_EQ(stage.text("precache_file2", "maps/end.bsp"), "maps/end.bsp");
  EXPECT_EQ(loaded, 0);
}

TEST_F(Precaching, OnlyWhileTheLevelIsSetUp) {
  stage.precache.is_open = false;
  EXPECT_THAT(stage.error("precache_sound", "a.wav"),
              HasSubstr("builtin precache_sound: \"a.wav\" is precached too late"));
  EXPECT_THAT(stage.error("precache_model", "progs/a.mdl"), HasSubstr("is precached too late"));
  stage.run("precache_file", "a.lmp");
}

TEST_F(Precaching, EmptyNamesAreRefused) {
  EXPECT_THAT(stage.error("precache_sound", ""),
              HasSubstr("builtin precache_sound: \"\" is not a file name"));
  EXPECT_THAT(stage.error("precache_model", " x"),
              HasSubstr("builtin precache_model: \" x\" is not a file name"));
}

TEST_F(Precaching, Protocol15Numbers255) {
  for (int i = 1; i <= 255; ++i) stage.run("precache_sound", fmt::format("s{}", i));
  EXPECT_THAT(stage.error("precache_sound", "more"),
              HasSubstr("\"more\" is one too many: protocol 15 allows 255"));
  stage.run("precache_sound", "s255");
  for (int i = 3; i <= 255; ++i) stage.run("precache_model", fmt::format("m{}", i));
  EXPECT_THAT(stage.error("precache_model", "more"), HasSubstr("protocol 15 allows 255"));
}

TEST_F(WidePrecaching, Protocol666NumbersMore) {
  for (int i = 1; i < net::kMaxSounds; ++i) stage.run("precache_sound", fmt::format("s{}", i));
  EXPECT_THAT(stage.error("precache_sound", "more"), HasSubstr("protocol 666 allows 2047"));
}

}  // namespace
}  // namespace temblor::test
