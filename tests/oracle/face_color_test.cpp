// Texels and light by the definition, against numbers computed by hand.
#include "oracle/rays/face_color.h"

#include <gtest/gtest.h>

#include <array>

#include "oracle/polygon_level.h"

namespace temblor::oracle {
namespace {

// One square in the plane z = 0, from (-16, 0) to (16, 16): light samples 3 x 2, two styles.
world::Level lit_level() {
  const std::array models = {PolygonModel{{{{-16, 0, 0}, {-16, 16, 0}, {16, 16, 0}, {16, 0, 0}}}}};
  world::Level level = make_polygon_level(models);
  level.has_light = true;
  level.light = {99, 10, 50, 90, 20, 60, 100, 1, 2, 3, 4, 5, 6};  // one sample of some other face first
  for (const std::uint8_t sample : level.light)
    for (int channel = 0; channel < 3; ++channel)
      level.light_rgb.push_back(static_cast<std::uint8_t>(sample + channel));
  world::Face& face = level.faces[0];
  face.light = 1;
  face.style_count = 2;
  face.styles = {0, 3, world::kNoStyle, world::kNoStyle};
  return level;
}

world::LightStyleValues make_styles(std::uint16_t style_0, std::uint16_t style_3) {
  world::LightStyleValues styles{};
  styles[0] = style_0;
  styles[3] = style_3;
  return styles;
}

double gray_light(const world::Level& level, const world::LightStyleValues& styles, std::int64_t s,
                  std::int64_t t) {
  return sample_light(level, level.faces[0], styles, {s, t}, LightColor::kGray)[0];
}

TEST(TexturePosition, ComesFromTheAxes) {
  world::Level level = lit_level();
  level.texture_axes[0] = {{2, 0, 0.5f}, 3, {0, -1, 0}, -4};
  EXPECT_EQ(texture_position(level, level.faces[0], {10, 20, 30}), math::Vec2d(38, -24));
}

TEST(TexelAt, TilesWithoutEnd) {
  const world::Level level = lit_level();
  const world::Texture& texture = level.textures[0];
  EXPECT_EQ(texel_at(texture, {5, 2}), 37);
  EXPECT_EQ(texel_at(texture, {5 + 16 * 7, 2 - 16 * 9}), 37);
  EXPECT_EQ(texel_at(texture, {-1, -1}), 255);
}

TEST(LightAt, IsTheSampleAtAGridPoint) {
  const world::Level level = lit_level();
  const auto styles = make_styles(256, 0);
  EXPECT_DOUBLE_EQ(gray_light(level, styles, -16, 0), 10 * 256);
  EXPECT_DOUBLE_EQ(gray_light(level, styles, 0, 0), 50 * 256);
  EXPECT_DOUBLE_EQ(gray_light(level, styles, 16, 16), 100 * 256);
}

TEST(LightAt, IsLinearBetweenGridPoints) {
  const world::Level level = lit_level();
  const auto styles = make_styles(256, 0);
  EXPECT_DOUBLE_EQ(gray_light(level, styles, -8, 0), 30 * 256);
  EXPECT_DOUBLE_EQ(gray_light(level, styles, -16, 4), 12.5 * 256);
  EXPECT_DOUBLE_EQ(gray_light(level, styles, 4, 8),
                   (50 * 0.75 + 90 * 0.25 + 60 * 0.75 + 100 * 0.25) / 2 * 256);
  EXPECT_DOUBLE_EQ(gray_light(level, styles, 40, 0), 90 * 256) << "past the border: that of the border";
}

TEST(LightAt, SumsStyles) {
  const world::Level level = lit_level();
  EXPECT_DOUBLE_EQ(gray_light(level, make_styles(256, 512), -16, 16), 20 * 256 + 4 * 512);
  EXPECT_DOUBLE_EQ(gray_light(level, make_styles(0, 264), 0, 0), 2 * 264);
}

TEST(LightAt, IsCutOffAtTheBrightestBeforeItIsInterpolated) {
  const world::Level level = lit_level();
  const auto styles = make_styles(256 * 10, 0);
  EXPECT_DOUBLE_EQ(gray_light(level, styles, 0, 0), 255 * 256);
  EXPECT_DOUBLE_EQ(gray_light(level, styles, -8, 0), (100 * 256 + 255 * 256) / 2.0);
}

TEST(LightAt, HasColor) {
  world::Level level = lit_level();
  const auto styles = make_styles(256, 0);
  const Light light = sample_light(level, level.faces[0], styles, {0, 0}, LightColor::kRgb);
  EXPECT_EQ(light, (Light{50 * 256, 51 * 256, 52 * 256}));
  level.light_rgb.clear();
  const Light gray = sample_light(level, level.faces[0], styles, {0, 0}, LightColor::kRgb);
  EXPECT_EQ(gray, (Light{50 * 256, 50 * 256, 50 * 256})) << "a level without colors";
}

TEST(LightAt, KeepsItsHueWhereItIsCutOff) {
  const world::Level level = lit_level();
  const Light light = sample_light(level, level.faces[0], make_styles(256 * 10, 0), {0, 0}, LightColor::kRgb);
  EXPECT_DOUBLE_EQ(light[2], 255 * 256);
  EXPECT_DOUBLE_EQ(light[0] / light[2], 50.0 / 52);
  EXPECT_DOUBLE_EQ(light[1] / light[2], 51.0 / 52);
}

TEST(LightAt, IsBlackWithoutSamples) {
  world::Level level = lit_level();
  level.faces[0].light = world::kNoLight;
  EXPECT_EQ(gray_light(level, make_styles(256, 256), 0, 0), 0);
}

TEST(ColormapRow, GetsDarkerWithLessLight) {
  EXPECT_EQ(colormap_row(0), 63);
  EXPECT_EQ(colormap_row(264.0 * 128), 30) << "(65280 - 33792) / 4 = 7872, and 7872 / 256 = 30.75";
  EXPECT_EQ(colormap_row(255.0 * 256), 0);
  EXPECT_EQ(colormap_row(4.0 * 255 * 550), 0) << "brighter than the brightest";
  for (double light = 0; light < 70000; light += 100)
    EXPECT_GE(colormap_row(light), colormap_row(light + 100));
}

}  // namespace
}  // namespace temblor::oracle
