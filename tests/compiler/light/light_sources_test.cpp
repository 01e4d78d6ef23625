// Single lights in an empty room without shadows, compared with the formulas that mappers know, which are
// repeated here.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "compiler/light/lighting.h"

namespace temblor::test {
namespace {

using Value = std::function<double(double distance)>;

double angle_factor(double scale, double cosine) {
  return cosine <= 0 ? 0 : 1 - scale + scale * cosine;
}

// The byte that light of this value is stored as: half of it, in 0..255.
double stored(double value) {
  return std::clamp(value / 2, 0.0, 255.0);
}

struct Expected {
  math::Vec3d origin{10, -20, 5};
  Value value{};
  double angle_scale = 0.5;
  std::function<double(double cosine_to_beam)> cone = [](double) { return 1.0; };
  math::Vec3d beam{0, 0, -1};
  double most_stored = 255;
};

double expected_at(const Expected& light, const RoomLuxel& luxel) {
  const math::Vec3d way = light.origin - luxel.place_world;
  const double distance = std::max(glm::length(way), 0.1);
  return light.value(distance) * angle_factor(light.angle_scale, glm::dot(way, luxel.normal) / distance) *
         light.cone(-glm::dot(way, light.beam) / distance);
}

void expect_room_lit(const std::string& keys, const Expected& light, const std::string& world_keys = "") {
  const LitResult lit =
      test::light(room_with({"{ 'classname' 'light' 'origin' '10 -20 5' " + keys + " }", world_keys}));
  EXPECT_TRUE(lit.warnings.empty());
  double brightest = 0;
  for (const RoomLuxel& luxel : room_luxels(lit)) {
    const double expected = std::min(light.most_stored, stored(expected_at(light, luxel)));
    brightest = std::max(brightest, expected);
    ASSERT_NEAR(luxel.gray, expected, 1) << keys << ": " << luxel;
  }
  EXPECT_GT(brightest, 20) << keys << " lights nothing";
}

TEST(LightSources, LinearFallsByItsWait) {
  expect_room_lit("'light' '300'", {.value = [](double d) { return std::max(0.0, 300 - d); }});
  expect_room_lit("'light' '200' 'wait' '2.5'",
                  {.value = [](double d) { return std::max(0.0, 200 - 2.5 * d); }});
  expect_room_lit("", {.value = [](double d) { return std::max(0.0, 300 - d); }});
  expect_room_lit("'light' '200' 'wait' '-3'", {.value = [](double d) { return std::max(0.0, 200 - d); }});
}

TEST(LightSources, FalloffEndsAtADistance) {
  expect_room_lit("'light' '300' '_falloff' '100' 'wait' '9'",
                  {.value = [](double d) { return d < 100 ? 300 * (1 - d / 100) : 0; }});
}

TEST(LightSources, InverseAndInverseSquare) {
  expect_room_lit("'light' '60' 'delay' '1' 'wait' '1.5'",
                  {.value = [](double d) { return 60 * 128 / (1.5 * d); }});
  expect_room_lit("'light' '40' 'delay' '2' 'wait' '1.1'",
                  {.value = [](double d) { return 40 * 128.0 * 128 / (1.1 * d * 1.1 * d); }});
  expect_room_lit("'light' '200' 'delay' '5' 'wait' '2'",
                  {.value = [](double d) { return 200 * 128.0 * 128 / ((2 * d + 128) * (2 * d + 128)); }});
}

TEST(LightSources, WithoutAttenuationOnlyTheAngleMatters) {
  expect_room_lit("'light' '180' 'delay' '3'", {.value = [](double) { return 180.0; }});
  expect_room_lit("'light' '180' 'delay' '3' '_anglescale' '1'",
                  {.value = [](double) { return 180.0; }, .angle_scale = 1});
  expect_room_lit("'light' '180' 'delay' '3' '_anglescale' '0'",
                  {.value = [](double) { return 180.0; }, .angle_scale = 0});
}

TEST(LightSources, LevelSettingsScaleLights) {
  expect_room_lit("'light' '300'", {.value = [](double d) { return std::max(0.0, 300 - 3 * d); }},
                  "'_dist' '3'");
  expect_room_lit("'light' '100'", {.value = [](double d) { return 2 * std::max(0.0, 100 - d); }},
                  "'_range' '1'");
  // A limit of the stored light, which is half of the value.
  expect_room_lit("'light' '300'", {.value = [](double d) { return 300 - d; }, .most_stored = 60},
                  "'_maxlight' '60'");
  expect_room_lit("'light' '300' 'delay' '3'", {.value = [](double) { return 300.0; }, .angle_scale = 0},
                  "'_anglescale' '0'");
}

TEST(LightSources, LocalMinlightRaisesInsteadOfAdding) {
  const auto least = [](double) { return 150.0; };
  for (const char* angle_scale : {"0", "0.5", "1"})
    expect_room_lit(std::string("'light' '150' 'delay' '4' '_anglescale' '") + angle_scale + "'",
                    {.value = least, .angle_scale = 0});
  const LitResult lit = test::light(
      room_with({"{ 'classname' 'light' 'origin' '10 -20 5' 'light' '150' 'delay' '4' '_anglescale' '0' }"
                 "{ 'classname' 'light' 'origin' '10 -20 5' 'light' '260' }"}));
  const Expected other{.value = [](double d) { return std::max(0.0, 260 - d); }};
  int raised = 0, brighter = 0;
  for (const RoomLuxel& luxel : room_luxels(lit)) {
    const double added = expected_at(other, luxel);
    ++(added < 150 ? raised : brighter);
    ASSERT_NEAR(luxel.gray, stored(std::max(added, 150.0)), 1);
  }
  EXPECT_GT(raised, 20);
  EXPECT_GT(brighter, 20);
}

TEST(LightSources, NegativeLightsAlsoReduceMinimumLight) {
  const LitResult lit = test::light(
      room_with({"{ 'classname' 'light' 'origin' '10 -20 5' 'light' '-150' }", "'_minlight' '200'"}));
  const Expected taken{.value = [](double d) { return std::min(0.0, -150 + d); }};
  double most = 0;
  for (const RoomLuxel& luxel : room_luxels(lit)) {
    const double less = expected_at(taken, luxel);
    most = std::min(most, less);
    ASSERT_NEAR(luxel.gray, stored(200 + less), 1);
  }
  EXPECT_LT(most, -60);
}

double ramp(double cosine, double inner_deg, double outer_deg) {
  const double inner = std::cos(inner_deg / 2 * std::numbers::pi / 180);
  const double outer = std::cos(outer_deg / 2 * std::numbers::pi / 180);
  if (cosine < outer) return 0;
  return cosine >= inner ? 1 : (cosine - outer) / (inner - outer);
}

TEST(LightSources, SpotlightsShineInACone) {
  const auto even = [](double) { return 200.0; };
  const math::Vec3d down(0, 0, -1), along_y(0, 1, 0);
  // Yaw 90, pitch 0 is along y. The angle is that of the full cone.
  expect_room_lit("'light' '200' 'delay' '3' 'mangle' '90 0 0' 'angle' '70'",
                  {.value = even, .cone = [](double c) { return ramp(c, 70, 70); }, .beam = along_y});
  expect_room_lit("'light' '200' 'delay' '3' 'mangle' '0 -90 0'",
                  {.value = even, .cone = [](double c) { return ramp(c, 40, 40); }, .beam = down});
  expect_room_lit("'light' '200' 'delay' '3' 'mangle' '17 -90 3' 'angle' '120' '_softangle' '50'",
                  {.value = even, .cone = [](double c) { return ramp(c, 50, 120); }, .beam = down});
}

TEST(LightSources, SpotlightsAimAtTheirTarget) {
  const LitResult lit = test::light(room_with(
      {"{ 'classname' 'light' 'origin' '10 -20 5' 'light' '200' 'delay' '3' 'target' 'there' 'angle' '80' }"
       "{ 'classname' 'info_null' 'targetname' 'there' 'origin' '30 20 -40' }"}));
  const Expected light{.value = [](double) { return 200.0; },
                       .cone = [](double c) { return ramp(c, 80, 80); },
                       .beam = glm::normalize(math::Vec3d(20, 40, -45))};
  for (const RoomLuxel& luxel : room_luxels(lit))
    ASSERT_NEAR(luxel.gray, stored(expected_at(light, luxel)), 1);
}

TEST(LightSources, ColorsAreFractionsOrBytes) {
  for (const char* color : {"'_color' '0.2 0.8 1'", "'_color' '51 204 255'"}) {
    const LitResult lit = test::light(
        room_with({std::string("{ 'classname' 'light' 'origin' '10 -20 5' 'light' '300' ") + color + "}"}));
    ASSERT_TRUE(lit.summary.colored);
    const Expected light{.value = [](double d) { return std::max(0.0, 300 - d); }};
    for (const RoomLuxel& luxel : room_luxels(lit)) {
      const double white = stored(expected_at(light, luxel));
      ASSERT_NEAR(luxel.rgb[0], 0.2 * white, 1);
      ASSERT_NEAR(luxel.rgb[1], 0.8 * white, 1);
      ASSERT_NEAR(luxel.rgb[2], white, 1);
      ASSERT_EQ(luxel.gray, luxel.rgb[2]);
    }
  }
}

TEST(LightSources, BrightnessMayIncludeTheColor) {
  const LitResult lit =
      test::light(room_with({"{ 'classname' 'light' 'origin' '10 -20 5' '_light' '255 127.5 0 200' }"}));
  ASSERT_TRUE(lit.summary.colored);
  const Expected light{.value = [](double d) { return std::max(0.0, 200 - d); }};
  for (const RoomLuxel& luxel : room_luxels(lit)) {
    const double white = stored(expected_at(light, luxel));
    ASSERT_NEAR(luxel.rgb[0], white, 1);
    ASSERT_NEAR(luxel.rgb[1], 0.5 * white, 1);
    ASSERT_EQ(luxel.rgb[2], 0);
  }
}

TEST(LightSources, DevianceSpreadsOneLightOverSeveral) {
  const LitResult lit =
      test::light(room_with({"{ 'classname' 'light' 'origin' '0 0 0' 'light' '50' 'delay' '3' '_deviance' "
                             "'20' '_samples' '64' }"}));
  EXPECT_EQ(lit.summary.lights, 64u);
  // From far enough away, they look like one light.
  const Expected light{.origin = math::Vec3d(0.0), .value = [](double) { return 50.0; }};
  for (const RoomLuxel& luxel : room_luxels(lit))
    ASSERT_NEAR(luxel.gray, stored(expected_at(light, luxel)), 2);
}

TEST(LightSources, WarnsAboutUnknownValues) {
  const LitResult lit =
      test::light(room_with({"{ 'classname' 'light' 'origin' '8 0 0' 'delay' '7' }"
                             "{ 'classname' 'light' 'origin' '0 0 0' 'target' 'nobody' }"}));
  ASSERT_EQ(lit.warnings.size(), 2u);
  EXPECT_EQ(lit.warnings[0].kind, "light with an unknown delay, ignored");
  EXPECT_EQ(lit.warnings[0].what, "light at \"8 0 0\": delay must be 0 to 5")
      << "numbers of a level's entities are not its map's";
  EXPECT_NE(lit.warnings[1].what.find("nobody"), std::string::npos);
}

TEST(LightSources, LightsOfTheGameLightNothing) {
  const LitResult lit =
      test::light(room_with({"{ 'classname' 'light' 'origin' '0 0 0' '_nostaticlight' '1' }"}));
  EXPECT_EQ(lit.summary.lit_faces, 0u);
  for (const formats::BspFace& face : lit.bsp.faces) {
    EXPECT_EQ(face.light_offset, -1);
    EXPECT_EQ(face.styles, (std::array<std::uint8_t, 4>{255, 255, 255, 255}));
  }
}

}  // namespace
}  // namespace temblor::test
