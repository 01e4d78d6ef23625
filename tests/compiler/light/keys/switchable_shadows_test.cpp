// Shadows that the game can switch off: the light behind them has a style of its own.
#include <gtest/gtest.h>

#include <optional>

#include "compiler/light/keys/key_room.h"
#include "compiler/light/lighting.h"
#include "compiler/light/sources/switchable_styles.h"

namespace temblor::test {
namespace {

using formats::Entity;
using math::Vec3d;

const std::string kPlate = box_entity("'_switchableshadow' '1'", {-32, -32, 100}, {32, 32, 108});

TEST(SwitchableShadows, LightBehindThemHasTheirStyle) {
  const auto open = lit_map(key_room(lamp())), level = lit_map(key_room(lamp() + kPlate));
  int dark = 0, bright = 0;
  for (int x = -112; x <= 112; x += 16)
    for (int y = -112; y <= 112; y += 16) {
      const Vec3d place(x, y, 0);
      const double always = light_at(*level, place), switched = light_at(*level, place, 32);
      ASSERT_NEAR(always + switched, light_at(*open, place), 1) << x << " " << y;
      // The plate is 64 units wide, 132 below the lamp at its lower side.
      const double half = 32 * kLampHeight / (kLampHeight - 100),
                   edge = std::max(std::abs(x), std::abs(y)) - half;
      if (std::abs(edge) < 24) continue;
      ++(edge < 0 ? dark : bright);
      ASSERT_EQ(edge < 0 ? always : switched, 0) << x << " " << y;
    }
  EXPECT_GE(dark, 9);
  EXPECT_GT(bright, 50);
}

TEST(SwitchableShadows, LightOfOtherStylesPasses) {
  const auto level = lit_map(key_room(lamp("'style' '5'") + kPlate));
  EXPECT_NEAR(light_at(*level, Vec3d(0.0), 5), find_lamp_light(Vec3d(0.0)), 1);
  EXPECT_EQ(light_at(*level, Vec3d(0.0), 32), 0);
}

TEST(SwitchableShadows, SunIsSwitchedToo) {
  const std::string text = entity_text("worldspawn", "\"_sunlight\" \"200\"",
                                       walls_text({-128, -128, 0}, {128, 128, 272}, "stone") +
                                           box_text({-128, -128, 256}, {128, 128, 272}, "sky1")) +
                           point_text("info_player_start", {-100, -100, 40}) +
                           entity_text("func_wall", "\"_switchableshadow\" \"1\"",
                                       box_text({-32, -32, 100}, {32, 32, 108}, "wood"));
  const auto level = lit_map(text);
  EXPECT_EQ(light_at(*level, Vec3d(0.0)), 0);
  EXPECT_EQ(light_at(*level, Vec3d(0.0), 32), 100);
  EXPECT_EQ(light_at(*level, Vec3d(96, 0, 0)), 100);
  EXPECT_EQ(light_at(*level, Vec3d(96, 0, 0), 32), 0);
}

// Brushes of the world share the style of a light or of a brush entity.
class SwitchableWorldShadows : public testing::TestWithParam<const char*> {};

TEST_P(SwitchableWorldShadows, ShareTheStyleOfAName) {
  const auto detail = [](std::string_view keys) {
    return box_entity(keys, {-32, -32, 100}, {32, 32, 108}, "wood", GetParam());
  };
  const auto open = lit_map(key_room(lamp()));
  const Vec3d below(0, 0, 0);
  const std::string other_lamp =
      "{ 'classname' 'light' 'origin' '120 120 8' 'light' '8' 'targetname' 'lamp' }";
  const auto with_lamp = lit_map(key_room(lamp() + other_lamp + detail("'_switchableshadow_target' 'lamp'")));
  EXPECT_EQ(light_at(*with_lamp, below), 0);
  EXPECT_NEAR(light_at(*with_lamp, below, 32), light_at(*open, below), 1);
  const std::string wall =
      box_entity("'_switchableshadow' '1' 'targetname' 'wall'", {96, 96, 100}, {112, 112, 108});
  const auto with_wall =
      lit_map(key_room(lamp() + wall + detail("'_switchableshadow' '1' 'targetname' 'wall'")));
  EXPECT_EQ(light_at(*with_wall, below), 0);
  EXPECT_NEAR(light_at(*with_wall, below, 32), light_at(*open, below), 1);
  // Without anything that game code could switch, the shadow is an ordinary one.
  for (const char* keys : {"'_switchableshadow' '1'", "'_switchableshadow_target' 'nothing'",
                           "'_switchableshadow' '1' 'targetname' 'lamp'"}) {
    const auto level = lit_map(key_room(lamp() + other_lamp + detail(keys)));
    EXPECT_EQ(light_at(*level, below), 0) << keys;
    EXPECT_EQ(light_at(*level, below, 32), 0) << keys;
    EXPECT_EQ(light_at(*level, below, 33), 0) << keys;
  }
}

INSTANTIATE_TEST_SUITE_P(Classes, SwitchableWorldShadows, testing::Values("func_detail", "func_group"));

// A wall of structural brushes hides the lamp from the PVS, but not its switched light.
TEST(SwitchableShadows, PassVisibilityOfGroups) {
  const auto lit_behind = [](std::string_view keys) {
    const std::string wall = box_entity(keys, {-16, -128, 0}, {16, 128, 256}, "wood", "func_group");
    const std::string lamp_text =
        "{ 'classname' 'light' 'origin' '64 0 128' 'light' '300' 'targetname' 'lamp' }";
    const std::string player = point_text("info_player_start", {-100, -100, 40});
    const auto level = lit_map(key_room(lamp_text + player + wall));
    EXPECT_FALSE(level->visibility.empty());
    return light_at(*level, Vec3d(-64, 0, 0), 32) + light_at(*level, Vec3d(-64, 0, 0), 33);
  };
  EXPECT_EQ(lit_behind(""), 0);
  EXPECT_GT(lit_behind("'_switchableshadow_target' 'lamp'"), 30);
}

// Both would have to be off for light to pass, which no sum of styles can express.
TEST(SwitchableShadows, BehindTwoOfDifferentStylesItIsDark) {
  const std::string lower = box_entity("'_switchableshadow' '1'", {-64, -32, 60}, {32, 32, 68});
  const auto level = lit_map(key_room(lamp() + kPlate + lower));
  for (const std::uint8_t style : std::initializer_list<std::uint8_t>{0, 32, 33})
    EXPECT_EQ(light_at(*level, Vec3d(0.0), style), 0) << style;
  const Vec3d behind_lower(-64, 0, 0);
  EXPECT_NEAR(light_at(*level, behind_lower, 33), find_lamp_light(behind_lower), 1);
}

TEST(SwitchableShadows, StylesBelongToNames) {
  std::vector<Entity> entities;
  const auto add = [&](std::vector<std::pair<std::string, std::string>> pairs) {
    entities.push_back({std::move(pairs)});
  };
  add({{"classname", "func_wall"}, {"model", "*1"}, {"_switchableshadow", "1"}});
  add({{"classname", "light"}, {"targetname", "lamp"}});
  add({{"classname", "func_wall"}, {"model", "*2"}, {"_switchableshadow", "1"}, {"targetname", "lamp"}});
  add({{"classname", "func_door"}, {"model", "*3"}, {"_switchableshadow", "1"}, {"targetname", "lamp"}});
  add({{"classname", "func_door"}, {"model", "*4"}, {"_switchableshadow_target", "lamp"}});
  add({{"classname", "func_door"}, {"model", "*5"}, {"_switchableshadow", "0"}});
  add({{"classname", "func_group"}, {"_switchableshadow", "1"}});
  compiler::Warnings warnings;
  EXPECT_TRUE(compiler::assign_switchable_styles(entities, warnings));
  EXPECT_FALSE(compiler::assign_switchable_styles(entities, warnings));
  EXPECT_TRUE(warnings.empty());
  EXPECT_EQ(entities[1].find("style"), "32");
  const std::vector<std::optional<std::string>> expected{"33", {}, "34", "34", "32", {}, {}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const auto style = entities[i].find("switchshadstyle");
    EXPECT_EQ(style ? std::optional(std::string(*style)) : std::nullopt, expected[i]) << i;
  }
}

TEST(SwitchableShadows, StylesHaveBounds) {
  std::vector<Entity> entities{
      {{{"classname", "worldspawn"}, {"_compilerstyle_start", "20"}, {"_compilerstyle_max", "22"}}}};
  for (const char* name : {"a", "b", "c"})
    entities.push_back({{{"classname", "light"}, {"targetname", name}, {"style", "3"}}});
  entities.push_back({{{"classname", "func_wall"}, {"model", "*1"}, {"_switchableshadow", "1"}}});
  compiler::Warnings warnings;
  compiler::assign_switchable_styles(entities, warnings);
  EXPECT_EQ(entities[1].find("style"), "20");
  EXPECT_EQ(entities[2].find("style"), "21");
  EXPECT_EQ(entities[3].find("style"), "3");
  EXPECT_FALSE(entities[4].find("switchshadstyle"));
  EXPECT_EQ(warnings.size(), 2u);
}

// Channels, pictures and switchable shadows: the same bytes for any threads, with a cache, and from shards.
TEST(SwitchableShadows, AllKeysGiveTheSameLightInAllWays) {
  const LitResult lit = light_in_all_ways(
      "\"_minlight\" \"10\" \"_minlight_mottle\" \"1\" \"_dirtmode\" \"1\"",
      "{ \"classname\" \"func_wall\" \"model\" \"*1\" \"_switchableshadow\" \"1\" }"
      "{ \"classname\" \"light\" \"origin\" \"0 0 60\" \"_shadow_channel_mask\" \"2\" \"_dirtscale\" \"2\" }"
      "{ \"classname\" \"light\" \"origin\" \"0 8 64\" \"_bouncescale\" \"0.5\" \"_project_texture\" "
      "\"wall\" }");
  EXPECT_NE(lit.bsp.entities.find("switchshadstyle"), std::string::npos);
}

}  // namespace
}  // namespace temblor::test
