// The end of a frame on the graphics card: the warp and the tint against the CPU's stages, pixel by pixel,
// and lines next to the CPU's picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/common.hpp>
#include <iostream>
#include <utility>

#include "render/screen/tint_picture.h"
#include "render/screen/warp.h"
#include "render_gl/gl_pictures.h"
#include "render_gl/scene_views.h"
#include "support/effort.h"

namespace temblor::render_gl {
namespace {

// The others lie at edges of the level's faces.
constexpr double kScreenEqualShare = 0.9995;

render::FrameBuffer draw(GlRenderer& gl, const render::Scene& scene, int width, int height) {
  render::FrameBuffer frame(width, height, render::PixelFormat::kRgb);
  const auto drawn = gl.render(scene, {}, frame);
  CHECK(drawn.ok(), "{}", drawn.error().what);
  return frame;
}

bool are_equal(const render::FrameBuffer& a, const render::FrameBuffer& b) {
  return std::ranges::equal(a.rgb(), b.rgb());
}

// The card's picture without both, finished by the CPU, is the card's picture with both.
TEST(GlScreen, WarpsAndTintsExactlyAsTheCpu) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  base::Jobs jobs(1);
  render::Warp warp;
  test::Random random(1);
  const std::pair<int, int> sizes[] = {{320, 200}, {333, 217}, {1280, 720}, {90, 160},
                                       {1, 1},     {2, 7},     {40, 1},     {640, 480}};
  for (const auto& [width, height] : sizes)
    for (const float opacity : {-1.0f, 0.0f, 0.001f, 0.002f, 0.3f, 0.5f, 0.77f, 1.0f})
      for (const double time_s : {0.0, 1.7, 1e6}) {
        SceneView view = any_view(*level.level, random);
        view.scene.time_s = time_s;
        render::FrameBuffer expected = draw(pair.gl(), view.scene, width, height);
        const render::Tint tint{(random.in_cube(127) + 128.0f), opacity};
        view.scene.tint = tint;
        view.scene.underwater = random.chance(0.7);
        const render::PictureTint picture_tint(tint, render::PixelFormat::kRgb, true);
        if (view.scene.underwater)
          warp.apply(time_s, picture_tint, jobs, expected);
        else
          tint_picture(picture_tint, jobs, expected);
        EXPECT_TRUE(are_equal(draw(pair.gl(), view.scene, width, height), expected))
            << width << "x" << height << ", " << opacity << ", " << time_s;
      }
}

TEST(GlScreen, ShowsTheCpusPictureUnderWater) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  for (int number = 0; number < test::effort(10, 2); ++number) {
    test::Random random(static_cast<std::uint64_t>(number));
    SceneView view = any_view(*level.level, random);
    view.scene.underwater = true;
    view.scene.time_s = random.uniform(0, 100);
    view.scene.tint = {{130, 80, 50}, number % 2 == 0 ? 0.5f : 0.0f};
    EXPECT_GE(pair.compare(view.scene, {}), kScreenEqualShare) << number;
  }
}

// Translucent layers, too.
TEST(GlScreen, LeavesAlphaAt255) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  for (int number = 0; number < test::effort(20, 4); ++number) {
    test::Random random(static_cast<std::uint64_t>(number));
    SceneView view = any_view(*level.level, random);
    for (render::BrushModelInstance& model : view.viewpoint.brush_models) model.alpha = 0.4f;
    view.scene.liquid_alpha = {.water = 0.5f, .slime = 0.7f, .lava = 0.9f, .teleport = 0.3f};
    view.scene.underwater = number % 4 == 1;
    const render::FrameBuffer frame = draw(pair.gl(), view.scene, 320, 200);
    for (const std::uint32_t pixel : frame.rgb()) ASSERT_EQ(pixel >> 24, 255u) << number;
  }
}

std::vector<render::Line> make_lines(std::size_t count, const render::Scene& scene, test::Random& io_random) {
  std::vector<render::Line> lines;
  const auto point = [&] { return point_in_view(scene, io_random.log_uniform(0.1, 600), 1.2, io_random); };
  const auto channel = [&] { return static_cast<std::uint8_t>(io_random.bits()); };
  while (lines.size() < count) {
    render::Line line{point(), point(), {channel(), channel(), channel()}, io_random.chance(0.7)};
    if (io_random.chance(0.2)) line.to_world = scene.camera.origin_world + io_random.in_cube(300);
    if (io_random.chance(0.1)) line.to_world = line.from_world;
    if (io_random.chance(0.2)) line.to_world.z = line.from_world.z;
    lines.push_back(line);
  }
  return lines;
}

TEST(GlScreen, ShowsTheCpusLines) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  for (int number = 0; number < test::effort(30, 3); ++number) {
    test::Random random(static_cast<std::uint64_t>(number));
    SceneView view = any_view(*level.level, random);
    if (number % 3 == 1) {
      view.scene.camera.projection = render::Projection::kOrthographic;
      view.scene.camera.units_per_pixel = 0.7f;
    }
    view.scene.underwater = number % 3 == 2;
    view.scene.tint = {{130, 80, 50}, number % 2 == 0 ? 0.5f : 0.0f};
    const std::vector<render::Line> lines = make_lines(300, view.scene, random);
    view.scene.lines = lines;
    EXPECT_GE(pair.compare(view.scene, {.fill_depth = true}), number % 3 == 1 ? 0.999 : kScreenEqualShare)
        << number;
  }
}

// Lines over a black picture, so that all pixels that differ are those of lines: with a level eye,
// many of them lie exactly between two rows.
TEST(GlScreen, DrawsLinesThroughTheSamePixels) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  std::size_t drawn = 0, different = 0;
  for (int number = 0; number < test::effort(30, 3); ++number) {
    test::Random random(static_cast<std::uint64_t>(number));
    SceneView view = any_view(*level.level, random);
    view.scene.tint = {{0, 0, 0}, 1.0f};
    view.scene.camera.angles_deg = {0, 90.0f * static_cast<float>(number % 4), 0};
    std::vector<render::Line> lines;
    for (int i = 0; i < 40; ++i) {
      const auto whole = [&] {
        return view.scene.camera.origin_world + math::Vec3(glm::round(random.in_cube(40)));
      };
      lines.push_back({whole(), whole(), {255, 255, 255}});
      if (i % 2 == 0) lines.back().to_world.z = lines.back().from_world.z = view.scene.camera.origin_world.z;
    }
    view.scene.lines = lines;
    pair.compare(view.scene, {});
    for (std::size_t i = 0; i < pair.cpu_frame().pixel_count(); ++i) {
      drawn += pair.cpu_frame().rgb()[i] != 0xff000000u;
      different += pair.cpu_frame().rgb()[i] != pair.gl_frame().rgb()[i];
    }
  }
  EXPECT_GT(drawn, static_cast<std::size_t>(test::effort(10000, 1000)));
  EXPECT_LE(different, drawn / 100);
  std::cout << "[          ] " << different << " of " << drawn << " pixels differ\n";
}

}  // namespace
}  // namespace temblor::render_gl
