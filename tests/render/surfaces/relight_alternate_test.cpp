// Relighting in alternate frames: which light each face shows, whatever was drawn before; and that each frame
// builds about half of what changed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <vector>

#include "render/renderer.h"
#include "support/game_data.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/frames.h"
#include "support/pictures/viewpoints.h"

namespace temblor::test {
namespace {

using render::PixelFormat;

constexpr render::Settings kAlternate{.relight_alternate = true};

// One view under two lights.
struct TwoLights {
  Viewpoint now, before;
  render::SceneLight light_before;
  render::Scene scene_now, scene_before;

  TwoLights(const world::Level& level, const render::Camera& camera, Random& io_random) {
    now = {.camera = camera, .brush_models = shown_brush_models(level), .time_s = 0.4};
    before = now;
    now.lights = random_lights(camera.origin_world, 4, io_random);
    before.lights = random_lights(camera.origin_world, 4, io_random);
    scene_now = now.scene(level);
    scene_before = before.scene(level);
    scene_before.light_styles.fill(200);
    light_before = {before.lights, scene_before.light_styles};
    scene_now.light_before = &light_before;
  }
};

FrameCopy drawn(render::Renderer& io_renderer, const render::Scene& scene, const render::Settings& settings,
                PixelFormat format, render::FrameStats* out_stats = nullptr) {
  render::FrameBuffer frame(320, 200, format);
  const render::FrameStats stats = io_renderer.render(scene, settings, frame);
  if (out_stats != nullptr) *out_stats = stats;
  return copy_picture(frame);
}

void expect_faces_in_turn(const DrawableLevel& drawable, int views) {
  render::Renderer renderer(drawable.palette, drawable.colormap);
  const render::Settings no_cache{.surface_cache = false, .relight_alternate = true};
  std::size_t today = 0, yesterday = 0;
  for (int number = 0; number < views; ++number) {
    Random random(static_cast<std::uint64_t>(number));
    const render::Camera camera = random_camera(*drawable.level, random);
    TwoLights two(*drawable.level, camera, random);
    const FrameCopy now = drawn(renderer, two.scene_now, {}, PixelFormat::kRgb);
    const FrameCopy before = drawn(renderer, two.scene_before, {}, PixelFormat::kRgb);
    std::vector<render::PixelFace> faces(now.rgb.size());
    std::vector<std::uint8_t> writes(now.rgb.size());
    renderer.pixel_faces(faces, writes);
    for (std::uint32_t frame = 0; frame < 2; ++frame) {
      SCOPED_TRACE(fmt::format("{}, view {}, frame {}", drawable.name, number, frame));
      two.scene_now.frame_number = frame;
      const FrameCopy alternate = drawn(renderer, two.scene_now, kAlternate, PixelFormat::kRgb);
      for (std::size_t i = 0; i < faces.size(); ++i) {
        const bool in_turn = (faces[i].face + frame) % 2 == 0;
        ASSERT_EQ(alternate.rgb[i], (in_turn ? now : before).rgb[i]);
        if (now.rgb[i] != before.rgb[i]) ++(in_turn ? today : yesterday);
      }
      EXPECT_TRUE(drawn(renderer, two.scene_now, no_cache, PixelFormat::kRgb) == alternate);
    }
  }
  EXPECT_GT(today, 10000u);
  EXPECT_GT(yesterday, 10000u);
}

TEST(RelightAlternate, ShowsEachFaceInTheLightOfItsTurn) {
  expect_faces_in_turn(small_level(), 12);
}
TEST(RelightAlternate, ShowsEachFaceOfAStockLevelInTheLightOfItsTurn) {
  DATA_FOLDER_OR_SKIP(data);
  expect_faces_in_turn(stock_level(data, "lq_e0m1"), 12);
}

// Like a game: each frame passes its light to the next one.
TEST(RelightAlternate, BuildsHalfOfTheSurfacesInEachFrame) {
  DATA_FOLDER_OR_SKIP(data);
  const DrawableLevel drawable = stock_level(data, "lq_e1m2");
  render::Renderer renderer(drawable.palette, drawable.colormap);
  const Viewpoint viewpoint{.camera = player_cameras(*drawable.level)[0]};
  render::Scene scene = viewpoint.scene(*drawable.level);
  render::FrameStats stats;
  std::vector<std::uint32_t> built;
  render::SceneLight before;
  std::uint32_t all = 0;
  for (std::uint32_t frame = 0; frame < 8; ++frame) {
    scene.light_styles.fill(static_cast<std::uint16_t>(200 + 10 * frame));
    drawn(renderer, scene, {}, PixelFormat::kIndexed, &stats);
    all = stats.surfaces_built;
  }
  renderer.drop_surfaces();
  for (std::uint32_t frame = 0; frame < 8; ++frame) {
    scene.light_styles.fill(static_cast<std::uint16_t>(200 + 10 * frame));
    scene.frame_number = frame;
    scene.light_before = frame > 0 ? &before : nullptr;
    drawn(renderer, scene, kAlternate, PixelFormat::kIndexed, &stats);
    if (frame > 1) built.push_back(stats.surfaces_built);
    before.light_styles = scene.light_styles;
  }
  ASSERT_GT(all, 40u);
  for (std::size_t frame = 1; frame < built.size(); ++frame) {
    EXPECT_EQ(built[frame - 1] + built[frame], all);
    EXPECT_NEAR(built[frame], all / 2.0, all / 4.0);
  }
}

TEST(RelightAlternate, WithoutALightBeforeShowsTodays) {
  const DrawableLevel drawable = small_level();
  render::Renderer renderer(drawable.palette, drawable.colormap);
  Random random(1);
  const render::Camera camera = random_camera(*drawable.level, random);
  TwoLights two(*drawable.level, camera, random);
  two.scene_now.light_before = nullptr;
  EXPECT_TRUE(drawn(renderer, two.scene_now, {}, PixelFormat::kRgb) ==
              drawn(renderer, two.scene_now, kAlternate, PixelFormat::kRgb));
}

}  // namespace
}  // namespace temblor::test
