// Views that are drawn at once are the pictures that render() draws of each alone.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "render/renderer.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/frames.h"
#include "support/pictures/viewpoints.h"

namespace temblor::test {
namespace {

constexpr int kViewsAtOnce = effort(9, 5);

// Two skyboxes whose sides have colors of their own; the second lacks one.
std::vector<render::Skybox> make_skyboxes() {
  std::vector<render::Skybox> skyboxes(2);
  for (std::size_t box = 0; box < skyboxes.size(); ++box)
    for (std::size_t side = box; side < skyboxes[box].sides.size(); ++side) {
      formats::Image& image = skyboxes[box].sides[side];
      image.width = image.height = 4;
      image.pixels.assign(16, static_cast<std::uint32_t>(0xff00005a | (40 * side << 16) | (200 * box << 8)));
    }
  return skyboxes;
}

// Scenes that differ in everything a view may have of its own, in frames of different sizes.
class Views {
 public:
  Views(const DrawableLevel& drawable, int count) : skyboxes_(make_skyboxes()) {
    Random random(7);
    for (int i = 0; i < count; ++i)
      viewpoints_.push_back({.camera = random_camera(*drawable.level, random),
                             .brush_models = shown_brush_models(*drawable.level),
                             .time_s = random.uniform(0, 100)});
    for (int i = 0; i < count; ++i) {
      Viewpoint& viewpoint = viewpoints_[static_cast<std::size_t>(i)];
      if (i % 2 == 1) displace(*drawable.level, viewpoint.brush_models, random);
      if (i % 3 == 1) viewpoint.lights = random_lights(viewpoint.camera.origin_world, 4, random);
      if (i % 3 == 2) viewpoint.marks = random_marks(*drawable.level, drawable.level->faces.size(), random);
      render::Scene& scene = scenes_.emplace_back(viewpoint.scene(*drawable.level));
      if (i % 3 != 0) scene.skybox = &skyboxes_[static_cast<std::size_t>(i % 3 - 1)];
      if (i % 4 == 1) scene.fog = {0.2f, {0.9f, 0.1f * static_cast<float>(i), 0.3f}};
      if (i % 4 == 2) scene.tint = {{255, 128, 0}, 0.3f};
      scene.underwater = i % 4 == 3;
    }
  }
  std::vector<render::FrameBuffer> make_frames(render::PixelFormat format) const {
    std::vector<render::FrameBuffer> frames;
    for (std::size_t i = 0; i < scenes_.size(); ++i) {
      const int grown = static_cast<int>(i) * 5;
      frames.emplace_back(80 + grown, 61 - grown / 2, format);
      fill_frame(frames.back(), 0x5a);
    }
    return frames;
  }
  const std::vector<render::Scene>& scenes() const { return scenes_; }

 private:
  std::vector<render::Skybox> skyboxes_;
  std::vector<Viewpoint> viewpoints_;
  std::vector<render::Scene> scenes_;
};

std::vector<FrameCopy> draw_at_once(render::Renderer& io_renderer, const Views& views,
                                    const render::Settings& settings, render::PixelFormat format) {
  std::vector<render::FrameBuffer> frames = views.make_frames(format);
  std::vector<render::View> drawn;
  for (std::size_t i = 0; i < frames.size(); ++i) drawn.push_back({&views.scenes()[i], &frames[i]});
  io_renderer.render_views(drawn, settings);
  std::vector<FrameCopy> copies;
  for (const render::FrameBuffer& frame : frames) copies.push_back(copy_picture(frame));
  return copies;
}

std::vector<FrameCopy> draw_one_by_one(const DrawableLevel& drawable, const Views& views,
                                       const render::Settings& settings, render::PixelFormat format) {
  std::vector<render::FrameBuffer> frames = views.make_frames(format);
  std::vector<FrameCopy> copies;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    render::Renderer renderer(drawable.palette, drawable.colormap);
    renderer.render(views.scenes()[i], settings, frames[i]);
    copies.push_back(copy_picture(frames[i]));
  }
  return copies;
}

void expect_same(const std::vector<FrameCopy>& expected, const std::vector<FrameCopy>& drawn,
                 const std::string& what) {
  ASSERT_EQ(expected.size(), drawn.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_TRUE(expected[i] == drawn[i])
        << what << ", view " << i << ": " << differing_pixels(expected[i], drawn[i]) << " pixels differ";
}

constexpr auto kFormatsOfViews = {render::PixelFormat::kIndexed, render::PixelFormat::kRgb};

std::vector<render::Settings> settings_of_views() {
  const auto std_thread = base::JobBackend::kStdThread;
  return {{.threads = 0},
          {.threads = 2},
          {.threads = 8, .job_backend = std_thread},
          {.threads = 8, .job_backend = std_thread, .cache_bytes = 20000},
          {.threads = 8, .job_backend = std_thread, .surface_cache = false}};
}

// The pictures of a fresh renderer, whatever the threads and the cache, and whatever was drawn before.
void expect_pictures_of_render(const DrawableLevel& drawable) {
  const Views views(drawable, kViewsAtOnce), fewer(drawable, kViewsAtOnce / 2);
  for (const render::PixelFormat format : kFormatsOfViews) {
    const std::vector<FrameCopy> expected = draw_one_by_one(drawable, views, {}, format);
    const std::vector<FrameCopy> expected_fewer = draw_one_by_one(drawable, fewer, {}, format);
    for (const render::Settings& settings : settings_of_views()) {
      render::Renderer renderer(drawable.palette, drawable.colormap);
      const std::string what = fmt::format("{}, {} threads, a cache of {} bytes", drawable.name,
                                           settings.threads, settings.cache_bytes);
      expect_same(expected, draw_at_once(renderer, views, settings, format), what);
      expect_same(expected_fewer, draw_at_once(renderer, fewer, settings, format), what + ", fewer");
      expect_same(expected, draw_at_once(renderer, views, settings, format), what + ", all again");
    }
  }
}

TEST(ViewsSamePicture, AsOneByOne) {
  expect_pictures_of_render(small_level({.four_styles = true, .colored_light = true}));
}

TEST(ViewsSamePicture, AsOneByOneInAStockLevel) {
  DATA_FOLDER_OR_SKIP(data);
  expect_pictures_of_render(stock_level(data, "lq_e1m2"));
}

// A frame drawn alone, and one with other settings, between views.
TEST(ViewsSamePicture, BesideFramesDrawnAlone) {
  const DrawableLevel drawable = small_level({.colored_light = true});
  const Views views(drawable, 3);
  for (const render::PixelFormat format : kFormatsOfViews) {
    const std::vector<FrameCopy> expected = draw_one_by_one(drawable, views, {}, format);
    const std::vector<FrameCopy> mips =
        draw_one_by_one(drawable, views, {.show = render::Show::kMips}, format);
    render::Renderer renderer(drawable.palette, drawable.colormap);
    const auto draw_alone = [&](std::size_t number) {
      std::vector<render::FrameBuffer> frames = views.make_frames(format);
      renderer.render(views.scenes()[number], {}, frames[number]);
      return copy_picture(frames[number]);
    };
    EXPECT_TRUE(draw_alone(1) == expected[1]);
    expect_same(expected, draw_at_once(renderer, views, {}, format), "after one alone");
    expect_same(mips, draw_at_once(renderer, views, {.show = render::Show::kMips}, format), "mip levels");
    EXPECT_TRUE(draw_alone(2) == expected[2]);
  }
}

TEST(RenderViews, BuildASurfaceOnceThatSeveralShow) {
  const DrawableLevel drawable = small_level();
  Random random(3);
  const Viewpoint viewpoint{.camera = random_camera(*drawable.level, random)};
  const render::Scene scene = viewpoint.scene(*drawable.level);
  const auto make_frame = [] { return render::FrameBuffer(160, 120, render::PixelFormat::kRgb); };
  render::FrameBuffer first = make_frame(), second = make_frame(), third = make_frame();
  render::Renderer alone(drawable.palette, drawable.colormap), renderer(drawable.palette, drawable.colormap);
  const render::FrameStats expected = alone.render(scene, {}, first);
  ASSERT_GT(expected.surfaces_built, 0u);
  const std::vector<render::View> views = {{&scene, &first}, {&scene, &second}};
  renderer.render_views(views, {.threads = 2});
  const render::FrameStats after = renderer.render(scene, {}, third);
  EXPECT_EQ(after.surfaces_built, 0u);
  EXPECT_EQ(after.cache_hits, expected.surfaces);
  EXPECT_EQ(after.cache_bytes, expected.cache_bytes);
}

TEST(RenderViews, DrawNothingWithoutViews) {
  const DrawableLevel drawable = small_level();
  render::Renderer renderer(drawable.palette, drawable.colormap);
  renderer.render_views({}, {.threads = 2});
}

TEST(RenderViewsDeathTest, RefuseTwoLevelsOrFormats) {
  const DrawableLevel drawable = small_level(), other = small_level({.tiny = true});
  Random random(3);
  const Viewpoint viewpoint{.camera = random_camera(*drawable.level, random)};
  const render::Scene scene = viewpoint.scene(*drawable.level), elsewhere = viewpoint.scene(*other.level);
  render::FrameBuffer rgb(8, 8, render::PixelFormat::kRgb), indexed(8, 8, render::PixelFormat::kIndexed);
  render::FrameBuffer rgb_again(8, 8, render::PixelFormat::kRgb);
  render::Renderer renderer(drawable.palette, drawable.colormap);
  const std::vector<render::View> two_levels = {{&scene, &rgb}, {&elsewhere, &rgb_again}};
  const std::vector<render::View> two_formats = {{&scene, &rgb}, {&scene, &indexed}};
  EXPECT_DEATH(renderer.render_views(two_levels, {}), "views of two levels");
  EXPECT_DEATH(renderer.render_views(two_formats, {}), "views in two formats");
}

}  // namespace
}  // namespace temblor::test
