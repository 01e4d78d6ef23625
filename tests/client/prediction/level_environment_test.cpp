#include "client/prediction/level_environment.h"

#include <gtest/gtest.h>

namespace temblor::client {
namespace {

LevelEnvironment environment_with(std::vector<std::pair<std::string, std::string>> pairs) {
  world::Level level;
  level.entities.push_back({std::move(pairs)});
  return parse_environment(level);
}

TEST(LevelEnvironment, KeysAreFoundWithAndWithoutUnderscore) {
  EXPECT_EQ(environment_with({{"sky", "dusk_"}}).skybox, "dusk_");
  EXPECT_EQ(environment_with({{"_sky", "dusk_"}}).skybox, "dusk_");
  EXPECT_EQ(environment_with({{"skyname", "night"}}).skybox, "night");
  EXPECT_EQ(environment_with({{"_wateralpha", "0.25"}}).water_alpha, 0.25f);
  EXPECT_EQ(environment_with({{"lavaalpha", "7"}}).lava_alpha, 1.0f);
  EXPECT_EQ(environment_with({{"par", "270"}}).par_s, 270);
}

TEST(LevelEnvironment, FogIsDensityAndColor) {
  const render::Fog fog = environment_with({{"fog", "0.04 0.5  0.25 1"}}).fog;
  EXPECT_FLOAT_EQ(fog.density, 0.04f);
  EXPECT_EQ(fog.color, math::Vec3(0.5f, 0.25f, 1.0f));
  EXPECT_FLOAT_EQ(environment_with({{"fog", "0.1"}}).fog.density, 0.1f);
}

TEST(LevelEnvironment, IgnoresWhatDoesNotParse) {
  for (const char* text : {"", "thick", "nan", "-0.5", "-1 1 1 1"})
    EXPECT_EQ(environment_with({{"fog", text}}).fog.density, 0) << text;
  EXPECT_FALSE(environment_with({{"wateralpha", "clear"}}).water_alpha);
  for (const char* text : {"fast", "nan", "-20"})
    EXPECT_EQ(environment_with({{"par", text}}).par_s, 0) << text;
  EXPECT_EQ(parse_environment(world::Level{}).skybox, "");
}

TEST(LevelEnvironment, SettingsFillInForTheLevel) {
  const LevelEnvironment environment = environment_with({{"wateralpha", "0.5"}});
  const render::LiquidAlpha alpha = environment.liquid_alpha({.water = 0.1f, .slime = 0.2f});
  EXPECT_EQ(alpha.water, 0.5f);
  EXPECT_EQ(alpha.slime, 0.2f);
  EXPECT_EQ(alpha.lava, 1.0f);
}

}  // namespace
}  // namespace temblor::client
