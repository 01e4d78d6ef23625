// Pictures do not depend on threads, kernels, the surface cache and its contents, or the division into bands.
#include <gtest/gtest.h>

#include <memory>
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

constexpr int kSameViews = effort(12, 2);
constexpr int kSameWidth = effort(333, 133),
              kSameHeight = effort(211, 67);  // not multiples of what kernels, bands and blocks work in

struct NamedSettings {
  std::string name;
  render::Settings settings;
};

std::vector<NamedSettings> settings_of_one_picture() {
  std::vector<NamedSettings> all;
  const auto add = [&](const std::string& name, auto set) {
    set(all.emplace_back(NamedSettings{name, {}}).settings);
  };
  for (const int threads : {2, 8}) {
    for (const base::JobBackend backend : {base::JobBackend::kOneTbb, base::JobBackend::kStdThread})
      add(fmt::format("{} threads of {}", threads, backend == base::JobBackend::kOneTbb ? "oneTBB" : "std"),
          [&](render::Settings& settings) {
            settings.threads = threads;
            settings.job_backend = backend;
          });
  }
  for (const int rows : {1, 7, 64, kSameHeight})
    add(fmt::format("bands of {} rows", rows),
        [&](render::Settings& settings) { settings.band_rows = rows; });
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{20000}, std::size_t{1} << 20})
    add(fmt::format("a cache of {} bytes", bytes),
        [&](render::Settings& settings) { settings.cache_bytes = bytes; });
  add("plain kernels", [](render::Settings& settings) { settings.simd_kernels = false; });
  add("no prefetching", [](render::Settings& settings) { settings.prefetch = false; });
  add("no cache", [](render::Settings& settings) { settings.surface_cache = false; });
  add("all of it", [](render::Settings& settings) {
    settings.threads = 8;
    settings.band_rows = 7;
    settings.cache_bytes = 20000;
    settings.simd_kernels = false;
  });
  return all;
}

Viewpoint make_viewpoint(const world::Level& level, int number) {
  Random random(static_cast<std::uint64_t>(number));
  Viewpoint viewpoint{.camera = random_camera(level, random),
                      .brush_models = shown_brush_models(level),
                      .time_s = random.uniform(0, 100)};
  if (number % 2 == 1) displace(level, viewpoint.brush_models, random);
  if (number % 3 == 1) viewpoint.lights = random_lights(viewpoint.camera.origin_world, 4, random);
  if (number % 3 == 2) viewpoint.marks = random_marks(level, 2 * level.faces.size(), random);
  if (number % 5 == 4) viewpoint.camera.projection = render::Projection::kOrthographic;
  return viewpoint;
}

// Draws with `io_renderer` into a frame filled with garbage.
FrameCopy draw(render::Renderer& io_renderer, const render::Scene& scene, const render::Settings& settings,
               render::PixelFormat format) {
  render::FrameBuffer frame(kSameWidth, kSameHeight, format);
  fill_frame(frame, 0x5a);
  io_renderer.render(scene, settings, frame);
  return copy_picture(frame);
}

FrameCopy draw_cold(const DrawableLevel& drawable, const render::Scene& scene,
                    const render::Settings& settings, render::PixelFormat format) {
  render::Renderer renderer(drawable.palette, drawable.colormap);
  return draw(renderer, scene, settings, format);
}

void expect_same(const FrameCopy& expected, const FrameCopy& drawn, const std::string& what) {
  EXPECT_TRUE(expected == drawn) << what << ": " << differing_pixels(expected, drawn) << " pixels differ";
}

constexpr auto kBothFormats = {render::PixelFormat::kIndexed, render::PixelFormat::kRgb};

void expect_independent_of_settings(const DrawableLevel& drawable) {
  const std::vector<NamedSettings> all = settings_of_one_picture();
  // One renderer for each setting, kept from view to view, as in a game.
  std::vector<render::Renderer> renderers;
  for (std::size_t i = 0; i < all.size(); ++i) renderers.emplace_back(drawable.palette, drawable.colormap);
  for (int number = 0; number < kSameViews; ++number) {
    const Viewpoint viewpoint = make_viewpoint(*drawable.level, number);
    const render::Scene scene = viewpoint.scene(*drawable.level);
    for (const render::PixelFormat format : kBothFormats) {
      for (const auto perspective : {render::Perspective::kExact, render::Perspective::kEvery16}) {
        const FrameCopy expected = draw_cold(drawable, scene, {.perspective = perspective}, format);
        for (std::size_t i = 0; i < all.size(); ++i) {
          render::Settings settings = all[i].settings;
          settings.perspective = perspective;
          expect_same(expected, draw(renderers[i], scene, settings, format),
                      fmt::format("{}, view {}, {}", drawable.name, number, all[i].name));
        }
      }
    }
  }
}

// Forward, backward, and after dropping the surfaces: always the picture of a fresh renderer.
void expect_independent_of_history(const DrawableLevel& drawable) {
  for (const render::PixelFormat format : kBothFormats) {
    std::vector<Viewpoint> viewpoints;
    std::vector<FrameCopy> expected;
    for (int number = 0; number < kSameViews; ++number) {
      viewpoints.push_back(make_viewpoint(*drawable.level, number));
      expected.push_back(draw_cold(drawable, viewpoints.back().scene(*drawable.level), {}, format));
    }
    render::Renderer renderer(drawable.palette, drawable.colormap);
    const auto check = [&](std::size_t number, const char* when) {
      const FrameCopy drawn = draw(renderer, viewpoints[number].scene(*drawable.level), {}, format);
      expect_same(expected[number], drawn, fmt::format("{}, view {}, {}", drawable.name, number, when));
    };
    for (std::size_t number = 0; number < viewpoints.size(); ++number) {
      check(number, "after those before it");
      check(number, "again");
    }
    for (std::size_t number = viewpoints.size(); number-- > 0;) check(number, "after those behind it");
    renderer.drop_surfaces();
    check(0, "after the surfaces were dropped");
  }
}

class SmallLevelSamePicture : public testing::TestWithParam<SmallLevelVariant> {
 protected:
  const DrawableLevel drawable_ = small_level(GetParam().options, GetParam().name);
};
TEST_P(SmallLevelSamePicture, WithAllSettings) {
  expect_independent_of_settings(drawable_);
}
TEST_P(SmallLevelSamePicture, AfterAnything) {
  expect_independent_of_history(drawable_);
}
INSTANTIATE_TEST_SUITE_P(Variants, SmallLevelSamePicture, testing::ValuesIn(small_level_variants()),
                         [](const auto& test) { return test.param.name; });

class StockLevelSamePicture : public testing::TestWithParam<const char*> {};
TEST_P(StockLevelSamePicture, WithAllSettings) {
  DATA_FOLDER_OR_SKIP(data);
  expect_independent_of_settings(stock_level(data, GetParam()));
}
TEST_P(StockLevelSamePicture, AfterAnything) {
  DATA_FOLDER_OR_SKIP(data);
  expect_independent_of_history(stock_level(data, GetParam()));
}
INSTANTIATE_TEST_SUITE_P(Levels, StockLevelSamePicture, testing::Values("start", "lq_e0m1", "lq_e1m2"),
                         [](const auto& test) { return std::string(test.param); });

TEST(SamePicture, AfterALightStyleChanged) {
  const DrawableLevel drawable = small_level({.four_styles = true});
  const Viewpoint viewpoint = make_viewpoint(*drawable.level, 0);
  render::Scene bright = viewpoint.scene(*drawable.level), dark = bright;
  bright.light_styles.fill(300);
  dark.light_styles.fill(40);
  for (const render::PixelFormat format : kBothFormats) {
    const FrameCopy expected_bright = draw_cold(drawable, bright, {}, format);
    const FrameCopy expected_dark = draw_cold(drawable, dark, {}, format);
    ASSERT_FALSE(expected_bright == expected_dark);
    render::Renderer renderer(drawable.palette, drawable.colormap);
    expect_same(expected_bright, draw(renderer, bright, {}, format), "bright");
    expect_same(expected_dark, draw(renderer, dark, {}, format), "dark after bright");
    expect_same(expected_bright, draw(renderer, bright, {}, format), "bright after dark");
  }
}

TEST(SamePicture, AfterTheSettingsOfAnother) {
  const DrawableLevel drawable = small_level({.colored_light = true});
  const Viewpoint viewpoint = make_viewpoint(*drawable.level, 0);
  const render::Scene scene = viewpoint.scene(*drawable.level);
  const render::Settings others[] = {
      {.mip_rule = render::MipRule::kStock}, {.force_mip = 2}, {.colored_light = false}, {.use_pvs = false}};
  for (const render::PixelFormat format : kBothFormats) {
    render::Renderer renderer(drawable.palette, drawable.colormap);
    const FrameCopy expected = draw_cold(drawable, scene, {}, format);
    for (const render::Settings& other : others) {
      const FrameCopy expected_other = draw_cold(drawable, scene, other, format);
      expect_same(expected_other, draw(renderer, scene, other, format), "another's settings");
      expect_same(expected, draw(renderer, scene, {}, format), "after another's settings");
    }
  }
}

// Texture axes that are perpendicular to a face, or zero, leave it no texels in one direction.
TEST(SamePicture, OfFacesWithoutExtent) {
  DrawableLevel drawable = small_level();
  formats::Bsp bsp = artgen::make_small_level();
  for (std::size_t i = 0; i < bsp.texinfos.size(); ++i) {
    formats::BspTexinfo& texinfo = bsp.texinfos[i];
    if (i % 3 != 0) texinfo.s_axis = math::Vec3(0.0f);
    if (i % 3 != 1) texinfo.t_axis = math::Vec3(0.0f);
    texinfo.s_offset = texinfo.t_offset = 32;
  }
  drawable.level = world::make_level(std::move(bsp), "without extent").value();
  expect_independent_of_settings(drawable);
  expect_independent_of_history(drawable);
}

// A level may be freed and the next one allocated at its address: nothing of the first may show.
TEST(SamePicture, AfterALevelThatIsGone) {
  const DrawableLevel first_look = small_level();
  render::Renderer renderer(first_look.palette, first_look.colormap);
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    DrawableLevel drawable = first_look;
    drawable.level =
        world::make_level(artgen::make_small_level({.colored_light = seed % 2 == 0, .seed = seed}), "new")
            .value();
    const Viewpoint viewpoint = make_viewpoint(*drawable.level, 0);
    const render::Scene scene = viewpoint.scene(*drawable.level);
    const FrameCopy expected = draw_cold(drawable, scene, {}, render::PixelFormat::kRgb);
    expect_same(expected, draw(renderer, scene, {}, render::PixelFormat::kRgb), fmt::format("seed {}", seed));
  }
}

// Two levels, one after the other, at the same address and with different shapes.
TEST(SamePicture, AfterALevelAtTheSameAddress) {
  const DrawableLevel tiny = small_level({.tiny = true}), full = small_level();
  world::Level level = *tiny.level;
  render::Renderer renderer(full.palette, full.colormap);
  draw(renderer, make_viewpoint(level, 0).scene(level), {}, render::PixelFormat::kRgb);
  level = *full.level;
  const Viewpoint viewpoint = make_viewpoint(level, 0);
  const FrameCopy expected = draw_cold(full, viewpoint.scene(*full.level), {}, render::PixelFormat::kRgb);
  expect_same(expected, draw(renderer, viewpoint.scene(level), {}, render::PixelFormat::kRgb),
              "the second level");
}

}  // namespace
}  // namespace temblor::test
