// Texture and light in one pass: the engine's picture, pixel by pixel.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "lab/lit_pictures.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/drawable_level.h"

namespace temblor::test {
namespace {

using render::PixelFormat;

void expect_the_engines_pictures(const DrawableLevel& drawable, int views) {
  for (const PixelFormat format : {PixelFormat::kIndexed, PixelFormat::kRgb}) {
    LitPictures engine(drawable, nullptr, format), one_pass(drawable, "one-pass", format);
    for (int seed = 0; seed < views; ++seed) {
      Random random(static_cast<std::uint64_t>(seed));
      const Viewpoint view = make_lit_view(*drawable.level, format, random);
      render::Scene scene = view.scene(*drawable.level);
      if (random.chance(0.3)) scene.fog = {.density = 0.5f, .color = {0.4f, 0.3f, 0.2f}};
      if (random.chance(0.2)) {
        scene.camera.projection = render::Projection::kOrthographic;
        scene.camera.units_per_pixel = 1.5;
      }
      render::Settings settings{.caustics = random.chance(0.5)};
      settings.simd_kernels = random.chance(0.8);
      settings.light_view = random.chance(0.1) ? render::LightView::kLightOnly : render::LightView::kLit;
      EXPECT_EQ(differing_pixels(engine.draw(scene, settings), one_pass.draw(scene, settings)), 0u)
          << drawable.name << ", seed " << seed << (format == PixelFormat::kRgb ? ", rgb" : ", indexed");
    }
  }
}

TEST(OnePass, ShowsTheEnginesPicturesOfTheSmallLevel) {
  for (const SmallLevelVariant& variant : small_level_variants())
    expect_the_engines_pictures(small_level(variant.options, variant.name), effort(15, 3));
}

TEST(OnePass, ShowsTheEnginesPicturesOfStockLevels) {
  DATA_FOLDER_OR_SKIP(data);
  for (const char* const name : {"start", "lq_e1m2"})
    expect_the_engines_pictures(stock_level(data, name), effort(15, 3));
}

TEST(OnePass, IsTheSameForAnyThreadsAndBands) {
  for (const char* const technique : {"one-pass", "one-pass:bilinear=0"})
    expect_same_for_any_threads(technique);
}

// Light from the nearest sample is another picture, but its texels are the same: without light, both are.
TEST(OnePass, TakesTheNearestSample) {
  const DrawableLevel drawable = small_level();
  Random random(2);
  const Viewpoint view = make_lit_view(*drawable.level, PixelFormat::kRgb, random);
  const render::Scene scene = view.scene(*drawable.level);
  LitPictures engine(drawable, nullptr, PixelFormat::kRgb),
      nearest(drawable, "one-pass:bilinear=0", PixelFormat::kRgb);
  EXPECT_NE(engine.draw(scene, {}), nearest.draw(scene, {}));
  const DrawableLevel dark = small_level({.light = false}, "dark");
  const Viewpoint dark_view{.camera = view.camera};
  const render::Scene dark_scene = dark_view.scene(*dark.level);
  LitPictures dark_engine(dark, nullptr, PixelFormat::kRgb),
      dark_nearest(dark, "one-pass:bilinear=0", PixelFormat::kRgb);
  EXPECT_EQ(dark_engine.draw(dark_scene, {}), dark_nearest.draw(dark_scene, {}));
}

TEST(OnePass, AllocatesNothingInAWarmFrame) {
  expect_no_allocations_in_a_warm_frame("one-pass");
}

// When the engine draws again, it builds the surfaces that one-pass did without.
TEST(OnePass, LeavesNoEmptySurfacesBehind) {
  const DrawableLevel drawable = small_level();
  Random random(4);
  const Viewpoint view = make_lit_view(*drawable.level, PixelFormat::kRgb, random);
  const render::Scene scene = view.scene(*drawable.level);
  LitPictures engine(drawable, nullptr, PixelFormat::kRgb);
  render::Renderer renderer(drawable.palette, drawable.colormap);
  render::FrameBuffer frame(333, 203, PixelFormat::kRgb);
  renderer.replace_stages(lab::parse_choice("one-pass").value().make_stages());
  renderer.render(scene, {}, frame);
  renderer.replace_stages({});
  renderer.render(scene, {}, frame);
  EXPECT_EQ(copy_picture(frame), engine.draw(scene, {}));
}

}  // namespace
}  // namespace temblor::test
