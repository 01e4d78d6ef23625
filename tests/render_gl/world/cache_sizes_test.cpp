// Caches of any size on the graphics card: how a frame is drawn does not change its picture.
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

constexpr std::size_t kMegabyte = std::size_t{1} << 20;

struct Size {
  int width, height;
};
constexpr Size kSizes[] = {{320, 200}, {640, 480}, {1920, 1080}};

// A view with moved brush models, some of which are translucent, as are liquids.
test::Viewpoint make_view(const world::Level& level, int number) {
  test::Random random(static_cast<std::uint64_t>(number));
  test::Viewpoint viewpoint{.camera = test::random_camera(level, random),
                            .brush_models = test::shown_brush_models(level),
                            .time_s = random.uniform(0, 100)};
  viewpoint.lights = test::random_lights(viewpoint.camera.origin_world, 3, random);
  if (number % 2 == 1)
    for (render::BrushModelInstance& model : viewpoint.brush_models)
      model.alpha = static_cast<float>(random.uniform(0.2, 1));
  return viewpoint;
}

render::Scene see(const test::Viewpoint& viewpoint, const world::Level& level) {
  render::Scene scene = viewpoint.scene(level);
  scene.liquid_alpha = {.water = 0.5f, .slime = 0.7f, .lava = 0.9f, .teleport = 0.3f};
  return scene;
}

// The renderers of all sizes have seen the same frames before.
void expect_equal_pictures(const test::DrawableLevel& drawable, int views) {
  RENDERER_PAIR_OR_SKIP(tiny, drawable, ClipControl::kIfSupported, CacheOptions{.bytes = 1 << 17});
  RENDERER_PAIR_OR_SKIP(two, drawable, ClipControl::kIfSupported, CacheOptions{.bytes = 2 * kMegabyte});
  RENDERER_PAIR_OR_SKIP(four, drawable, ClipControl::kIfSupported, CacheOptions{.bytes = 4 * kMegabyte});
  RENDERER_PAIR_OR_SKIP(large, drawable);
  std::uint32_t most_portions = 0, most_evicted = 0;
  for (const Size size : kSizes)
    for (int number = 0; number < views; ++number) {
      const test::Viewpoint viewpoint = make_view(*drawable.level, number);
      const render::Scene scene = see(viewpoint, *drawable.level);
      const auto draw = [&](RendererPair& pair) {
        render::FrameBuffer frame(size.width, size.height, render::PixelFormat::kRgb);
        const auto drawn = pair.gl().render(scene, {}, frame);
        EXPECT_TRUE(drawn.ok());
        return frame;
      };
      const render::FrameBuffer wanted = draw(large);
      for (RendererPair* pair : {&four, &two})
        EXPECT_EQ(test::equal_share(draw(*pair).rgb(), wanted.rgb(), 0), 1.0)
            << drawable.name << " " << size.width << ", view " << number;
      draw(tiny);  // shows larger images at a half of their size or less
      EXPECT_EQ(large.gl().cache_counts().portions, 1u);
      EXPECT_GE(tiny.gl().cache_counts().portions, two.gl().cache_counts().portions);
      most_portions = std::max(most_portions, two.gl().cache_counts().portions);
      most_evicted = std::max(most_evicted, two.gl().cache_counts().evicted);
    }
  std::cout << "[          ] " << drawable.name << ": up to " << most_portions << " portions, "
            << most_evicted << " images evicted\n";
  EXPECT_GT(most_portions, 1u);
}

TEST(GlCacheSizes, ShowTheSamePicturesOfTheSmallLevel) {
  expect_equal_pictures(test::small_level(), test::effort(10, 2));
}

TEST(GlCacheSizes, ShowTheSamePicturesOfAStockLevel) {
  DATA_FOLDER_OR_SKIP(data);
  expect_equal_pictures(test::stock_level(data, "lq_e1m2"), test::effort(10, 2));
}

TEST(GlCacheSizes, ShowTheSamePicturesOfFences) {
  expect_equal_pictures(test::with_fences(test::small_level()), test::effort(10, 2));
}

// A frame that was drawn before is in the cache.
TEST(GlCacheSizes, KeepWhatWasDrawn) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  const test::Viewpoint viewpoint = make_view(*level.level, 1);
  const render::Scene scene = see(viewpoint, *level.level);
  pair.compare(scene, {});
  const CacheCounts first = pair.gl().cache_counts();
  EXPECT_GT(first.uploads, 0u);
  EXPECT_GT(first.bytes_uploaded, 0u);
  pair.compare(scene, {});
  const CacheCounts second = pair.gl().cache_counts();
  EXPECT_EQ(second.uploads, 0u);
  EXPECT_EQ(second.hits, first.hits + first.uploads);
  EXPECT_EQ(second.evicted, 0u);
}

// 5 bits have steps of 8.2, 6 bits half of them; the blend of a translucent face keeps that.
TEST(GlCacheSizes, RoundColorsTo16Bits) {
  for (const test::DrawableLevel& level : {test::small_level(), test::with_fences(test::small_level())}) {
    RENDERER_PAIR_OR_SKIP(pair, level, ClipControl::kIfSupported,
                          CacheOptions{.bytes = 2 * kMegabyte, .format = TexelFormat::k16Bit});
    EXPECT_LE(pair.gl().cache_bytes(), 2 * kMegabyte);
    for (int number = 0; number < test::effort(10, 2); ++number) {
      const test::Viewpoint viewpoint = make_view(*level.level, number);
      const render::Scene scene = see(viewpoint, *level.level);
      EXPECT_GE(pair.compare(scene, {}, 6), 0.99) << level.name << ", view " << number;
    }
  }
}

}  // namespace
}  // namespace temblor::render_gl
