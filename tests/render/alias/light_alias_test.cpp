// Light of models: from the floor and dynamic lights to colormap rows, by the values observed in stock Quake.
#include "render/alias/light_alias.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "formats/models/mdl_normals.h"
#include "support/levels/drawable_level.h"
#include "support/models/drawable_models.h"
#include "support/random.h"

namespace temblor::test {
namespace {

class LightAlias : public testing::Test {
 protected:
  LightAlias() {
    scene_.level = drawable_.level.get();
    scene_.light_styles = world::make_stored_light_styles();
    instance_.model = model_.get();
    // There is no floor below it.
    instance_.origin_world = {0, 0, 100000};
  }
  render::AliasLight light(render::PixelFormat format = render::PixelFormat::kIndexed) const {
    return render::light_alias(scene_, instance_, format, true);
  }

  const DrawableLevel drawable_ = small_level();
  const std::shared_ptr<const render::AliasModel> model_ = small_model(box_mdl());
  render::Scene scene_;
  render::AliasInstance instance_;
};

TEST_F(LightAlias, AmbientAndShadeAreBounded) {
  instance_.min_light = 24;
  EXPECT_EQ(light().ambient, 24);
  EXPECT_EQ(light().shade, 24);
  instance_.min_light = 120;
  EXPECT_EQ(light().ambient, 120);
  EXPECT_EQ(light().shade, 72) << "192 together";
  instance_.min_light = 250;
  EXPECT_EQ(light().ambient, 128);
  EXPECT_EQ(light().shade, 64);
}

TEST_F(LightAlias, DynamicLightsAddToTheAmbientWhatTheirRadiusLeaves) {
  instance_.min_light = 10;
  const render::DynamicLight lights[] = {
      {instance_.origin_world + math::Vec3(0, 30, 40), 90, 0, {1, 0.5f, 0}},
      {instance_.origin_world + math::Vec3(300, 0, 0), 299, 0, {1, 1, 1}}};
  scene_.lights = lights;
  EXPECT_NEAR(light().ambient, 50, 0.01);
  EXPECT_NEAR(light().shade, 10, 0.01);
  const render::AliasLight colored = light(render::PixelFormat::kRgb);
  EXPECT_NEAR(colored.ambient, 50, 0.01);
  EXPECT_NEAR(colored.color.x, 1, 1e-5);
  EXPECT_NEAR(colored.color.y, 30.0 / 50, 1e-5);
  EXPECT_NEAR(colored.color.z, 10.0 / 50, 1e-5);
}

// A light of 60 falls on white light of 20 from the floor.
TEST_F(LightAlias, ColoredLightsTintIndexedModelsByTheirShare) {
  const auto light_with_color = [&](const math::Vec3& color) {
    const render::DynamicLight lights[] = {{instance_.origin_world + math::Vec3(0, 30, 40), 110, 0, color}};
    scene_.lights = lights;
    return light();
  };
  instance_.min_light = 20;
  const render::AliasLight white = light_with_color({1, 1, 1}), orange = light_with_color({1, 0.5f, 0.25f});
  EXPECT_EQ(white.tint_row, 0u);
  EXPECT_EQ(orange.tint_row, 23u) << "three quarters of 31";
  EXPECT_EQ(orange.tint_color, (std::array<float, 3>{1, 0.5f, 0.25f}));
  EXPECT_EQ(orange.color, math::Vec3(1));
  EXPECT_EQ(orange.ambient, white.ambient);
  EXPECT_EQ(orange.shade, white.shade);
  instance_.min_light = 0;
  EXPECT_EQ(light_with_color({0.25f, 1, 0.5f}).tint_row, std::size_t{render::kTintRows - 1});
  const render::DynamicLight blue[] = {{instance_.origin_world, 110, 0, {0, 0, 1}}};
  scene_.lights = blue;
  EXPECT_EQ(render::light_alias(scene_, instance_, render::PixelFormat::kIndexed, false).tint_row, 0u);
}

TEST_F(LightAlias, StrongestColoredLightChoosesTheTint) {
  const render::DynamicLight lights[] = {{instance_.origin_world, 20, 0, {1, 0, 0}},
                                         {instance_.origin_world, 40, 0, {0, 0, 1}},
                                         {instance_.origin_world, 90, 0, {1, 1, 1}},
                                         {instance_.origin_world + math::Vec3(0, 0, 70), 80, 0, {0, 1, 0}}};
  scene_.lights = lights;
  EXPECT_EQ(light().tint_color, (std::array<float, 3>{0, 0, 1}));
}

TEST_F(LightAlias, TintsTheColormapWithTheTableOfSurfaces) {
  const render::ColorTables tables = render::make_color_tables(drawable_.palette, drawable_.colormap);
  const auto colors = [&](const render::AliasLight& light, base::Arena& arena) {
    return static_cast<const std::uint8_t*>(
        render::instance_colors(tables, instance_, light, render::PixelFormat::kIndexed, arena));
  };
  base::Arena arena;
  EXPECT_EQ(colors({}, arena), tables.colormap.rows.data()) << "white light costs nothing";
  render::AliasLight light;
  light.tint_color = {1, 0.5f, 0};
  light.tint_row = 20;
  const std::uint8_t* const tint = tables.tints.rows_for(light.tint_color) + light.tint_row * 256;
  const std::uint8_t* const plain = colors(light, arena);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < tables.colormap.rows.size(); ++i) {
    ASSERT_EQ(plain[i], tint[tables.colormap.rows[i]]);
    changed += plain[i] != tables.colormap.rows[i];
  }
  EXPECT_GT(changed, tables.colormap.rows.size() / 4);
  instance_.colors = {4, 12};
  const std::uint8_t* const dressed = colors(light, arena);
  for (std::size_t row = 0; row < 64; ++row) ASSERT_EQ(dressed[row * 256 + 16], plain[row * 256 + 64]);
}

TEST_F(LightAlias, NormalsAreLitFromOneFixedDirection) {
  for (int seed = 0; seed < 50; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    render::AliasInstance turned = instance_;
    turned.angles_deg = random.in_cube(180);
    render::Scene near_eye = scene_;
    near_eye.camera.origin_world = turned.origin_world - math::Vec3(200, 0, 0);
    const auto placement =
        render::place_alias(render::make_view_frame(near_eye, 64, 64), turned, render::AliasRole::kWorld);
    ASSERT_TRUE(placement.has_value());
    const double ambient = random.uniform(0, 128), shade = random.uniform(0, 64);
    const render::AliasLight light{static_cast<float>(ambient), static_cast<float>(shade), false, {1, 1, 1}};
    const render::NormalLights rows = render::light_normals(light, *placement, render::PixelFormat::kIndexed);
    const render::NormalLights rgb = render::light_normals(light, *placement, render::PixelFormat::kRgb);
    // Pitch has the opposite sign for models.
    const math::Basis basis =
        math::basis_from_angles({-turned.angles_deg.x, turned.angles_deg.y, turned.angles_deg.z});
    for (std::size_t i = 0; i < formats::kMdlNormals; ++i) {
      const math::Vec3d normal(formats::mdl_normals()[i]);
      const double world_x = basis.forward.x * normal.x - basis.right.x * normal.y + basis.up.x * normal.z;
      double level = std::max(5.0, (255 - ambient) * 64);
      if (-world_x < 0) level = std::max(0.0, level + shade * 64 * -world_x);
      ASSERT_NEAR(rows[i], level, 0.01) << "seed " << seed;
      // The same light in the units of surfaces: half of 65280 - 4 x level.
      ASSERT_NEAR(rgb[i], (65280 - 4 * level) / 2, 0.02) << "seed " << seed;
    }
  }
}

TEST_F(LightAlias, FullBrightIsTheColorAsStored) {
  instance_.full_bright = true;
  render::Scene near_eye = scene_;
  near_eye.camera.origin_world = instance_.origin_world - math::Vec3(200, 0, 0);
  const auto placement =
      render::place_alias(render::make_view_frame(near_eye, 64, 64), instance_, render::AliasRole::kWorld);
  for (const float level : render::light_normals(light(), *placement, render::PixelFormat::kIndexed))
    EXPECT_EQ(static_cast<int>(level) >> 8, render::kLightAsStored);
  for (const float level : render::light_normals(light(), *placement, render::PixelFormat::kRgb))
    EXPECT_EQ(level, 16384);
}

TEST_F(LightAlias, PlayersWearTheirColors) {
  const render::ColorTables tables = render::make_color_tables(drawable_.palette, drawable_.colormap);
  base::Arena arena;
  instance_.colors = {4, 12};
  const auto* rows = static_cast<const std::uint8_t*>(
      render::instance_colors(tables, instance_, {}, render::PixelFormat::kIndexed, arena));
  for (std::size_t row = 0; row < 64; ++row)
    for (std::size_t i = 0; i < 256; ++i) {
      // Row 4 unchanged; row 12 is reversed.
      const std::size_t shown = i >= 16 && i < 32    ? 64 + i - 16
                                : i >= 96 && i < 112 ? 192 + 15 - (i - 96)
                                                     : i;
      ASSERT_EQ(rows[row * 256 + i], drawable_.colormap.rows[row * 256 + shown]);
    }
  const auto* colors = static_cast<const std::uint32_t*>(
      render::instance_colors(tables, instance_, {}, render::PixelFormat::kRgb, arena));
  EXPECT_EQ(colors[16], tables.surface_rgb[64]);
  EXPECT_EQ(colors[96], tables.surface_rgb[207]);
  EXPECT_EQ(colors[200], tables.surface_rgb[200]);
}

}  // namespace
}  // namespace temblor::test
