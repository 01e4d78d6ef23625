// Keys of single lights and brushes: bounces, dirt, skies, and where light ends.
#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/light/keys/key_room.h"
#include "compiler/light/lighting.h"

namespace temblor::test {
namespace {

using math::Vec3d;

// A spotlight on the middle of the floor: the ceiling has bounced light only.
double ceiling_light(std::string_view spot_keys, std::string_view world_keys,
                     std::string_view entities = {}) {
  const std::string spot = fmt::format("'mangle' '0 -90 0' 'angle' '40' {}", spot_keys);
  const auto level = lit_map(key_room(lamp(spot) + std::string(entities), world_keys));
  return shown_light(*level, face_under(*level, {96, 96, 256}, -kFaceUp), {96, 96, 256}).x;
}

TEST(LightAmounts, BounceScaleOfALightScalesWhatIsSentBack) {
  const std::string bounce = "'_bounce' '1' '_bouncescale' '4'";
  const double all = ceiling_light("", bounce);
  EXPECT_GT(all, 8);
  EXPECT_EQ(ceiling_light("'_bouncescale' '0'", bounce), 0);
  EXPECT_NEAR(ceiling_light("'_bouncescale' '0.5'", bounce), all / 2, 1);
  EXPECT_NEAR(ceiling_light("'_bouncescale' '2'", bounce), all * 2, 2);
  const auto level = lit_map(key_room(lamp("'_bouncescale' '0'"), bounce));
  EXPECT_NEAR(light_at(*level, {32, 0, 0}), find_lamp_light({32, 0, 0}), 1);  // direct light stays
}

TEST(LightAmounts, BounceScaleOfABrushScalesWhatItSendsBack) {
  const std::string bounce = "'_bounce' '1' '_bouncescale' '4'";
  const auto with = [&](const char* keys) {  // the brush hides the floor from the spotlight
    return ceiling_light("", bounce, box_entity(keys, {-96, -96, 0}, {96, 96, 8}, "wood", "func_detail"));
  };
  const double all = with("");
  EXPECT_GT(all, 8);
  EXPECT_LT(with("'_bouncescale' '0'"), 1);
  EXPECT_NEAR(with("'_bouncescale' '0.5'"), all / 2, 1);
}

// A floor place in a corner, where dirt is strong.
double corner_light(std::string_view lamp_keys, std::string_view world_keys) {
  return light_at(*lit_map(key_room(lamp(lamp_keys), world_keys)), {112, 112, 0});
}

TEST(LightAmounts, DirtOfALight) {
  const double clean = corner_light("", ""), dirty = corner_light("", "'_dirt' '1'");
  EXPECT_LT(dirty, clean * 0.8);
  EXPECT_EQ(corner_light("'_dirt' '1'", ""), dirty);
  EXPECT_EQ(corner_light("'_dirt' '-1'", "'_dirt' '1'"), clean);
  const double strong = corner_light("", "'_dirt' '1' '_dirtscale' '1.5' '_dirtgain' '0.8'");
  EXPECT_LT(strong, dirty);
  EXPECT_EQ(corner_light("'_dirtscale' '1.5' '_dirtgain' '0.8'", "'_dirt' '1'"), strong);
}

TEST(LightAmounts, RandomDirtHasTheSameMean) {
  const auto mean = [](const char* mode) {
    const LitResult lit =
        light(room_with({"{ 'classname' 'light' 'origin' '0 0 40' }",
                         fmt::format("'_dirt' '1' '_dirtscale' '2' '_dirtmode' '{}'", mode)}));
    double sum = 0;
    for (const std::uint8_t sample : lit.bsp.lighting) sum += sample;
    return std::pair(sum / static_cast<double>(lit.bsp.lighting.size()), lit.bsp.lighting);
  };
  const auto ordered = mean("0"), random = mean("1");
  EXPECT_NEAR(random.first, ordered.first, ordered.first * 0.03);
  EXPECT_NE(random.second, ordered.second);
}

TEST(LightAmounts, SunShinesFromItsSkyOnly) {
  const auto sun_light = [](const char* texture) {
    std::string text =
        entity_text("worldspawn", "",
                    walls_text({-128, -128, 0}, {128, 128, 272}, "stone") +
                        box_text({-128, -128, 256}, {0, 128, 272}, "sky_left") +
                        box_text({0, -128, 256}, {128, 128, 272}, "sky_right")) +
        point_text("info_player_start", {-100, -100, 40}) +
        entity_text("light", fmt::format("\"_sun\" \"1\"\n\"light\" \"200\"\n{}",
                                         *texture == '\0' ? std::string()
                                                          : fmt::format("\"_suntexture\" \"{}\"", texture)));
    const auto level = lit_map(text);
    return std::array<double, 2>{light_at(*level, {-64, 0, 0}), light_at(*level, {64, 0, 0})};
  };
  using Lights = std::array<double, 2>;
  EXPECT_EQ(sun_light(""), (Lights{100, 100}));
  EXPECT_EQ(sun_light("SKY_LEFT"), (Lights{100, 0}));
  EXPECT_EQ(sun_light("sky_right"), (Lights{0, 100}));
  EXPECT_EQ(sun_light("sky_none"), (Lights{0, 0}));
}

TEST(LightAmounts, SpotlightsEndAtTheirTargetOnRequest) {
  const auto floor_light = [](std::string_view world_keys, std::string_view keys) {
    return light_at(
        *lit_map(key_room(lamp(fmt::format("'target' 'aim' {}", keys)) +
                              "{ 'classname' 'info_null' 'targetname' 'aim' 'origin' '0 0 40' }\n",
                          world_keys)),
        Vec3d(0.0));
  };
  const double usual = find_lamp_light(Vec3d(0.0));
  EXPECT_NEAR(floor_light("", ""), usual, 1);
  EXPECT_EQ(floor_light("'_spotlightautofalloff' '1'", ""), 0);  // the target is 200 units below
  // With a falloff of its own, the target does not matter: 400 * (1 - 239 / 478), halved.
  EXPECT_NEAR(floor_light("'_spotlightautofalloff' '1'", "'_falloff' '478'"), 100, 1);
}

TEST(LightAmounts, TwoSidedFacesTakeLightFromBehind) {
  const auto below = [](const char* keys) {  // the lower side of a thin plate under the lamp
    const auto level = lit_map(key_room(lamp() + box_entity(keys, {-32, -32, 60}, {32, 32, 64})));
    return shown_light(*level, face_under(*level, {0, 0, 60}, -kFaceUp), {0, 0, 60}).x;
  };
  EXPECT_EQ(below(""), 0);
  EXPECT_NEAR(below("'_light_twosided' '1'"), (400 - 181) / 2.0, 1);
}

TEST(LightAmounts, HiddenFacesTakeTheLightAtTheTarget) {
  const auto hidden_side = [](const char* keys) {
    const Vec3d hidden(140, 0, 108);  // in the wall
    const auto level =
        lit_map(key_room(lamp() + box_entity(keys, {120, -8, 100}, {140, 8, 116}, "wood", "func_door") +
                         "{ 'classname' 'info_null' 'targetname' 'dark' 'origin' '0 0 264' }\n"
                         "{ 'classname' 'info_null' 'targetname' 'bright' 'origin' '0 0 200' }\n"));
    return shown_light(*level, face_under(*level, hidden, {1, 0, 0}), hidden).x;
  };
  const double center = hidden_side("");
  // 40 units below the lamp: of six directions, one faces it and four are edge-on.
  EXPECT_NEAR(hidden_side("'_autominlight_target' 'bright'"), 360 / 2.0 / 6, 1);
  EXPECT_EQ(hidden_side("'_autominlight_target' 'dark'"), 0);
  EXPECT_EQ(hidden_side("'_autominlight_target' 'none'"), center);
}

TEST(LightAmounts, AutoMinLightRaisesAllOfAModel) {
  const auto below = [](const char* keys) {  // the lower side, which the lamp does not reach
    const auto level =
        lit_map(key_room(lamp() + box_entity(keys, {-32, -32, 60}, {32, 32, 64}) +
                         "{ 'classname' 'info_null' 'targetname' 'bright' 'origin' '0 0 200' }\n"));
    return shown_light(*level, face_under(*level, {0, 0, 60}, -kFaceUp), {0, 0, 60}).x;
  };
  EXPECT_EQ(below("'_autominlight_target' 'bright'"), 0);
  EXPECT_NEAR(below("'_autominlight' '1' '_autominlight_target' 'bright'"), 360 / 2.0 / 6, 1);
}

// A glowing plate on the ceiling, and one light that makes it shine.
TEST(LightAmounts, BrushesChangeTheirSurfaceLights) {
  const auto floor_with = [](const char* brush_keys, const char* light_keys) {
    return lit_map(key_room(
        box_entity(brush_keys, {-32, -32, 248}, {32, 32, 256}, "lamp_texture", "func_detail") +
        fmt::format(
            "{{ 'classname' 'light' 'origin' '0 0 100' 'light' '400' '_surface' 'lamp_texture' {} }}\n",
            light_keys)));
  };
  const auto rgb_at = [](const world::Level& level, std::uint8_t style) {
    return shown_light(level, face_under(level, Vec3d(0.0), kFaceUp), Vec3d(0.0), style);
  };
  const double usual = rgb_at(*floor_with("", ""), 0).x;
  EXPECT_GT(usual, 50);
  EXPECT_EQ(rgb_at(*floor_with("'_surflight_group' '3'", ""), 0).x, 0);
  EXPECT_EQ(rgb_at(*floor_with("", "'_surflight_group' '3'"), 0).x, 0);
  EXPECT_EQ(rgb_at(*floor_with("'_surflight_group' '3'", "'_surflight_group' '3'"), 0).x, usual);
  const auto styled = floor_with("'_surflight_style' '6'", "");
  EXPECT_EQ(rgb_at(*styled, 0).x, 0);
  EXPECT_EQ(rgb_at(*styled, 6).x, usual);
  const Vec3d color = rgb_at(*floor_with("'_surflight_color' '255 0 128'", ""), 0);
  EXPECT_NEAR(color.x, usual, 1);
  EXPECT_EQ(color.y, 0);
  EXPECT_NEAR(color.z, usual * 128 / 255, 1);
  const std::string switched =
      "} { 'classname' 'light' 'origin' '120 120 8' 'light' '1' 'targetname' 'plate'";
  const auto named = floor_with("'_surflight_targetname' 'plate'", switched.c_str());
  EXPECT_EQ(rgb_at(*named, 0).x, 0);
  EXPECT_EQ(rgb_at(*named, 32).x, usual);
  EXPECT_EQ(rgb_at(*floor_with("'_surflight_targetname' 'nothing'", switched.c_str()), 0).x, usual);
}

// Light falls with the cosine of the angle at which it leaves a face: to 0, or to a half.
TEST(LightAmounts, SurfaceLightsRescale) {
  constexpr double kValue = 60;
  const Vec3d place(-64, 64, 0);
  const auto light_with = [&](const char* brush_keys, const char* light_keys) {
    const auto level = lit_map(key_room(
        box_entity(brush_keys, {32, 32, 248}, {96, 96, 256}, "lamp_texture", "func_detail") +
        fmt::format("{{ 'classname' 'light' 'light' '{}' 'delay' '3' '_surface' 'lamp_texture' {} }}\n",
                    kValue, light_keys)));
    return shown_light(*level, face_under(*level, place, kFaceUp), place, 0).x;
  };
  // The plate's faces, except the one whose light it blocks itself.
  const auto expected = [&](auto&& find_factor) {
    double sum = 0;
    for (const Vec3d normal : {Vec3d(0, 0, -1), Vec3d(-1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, -1, 0)}) {
      const Vec3d center = Vec3d(64, 64, 252) + normal * Vec3d(32, 32, 4);
      const Vec3d way = glm::normalize(place - (center + normal * 2.0));
      sum += kValue / 2 * (1 - way.z) / 2 * find_factor(glm::dot(way, normal));
    }
    return sum;
  };
  const double natural = expected([](double cosine) { return std::max(0.0, cosine); });
  const double half = expected([](double cosine) { return (1 + cosine) / 2; });
  const char* const kNatural = "'_surflight_rescale' '0'";
  const char* const kHalf = "'_surflight_rescale' '1'";
  EXPECT_NEAR(light_with("", ""), expected([](double) { return 1; }), 1.5);
  EXPECT_NEAR(light_with(kNatural, ""), natural, 1.5);
  EXPECT_NEAR(light_with(kHalf, ""), half, 1.5);
  EXPECT_NEAR(light_with("", kNatural), natural, 1.5);
  EXPECT_NEAR(light_with(kHalf, kNatural), half, 1.5);
}

TEST(LightAmounts, LightMapScaleOfTheWorldIsInTexels) {
  const LitResult by_key = light(room_with({lamp("", "0 0 40"), "'_lightmap_scale' '8'"}));
  compiler::LightOptions options;
  options.luxel_texels = 8;
  EXPECT_EQ(by_key.bsp.lighting, light(room_with({lamp("", "0 0 40")}), options).bsp.lighting);
  EXPECT_GT(by_key.bsp.lighting.size(), light(room_with({lamp("", "0 0 40")})).bsp.lighting.size() * 3);
}

}  // namespace
}  // namespace temblor::test
