// Surface blocks that the card builds, next to the CPU's picture.
#include <gtest/gtest.h>

#include <iostream>

#include "render_gl/gl_pictures.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/pictures/deferred_faces.h"
#include "support/pictures/frames.h"
#include "support/pictures/viewpoints.h"

namespace temblor::render_gl {
namespace {

constexpr std::size_t kTwoMegabytes = std::size_t{2} << 20;

test::Viewpoint see_level(const world::Level& level, int number) {
  test::Random random(static_cast<std::uint64_t>(number));
  test::Viewpoint viewpoint{.camera = test::random_camera(level, random),
                            .brush_models = test::shown_brush_models(level),
                            .time_s = random.uniform(0, 100)};
  viewpoint.lights = test::random_lights(viewpoint.camera.origin_world, 3, random);
  return viewpoint;
}

// With opacity, brush models and liquids are translucent in some views.
struct CardBlockViews {
  int count;
  bool with_opacity = true;
  int tolerance = 2;
  CacheOptions cache = {};
};

void compare_card_blocks(const test::DrawableLevel& drawable, const CardBlockViews& views) {
  RENDERER_PAIR_OR_SKIP(pair, drawable, ClipControl::kIfSupported, views.cache);
  pair.gl().set_method(WorldMethod::kCardBlocks);
  double total = 0;
  std::uint32_t drawn = 0, most_portions = 0;
  for (int number = 0; number < views.count; ++number) {
    test::Viewpoint viewpoint = see_level(*drawable.level, number);
    test::Random random(static_cast<std::uint64_t>(number));
    if (number % 2 == 1) viewpoint.marks = test::random_marks(*drawable.level, 20, random);
    if (views.with_opacity && number % 3 == 2)
      for (render::BrushModelInstance& model : viewpoint.brush_models) model.alpha = 0.5f;
    render::Scene scene = viewpoint.scene(*drawable.level);
    if (views.with_opacity)
      scene.liquid_alpha = {.water = 0.5f, .slime = 0.7f, .lava = 0.9f, .teleport = 0.3f};
    if (number % 4 == 3) scene.fog = {.density = 0.2f, .color = {0.8f, 0.5f, 0.2f}};
    const double share = pair.compare(scene, {}, views.tolerance);
    EXPECT_GE(share, 0.98) << drawable.name << ", view " << number;
    total += share;
    drawn += pair.gl().cache_counts().drawn;
    most_portions = std::max(most_portions, pair.gl().cache_counts().portions);
  }
  EXPECT_GE(total / views.count, test::kQuick ? 0.98 : 0.99);
  EXPECT_GT(drawn, 0u);
  std::cout << "[          ] " << drawable.name << ": equal " << total / views.count << ", " << drawn
            << " blocks drawn, up to " << most_portions << " portions\n";
}

TEST(GlCardBlocks, ShowTheCpusPicture) {
  compare_card_blocks(test::small_level(), {.count = test::effort(20, 3)});
  compare_card_blocks(test::with_fences(test::small_level()), {.count = test::effort(10, 2)});
}

TEST(GlCardBlocks, ShowTheCpusPictureOfStockLevels) {
  DATA_FOLDER_OR_SKIP(data);
  for (const char* name : {"start", "lq_e1m2"})
    compare_card_blocks(test::stock_level(data, name), {.count = test::effort(20, 2), .with_opacity = false});
}

TEST(GlCardBlocks, RoundColorsTo16Bits) {
  compare_card_blocks(
      test::small_level(),
      {.count = test::effort(10, 2), .tolerance = 6, .cache = {.format = TexelFormat::k16Bit}});
}

// Caches of any size show the same pictures as one that holds everything, to the last bit.
TEST(GlCardBlocks, FitCachesOfAnySize) {
  const test::DrawableLevel drawable = test::small_level();
  RENDERER_PAIR_OR_SKIP(small, drawable, ClipControl::kIfSupported, CacheOptions{.bytes = kTwoMegabytes});
  RENDERER_PAIR_OR_SKIP(large, drawable);
  std::uint32_t most_portions = 0;
  for (int number = 0; number < test::effort(10, 2); ++number) {
    const test::Viewpoint viewpoint = see_level(*drawable.level, number);
    render::Scene scene = viewpoint.scene(*drawable.level);
    scene.liquid_alpha = {.water = 0.5f, .slime = 0.7f, .lava = 0.9f, .teleport = 0.3f};
    const auto draw = [&](RendererPair& pair) {
      pair.gl().set_method(WorldMethod::kCardBlocks);
      render::FrameBuffer frame(1920, 1080, render::PixelFormat::kRgb);
      const auto drawn = pair.gl().render(scene, {}, frame);
      EXPECT_TRUE(drawn.ok());
      return frame;
    };
    const render::FrameBuffer wanted = draw(large);
    EXPECT_EQ(test::equal_share(draw(small).rgb(), wanted.rgb(), 0), 1.0) << number;
    most_portions = std::max(most_portions, small.gl().cache_counts().portions);
  }
  EXPECT_GT(most_portions, 1u);
}

// A light that moves changes only the blocks that it reaches, or has reached.
TEST(GlCardBlocks, AreDrawnOnceUntilTheirLightChanges) {
  const test::DrawableLevel drawable = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, drawable);
  pair.gl().set_method(WorldMethod::kCardBlocks);
  test::Viewpoint viewpoint = see_level(*drawable.level, 1);
  viewpoint.lights.clear();
  const auto count_drawn = [&] {
    EXPECT_GE(pair.compare(viewpoint.scene(*drawable.level), {}), 0.99);
    return pair.gl().cache_counts().drawn;
  };
  const std::uint32_t all = count_drawn();
  EXPECT_GT(all, 0u);
  EXPECT_EQ(count_drawn(), 0u);
  viewpoint.lights = {{.origin_world = viewpoint.camera.origin_world, .radius = 100}};
  const std::uint32_t reached = count_drawn();
  EXPECT_LT(reached, all);
  EXPECT_EQ(count_drawn(), 0u);
  viewpoint.lights.front().origin_world.x += 8;
  EXPECT_LE(count_drawn(), all);
  viewpoint.lights.clear();
  EXPECT_EQ(count_drawn(), 0u);  // the first blocks are still there
}

// The methods of one renderer may alternate. Blocks in 256 colors take the place of others in the CPU's
// cache.
TEST(GlCardBlocks, AlternateWithOtherMethods) {
  using enum WorldMethod;
  const test::DrawableLevel drawable = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, drawable);
  const test::Viewpoint viewpoint = see_level(*drawable.level, 1);
  for (const WorldMethod method : {kCardBlocks, kBlocks, kStyleLayers, kLightPass, kBlocks, kCardBlocks,
                                   kLitTextures, kStyleLayers, kCardBlocks, kLightPolygons}) {
    pair.gl().set_method(kExpandedBlocks);
    pair.compare(viewpoint.scene(*drawable.level), {});
    pair.gl().set_method(method);
    EXPECT_GE(pair.compare(viewpoint.scene(*drawable.level), {}), method == kLightPolygons ? 0.9 : 0.99);
  }
}

}  // namespace
}  // namespace temblor::render_gl
