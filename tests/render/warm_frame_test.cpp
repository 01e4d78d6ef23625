// A warm frame does not allocate: every operator new of the program is counted.
#include <gtest/gtest.h>

#include <vector>

#include "math/angles.h"
#include "render/renderer.h"
#include "support/allocation_counter.h"
#include "support/game_data.h"
#include "support/levels/drawable_level.h"
#include "support/models/drawable_models.h"
#include "support/pictures/deferred_faces.h"
#include "support/pictures/viewpoints.h"

namespace temblor::test {
namespace {

// `add` adds things to each scene.
template <typename Add>
void expect_no_allocation(const DrawableLevel& drawable, const render::Settings& settings, Add add) {
  constexpr int kViews = 10;
  std::vector<Viewpoint> viewpoints;
  for (int number = 0; number < kViews; ++number) {
    Random random(static_cast<std::uint64_t>(number));
    viewpoints.push_back({.camera = random_camera(*drawable.level, random),
                          .brush_models = shown_brush_models(*drawable.level),
                          .time_s = 1});
    Viewpoint& viewpoint = viewpoints.back();
    viewpoint.lights = random_lights(viewpoint.camera.origin_world, 4, random);
    viewpoint.marks = random_marks(*drawable.level, drawable.level->faces.size(), random);
  }
  for (const render::PixelFormat format : {render::PixelFormat::kIndexed, render::PixelFormat::kRgb}) {
    render::Renderer renderer(drawable.palette, drawable.colormap);
    render::FrameBuffer frame(320, 200, format);
    const auto draw_all = [&] {
      std::size_t while_drawing = 0;
      for (const Viewpoint& viewpoint : viewpoints) {
        render::Scene scene = viewpoint.scene(*drawable.level);
        add(scene);
        const std::size_t before = allocation_count();
        renderer.render(scene, settings, frame);
        while_drawing += allocation_count() - before;
      }
      return while_drawing;
    };
    // A frame larger than any before lets memory grow; from the next one of that size on, nothing is
    // allocated.
    EXPECT_GT(draw_all(), 0u) << "the first frames must allocate, or nothing is counted";
    draw_all();
    EXPECT_EQ(draw_all(), 0u) << drawable.name;
  }
}

void expect_no_allocation(const DrawableLevel& drawable, const render::Settings& settings) {
  expect_no_allocation(drawable, settings, [](render::Scene&) {});
}

TEST(WarmFrame, OfTheSmallLevelAllocatesNothing) {
  expect_no_allocation(small_level(), {});
}

TEST(WarmFrame, OnTwoThreadsAllocatesNothing) {
  expect_no_allocation(small_level(), {.threads = 2, .job_backend = base::JobBackend::kStdThread});
}

TEST(WarmFrame, BesideATooSmallCacheAllocatesNothing) {
  for (const std::size_t cache_bytes : {0u, 5'000u, 50'000u})
    expect_no_allocation(small_level(), {.cache_bytes = cache_bytes});
}

TEST(WarmFrame, WithoutACacheAllocatesNothing) {
  expect_no_allocation(small_level(), {.surface_cache = false});
}

TEST(WarmFrame, WithSpritesAndParticlesAllocatesNothing) {
  formats::Spr spr;
  spr.frames = {{{{-8, 8, 16, 16, std::vector<std::uint8_t>(256, 9)}}, {}}};
  std::vector<render::SpriteInstance> sprites;
  std::vector<float> x, y, z;
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const math::Vec3 place = random.in_cube(300);
    x.push_back(place.x);
    y.push_back(place.y);
    z.push_back(place.z);
    sprites.push_back({.sprite = &spr, .picture = &spr.frames[0].pictures[0], .origin_world = place});
  }
  const std::vector<std::uint8_t> colors(x.size(), 7);
  expect_no_allocation(small_level(), {}, [&](render::Scene& scene) {
    scene.sprites = sprites;
    scene.particles = {x, y, z, colors};
  });
}

// Deferred faces, translucent models, fog, a skybox, the underwater warp, and a tint.
TEST(WarmFrame, ThatSomethingShowsThroughAllocatesNothing) {
  const auto model = small_model(sphere_mdl());
  std::vector<render::AliasInstance> models(3);
  for (render::AliasInstance& instance : models) instance.model = model.get();
  models[1].alpha = models[2].alpha = 0.5f;
  render::Skybox skybox;
  for (formats::Image& image : skybox.sides) image = {1, 1, {0xff203040}};
  expect_no_allocation(with_fences(small_level()), {}, [&](render::Scene& scene) {
    const math::Basis axes = math::basis_from_angles(scene.camera.angles_deg);
    for (std::size_t i = 0; i < models.size(); ++i)
      models[i].origin_world =
          scene.camera.origin_world + math::Vec3(axes.forward) * (40.0f + 20.0f * static_cast<float>(i));
    scene.alias_models = models;
    scene.skybox = &skybox;
    scene.liquid_alpha = {0.5f, 0.5f, 0.5f, 0.5f};
    scene.fog = {0.2f, {0.5f, 0.5f, 0.5f}};
    scene.underwater = true;
    scene.tint = {{130, 80, 50}, 0.5f};
  });
}

// Look around, enlarge the window, look around again, and dive.
TEST(WarmFrame, FirstUnderWaterAfterAChangeOfSizeAllocatesNothing) {
  const DrawableLevel drawable = small_level();
  Random random(1);
  const Viewpoint viewpoint{.camera = random_camera(*drawable.level, random),
                            .brush_models = shown_brush_models(*drawable.level),
                            .time_s = 1};
  for (const render::PixelFormat format : {render::PixelFormat::kIndexed, render::PixelFormat::kRgb}) {
    render::Renderer renderer(drawable.palette, drawable.colormap);
    render::FrameBuffer small(320, 200, format), large(640, 400, format);
    render::Scene scene = viewpoint.scene(*drawable.level);
    for (render::FrameBuffer* const frame : {&small, &large, &large}) renderer.render(scene, {}, *frame);
    scene.underwater = true;
    const std::size_t before = allocation_count();
    renderer.render(scene, {}, large);
    EXPECT_EQ(allocation_count() - before, 0u);
  }
}

TEST(WarmFrame, OfAStockLevelAllocatesNothing) {
  DATA_FOLDER_OR_SKIP(data);
  expect_no_allocation(stock_level(data, "lq_e0m1"), {});
}

}  // namespace
}  // namespace temblor::test
