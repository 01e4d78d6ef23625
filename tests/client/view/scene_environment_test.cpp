#include "client/view/scene_environment.h"

#include <gtest/gtest.h>

#include <array>

#include "formats/images/png.h"
#include "support/programs/temporary_folder.h"

namespace temblor::client {
namespace {

// A game directory with the side "rt" of two skyboxes. The other five are missing.
vfs::FileSystem open_skyboxes(const test::TemporaryFolder& folder) {
  const std::array<std::uint32_t, 1> pixel = {0xff102030};
  for (const char* name : {"dusk", "dawn"})
    folder.write(std::string("id1/gfx/env/") + name + "rt.png", formats::write_png(pixel, 1, 1).value());
  return vfs::FileSystem::open(folder.path()).value();
}

class SceneEnvironmentTest : public ::testing::Test {
 protected:
  SceneEnvironmentTest() {
    level_.entities.push_back(
        {{{"classname", "worldspawn"}, {"sky", "dusk"}, {"fog", "0.5 1 0 0"}, {"wateralpha", "0.25"}}});
    environment_.begin_level(level_);
  }
  // Applies the environment to an empty scene, and returns that and the number of notes.
  render::Scene apply(const EnvironmentSettings& settings = {}) {
    render::Scene scene;
    notes_.clear();
    environment_.apply({library_, game_, 0}, settings, notes_, scene);
    return scene;
  }

  test::TemporaryFolder folder_;
  world::Level level_;
  Game game_;
  std::vector<std::string> notes_;
  SceneEnvironment environment_;
  const assets::Library library_{open_skyboxes(folder_)};
};

TEST_F(SceneEnvironmentTest, LevelDecidesWithoutMessages) {
  const render::Scene scene = apply({.liquid_alpha = {.water = 0.75f, .lava = 0.5f}});
  EXPECT_EQ(scene.fog.density, 0.5f);
  EXPECT_EQ(scene.fog.color, math::Vec3(1, 0, 0));
  EXPECT_EQ(scene.liquid_alpha.water, 0.25f);
  EXPECT_EQ(scene.liquid_alpha.lava, 0.5f);
  ASSERT_NE(scene.skybox, nullptr);
  EXPECT_EQ(scene.skybox->sides[0].width, 1);
  EXPECT_EQ(notes_.size(), 5u) << "one for each missing side";
}

TEST_F(SceneEnvironmentTest, MessagesOfTheServerReplaceTheLevels) {
  game_.fog = net::Fog{.density = 0.125f, .color = {0, 0, 1}, .fade_s = 0};
  game_.skybox = "dawn";
  const render::Scene scene = apply();
  EXPECT_EQ(scene.fog.density, 0.125f);
  EXPECT_EQ(scene.fog.color, math::Vec3(0, 0, 1));
  EXPECT_NE(scene.skybox, nullptr);
  game_.skybox = "";
  EXPECT_EQ(apply().skybox, nullptr);
}

TEST_F(SceneEnvironmentTest, LoadsASkyboxOnlyOnce) {
  const auto identity = apply().skybox->identity;
  EXPECT_EQ(apply().skybox->identity, identity);
  EXPECT_TRUE(notes_.empty());
  game_.skybox = "dawn";
  EXPECT_NE(apply().skybox->identity, identity);
}

TEST_F(SceneEnvironmentTest, ASkyboxWithoutAnySideLeavesTheLevelsSky) {
  game_.skybox = "nowhere";
  EXPECT_EQ(apply().skybox, nullptr);
  ASSERT_EQ(notes_.size(), 1u);
  EXPECT_NE(notes_[0].find("gfx/env/nowherert.tga"), std::string::npos) << notes_[0];
  EXPECT_EQ(apply().skybox, nullptr);
  EXPECT_TRUE(notes_.empty());
  game_.skybox = "dawn";
  EXPECT_NE(apply().skybox, nullptr);
}

TEST_F(SceneEnvironmentTest, SettingsTurnOffFogAndSkybox) {
  const render::Scene scene = apply({.liquid_alpha = {}, .fog = false, .skybox = false});
  EXPECT_EQ(scene.fog.density, 0);
  EXPECT_EQ(scene.skybox, nullptr);
  EXPECT_TRUE(notes_.empty()) << "nothing is loaded";
  EXPECT_NE(apply().skybox, nullptr) << "the player turned it on again";
}

}  // namespace
}  // namespace temblor::client
