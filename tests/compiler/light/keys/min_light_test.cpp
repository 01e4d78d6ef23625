// Minimum light and limits of light, with the keys that change them.
#include "compiler/light/faces/min_light.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/light/faces/soften.h"
#include "compiler/light/keys/key_room.h"
#include "compiler/light/lighting.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using math::Vec3;
using math::Vec3d;

TEST(MinLight, ExcludedTexturesHaveNone) {
  const std::string two_textures =
      box_text({-80, -16, 8}, {-48, 16, 32}, "wood") + box_text({48, -16, 8}, {80, 16, 32}, "steel");
  const auto lights_with = [&](const char* keys) {
    const auto level = lit_map(key_room(entity_text("func_wall", keys, two_textures), "'_minlight' '40'"));
    return std::array<double, 2>{light_at(*level, {-64, 0, 32}), light_at(*level, {64, 0, 32})};
  };
  using Lights = std::array<double, 2>;
  EXPECT_EQ(lights_with("'_minlight' '80'"), (Lights{40, 40}));
  EXPECT_EQ(lights_with("'_minlight' '80' '_minlight_exclude' 'WOOD'"), (Lights{0, 40}));
  EXPECT_EQ(lights_with("'_minlight_exclude' 'wood' '_minlight_exclude2' 'steel'"), (Lights{0, 0}));
  EXPECT_EQ(lights_with("'_minlight_exclude9' 'steel'"), (Lights{20, 0}));
  EXPECT_EQ(lights_with("'_minlight_exclude' 'woods'"), (Lights{20, 20}));
}

TEST(MinLight, IsAddedOnRequest) {
  const auto raised = lit_map(key_room(lamp(), "'_minlight' '60'"));
  const auto added = lit_map(key_room(lamp(), "'_minlight' '60' '_addmin' '1'"));
  for (int x = 0; x <= 112; x += 16) {
    const Vec3d place(x, 0, 0);
    const double lamp_light = find_lamp_light(place);
    EXPECT_NEAR(light_at(*raised, place), std::max(30.0, lamp_light), 1) << x;
    EXPECT_NEAR(light_at(*added, place), 30 + lamp_light, 1) << x;
  }
}

TEST(MinLight, MottleVariesAroundTheMinimum) {
  const LitResult lit = light(room_with({"", "'_minlight' '200' '_minlight_mottle' '1'"}));
  double sum = 0;
  int count = 0, least = 255, most = 0;
  for (const RoomLuxel& luxel : room_luxels(lit)) {
    const double expected = 100 * double{compiler::find_mottle(luxel.place_world - luxel.normal)};
    ASSERT_NEAR(luxel.gray, expected, 1) << luxel;
    sum += luxel.gray;
    ++count;
    least = std::min<int>(least, luxel.gray);
    most = std::max<int>(most, luxel.gray);
  }
  EXPECT_NEAR(sum / count, 100, 5);
  EXPECT_GE(least, 75);
  EXPECT_LE(most, 125);
  EXPECT_LT(least, 90);
  EXPECT_GT(most, 110);
}

TEST(MinLight, MottleIsContinuousAndAveragesToOne) {
  Random random(1);
  double sum = 0;
  constexpr int kPlaces = 20000;
  for (int i = 0; i < kPlaces; ++i) {
    const Vec3d place(random.uniform(-4096, 4096), random.uniform(-4096, 4096), random.uniform(-4096, 4096));
    const double here = double{compiler::find_mottle(place)};
    sum += here;
    ASSERT_LE(std::abs(here - 1), 0.25);
    ASSERT_NEAR(double{compiler::find_mottle(place + Vec3d(0.01, 0.01, -0.01))}, here, 0.001);
  }
  EXPECT_NEAR(sum / kPlaces, 1, 0.005);
}

TEST(LightLimits, MaxLightOfABrushLimitsItsFaces) {
  const auto level = lit_map(key_room(lamp() + box_entity("'_maxlight' '20'", {-16, -16, 8}, {16, 16, 32})));
  EXPECT_EQ(light_at(*level, {0, 0, 32}), 20);
  EXPECT_NEAR(light_at(*level, {64, 0, 0}), find_lamp_light({64, 0, 0}), 1);
}

TEST(LightLimits, ColorScaleMakesLightGrayOfTheSameBrightness) {
  const auto color_with = [](const char* keys) {
    const auto level =
        lit_map(key_room(lamp("'_color' '1 0.5 0.25'") + box_entity(keys, {-16, -16, 8}, {16, 16, 32})));
    return shown_light(*level, face_under(*level, {0, 0, 32}, kFaceUp), {0, 0, 32});
  };
  const Vec3d full = color_with(""), half = color_with("'_lightcolorscale' '0.5'");
  EXPECT_NEAR(full.x, find_lamp_light({0, 0, 32}), 1);
  EXPECT_NEAR(full.z, full.x / 4, 1);
  EXPECT_NEAR(half.x, full.x, 1);
  EXPECT_NEAR(half.y, full.x * 0.75, 1);
  EXPECT_NEAR(half.z, full.x * 0.625, 1);
  EXPECT_EQ(color_with("'_lightcolorscale' '0'"), Vec3d(full.x));
}

TEST(LightLimits, SoftAveragesSquares) {
  Random random(2);
  for (const int reach : {0, 1, 2, 7}) {
    const int width = 9, height = 5;
    std::vector<Vec3> sharp;
    for (int i = 0; i < width * height; ++i)
      sharp.push_back(Vec3(static_cast<float>(random.uniform(0, 300)), static_cast<float>(i), 1));
    std::vector<Vec3> soft = sharp;
    compiler::soften(reach, width, height, soft);
    for (int i = 0; i < width * height; ++i) {
      Vec3d sum(0.0);
      int count = 0;
      for (int j = 0; j < width * height; ++j) {
        if (std::abs(i % width - j % width) > reach || std::abs(i / width - j / width) > reach) continue;
        sum += Vec3d(sharp[static_cast<std::size_t>(j)]);
        ++count;
      }
      ASSERT_LT(glm::length(sum / double(count) - Vec3d(soft[static_cast<std::size_t>(i)])), 0.001)
          << reach << " " << i;
    }
  }
}

TEST(LightLimits, SoftSmoothsTheEdgesOfShadows) {
  const std::string text = key_room(lamp() + box_entity("'_shadow' '1'", {-32, -32, 100}, {32, 32, 108}));
  compiler::LightOptions soft;
  soft.soft = 2;
  const auto sharp_level = lit_map(text), soft_level = lit_map(text, {soft, {}});
  const auto steepest = [](const world::Level& level) {
    double most = 0;
    for (int x = 0; x < 112; x += 16)
      most = std::max(most, std::abs(light_at(level, Vec3d(x, 0, 0)) - light_at(level, Vec3d(x + 16, 0, 0))));
    return most;
  };
  EXPECT_GT(steepest(*sharp_level), 20);
  EXPECT_LT(steepest(*soft_level), steepest(*sharp_level) / 2);
}

}  // namespace
}  // namespace temblor::test
