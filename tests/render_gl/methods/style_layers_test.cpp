// Light that the shader adds (WorldMethod::kStyleLayers), next to the CPU's picture, and to that of light
// that the CPU adds.
#include <gtest/gtest.h>

#include <iostream>

#include "render_gl/methods/method_views.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/pictures/frames.h"

namespace temblor::render_gl {
namespace {

constexpr ViewContents kAllLight{
    .lights = 6, .with_marks = true, .with_fog = true, .with_opacity = true, .with_styles = true};

render::FrameBuffer draw(RendererPair& pair, WorldMethod method, const render::Scene& scene) {
  pair.gl().set_method(method);
  render::FrameBuffer frame(640, 480, render::PixelFormat::kRgb);
  const auto drawn = pair.gl().render(scene, {}, frame);
  EXPECT_TRUE(drawn.ok());
  return frame;
}

void check_style_layers(const test::DrawableLevel& drawable, int views, const ViewContents& contents) {
  RENDERER_PAIR_OR_SKIP(pair, drawable);
  const EqualShares shares = compare_views(pair, drawable, WorldMethod::kStyleLayers, views, contents);
  EXPECT_GE(shares.mean, test::kQuick ? 0.98 : 0.998);
  EXPECT_GE(shares.worst, 0.98);
  double worst = 1;
  for (int number = 0; number < views; ++number) {
    const NumberedView view(*drawable.level, number, contents);
    const render::FrameBuffer summed = draw(pair, WorldMethod::kLitTextures, view.scene);
    const render::FrameBuffer layers = draw(pair, WorldMethod::kStyleLayers, view.scene);
    worst = std::min(worst, test::equal_share(summed.rgb(), layers.rgb(), 1));
  }
  std::cout << "[          ] " << drawable.name << ": equal to lit textures " << worst << " or more\n";
  EXPECT_GE(worst, 0.998);
}

TEST(GlStyleLayers, ShowTheCpusPicture) {
  for (const test::SmallLevelVariant& variant : test::small_level_variants())
    check_style_layers(test::small_level(variant.options, variant.name), test::effort(5, 1), kAllLight);
}

TEST(GlStyleLayers, ShowTheCpusPictureOfStockLevels) {
  DATA_FOLDER_OR_SKIP(data);
  for (const char* name : {"start", "lq_e1m2"})
    check_style_layers(test::stock_level(data, name), test::effort(20, 2), {.with_styles = true});
}

// Lights are where the CPU sees them on models that have moved and turned.
TEST(GlStyleLayers, LightBrushModelsThatMove) {
  const test::DrawableLevel drawable = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, drawable);
  const EqualShares shares = compare_views(pair, drawable, WorldMethod::kStyleLayers, test::effort(20, 2),
                                           {.lights = 40, .with_turns = true});
  EXPECT_GE(shares.mean, test::kQuick ? 0.98 : 0.998);
  EXPECT_GE(shares.worst, 0.98);
}

// Styles and lights change in every frame. With blocks or grids, all of this light is uploaded again.
TEST(GlStyleLayers, UploadNothingAfterTheFirstFrame) {
  const test::DrawableLevel drawable = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, drawable);
  const auto count_bytes = [&](WorldMethod method) {
    pair.gl().set_method(method);
    std::uint64_t first = 0, later = 0;
    for (int frame = 0; frame < 5; ++frame) {
      NumberedView view(*drawable.level, 1, {.lights = 0});
      test::Random random(static_cast<std::uint64_t>(frame));
      view.scene.light_styles.fill(static_cast<std::uint16_t>(100 + 20 * frame));
      view.viewpoint.lights = test::random_lights(view.viewpoint.camera.origin_world, 5, random);
      view.scene.lights = view.viewpoint.lights;
      EXPECT_GE(pair.compare(view.scene, {}), 0.99) << "frame " << frame;
      (frame == 0 ? first : later) += pair.gl().cache_counts().bytes_uploaded;
    }
    EXPECT_GT(first, 0u);
    return later;
  };
  EXPECT_EQ(count_bytes(WorldMethod::kStyleLayers), 0u);
  EXPECT_GT(count_bytes(WorldMethod::kLitTextures), 10000u);
  EXPECT_GT(count_bytes(WorldMethod::kBlocks), 100000u);
}

// The CPU composes what the shader cannot.
TEST(GlStyleLayers, LeaveOtherLightToTheCpu) {
  const test::DrawableLevel drawable = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, drawable);
  pair.gl().set_method(WorldMethod::kStyleLayers);
  for (int number = 0; number < test::effort(12, 4); ++number) {
    const NumberedView view(*drawable.level, number, kAllLight);
    render::Settings settings;
    settings.caustics = number % 4 == 0;
    settings.light_view = static_cast<render::LightView>(number % 3);
    settings.colored_light = number % 2 == 0;
    settings.relight_alternate = number % 4 == 3;
    EXPECT_GE(pair.compare(view.scene, settings), 0.99) << "view " << number;
  }
}

}  // namespace
}  // namespace temblor::render_gl
