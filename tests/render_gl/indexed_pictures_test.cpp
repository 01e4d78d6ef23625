// Indexed frames on the graphics card, next to the CPU's: nearly all palette indices are equal.
#include <gtest/gtest.h>

#include <iostream>

#include "render/present.h"
#include "render_gl/model_scenes.h"
#include "render_gl/scene_views.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/pictures/deferred_faces.h"

namespace temblor::render_gl {
namespace {

// The least share of equal indices, over all views and in the worst one. An eye that nearly touches a wall
// sees texels of hundreds of pixels, and edges that are off by several.
constexpr double kEqualIndices = 0.99, kWorstEqualIndices = 0.97;

constexpr render::LiquidAlpha kClearLiquids{.water = 0.5f, .slime = 0.7f, .lava = 0.9f, .teleport = 0.3f};

// A random view, and what a test may add to it.
struct IndexedView {
  IndexedView(const world::Level& level, test::Random& io_random)
      : models(random_scene(make_small_models(), level, 0, io_random)) {
    viewpoint().lights = test::random_lights(viewpoint().camera.origin_world, 3, io_random);
    viewpoint().marks = test::random_marks(level, 20, io_random);
  }
  test::Viewpoint& viewpoint() { return models.viewpoint; }

  ModelScene models;
  std::vector<formats::Spr> spr = {};
  std::vector<render::SpriteInstance> sprites = {};
  std::vector<float> x = {}, y = {}, z = {};
  std::vector<std::uint8_t> color = {};
  std::vector<render::Line> lines = {};
};

constexpr auto kNothingAdded = [](int, IndexedView&, test::Random&) {};
constexpr auto kUnchangedScene = [](int, render::Scene&) {};

// Compares views; `add` may add to one, and `change` may change its scene.
template <typename Add, typename Change>
void compare_indexed(const test::DrawableLevel& drawable, int views, Add add, Change change) {
  RENDERER_PAIR_OR_SKIP(pair, drawable);
  pair.set_format(render::PixelFormat::kIndexed);
  double total = 0, worst = 1;
  for (int number = 0; number < views; ++number) {
    test::Random random(static_cast<std::uint64_t>(number));
    IndexedView view(*drawable.level, random);
    add(number, view, random);
    render::Scene scene = view.models.scene(*drawable.level);
    scene.sprites = view.sprites;
    scene.particles = {view.x, view.y, view.z, view.color};
    scene.lines = view.lines;
    change(number, scene);
    const double share = pair.compare(scene, {});
    EXPECT_GE(share, kWorstEqualIndices) << drawable.name << ", view " << number;
    total += share / views;
    worst = std::min(worst, share);
  }
  EXPECT_GE(total, test::kQuick ? kWorstEqualIndices : kEqualIndices) << drawable.name;
  std::cout << "[          ] " << drawable.name << ": equal indices " << total << ", worst view " << worst
            << "\n";
}

TEST(GlIndexed, ShowsTheSmallLevels) {
  for (const test::SmallLevelVariant& variant : test::small_level_variants())
    compare_indexed(test::small_level(variant.options, variant.name), test::effort(5, 1), kNothingAdded,
                    kUnchangedScene);
}

TEST(GlIndexed, ShowsStockLevels) {
  DATA_FOLDER_OR_SKIP(data);
  std::vector<const char*> names = {"start", "lq_e1m2"};
  if (!test::kQuick)
    names.insert(names.end(),
                 {"start_e0", "lq_e0m1", "lq_e0m2", "lq_e0m3", "lq_end", "lqdm1", "lqdm3", "lqdm11"});
  for (const char* name : names)
    compare_indexed(test::stock_level(data, name), test::effort(15, 1), kNothingAdded, kUnchangedScene);
}

TEST(GlIndexed, ShowsFences) {
  compare_indexed(test::with_fences(test::small_level()), test::effort(10, 2), kNothingAdded,
                  kUnchangedScene);
}

TEST(GlIndexed, BlendsLiquidsAndBrushModels) {
  compare_indexed(
      test::small_level(), test::effort(20, 2),
      [](int, IndexedView& io_view, test::Random& io_random) {
        for (render::BrushModelInstance& model : io_view.viewpoint().brush_models)
          model.alpha = static_cast<float>(io_random.uniform(0.2, 1));
      },
      [](int number, render::Scene& io_scene) {
        io_scene.liquid_alpha = kClearLiquids;
        if (number % 3 == 2) io_scene.fog = {.density = 0.1f, .color = {0.8f, 0.5f, 0.2f}};
      });
}

// Half-Life's modes: a color of their own, and faces that are added to the picture.
TEST(GlIndexed, AddsBrushModelsAndFillsThem) {
  compare_indexed(
      test::small_level(), test::effort(20, 3),
      [](int, IndexedView& io_view, test::Random& io_random) {
        for (render::BrushModelInstance& model : io_view.viewpoint().brush_models) {
          model.is_additive = io_random.chance(0.5);
          model.alpha = io_random.chance(0.3) ? 1.0f : static_cast<float>(io_random.uniform(0.2, 1));
          if (io_random.chance(0.5)) model.color = {static_cast<std::uint8_t>(io_random.bits()), 90, 30};
        }
      },
      [](int number, render::Scene& io_scene) {
        if (number % 2 == 1) io_scene.fog = {.density = 0.1f, .color = {0.8f, 0.5f, 0.2f}};
      });
}

TEST(GlIndexed, ShowsFog) {
  compare_indexed(test::small_level(), test::effort(20, 4), kNothingAdded,
                  [](int number, render::Scene& io_scene) {
                    io_scene.fog = {.density = number % 2 == 0 ? 0.05f : 0.4f, .color = {0.8f, 0.5f, 0.2f}};
                    if (number % 4 < 2) return;
                    io_scene.camera.projection = render::Projection::kOrthographic;
                    io_scene.camera.units_per_pixel = 1;
                  });
}

TEST(GlIndexed, ShowsModels) {
  compare_indexed(
      test::small_level({.colored_light = true}), test::effort(30, 3),
      [](int number, IndexedView& io_view, test::Random& io_random) {
        ModelScene& models = io_view.models;
        if (number % 3 == 0) models.models = make_wide_models();
        for (int i = 0; i < 8; ++i) {
          render::AliasInstance made = random_instance(models, io_random.log_uniform(100, 600), io_random);
          if (io_random.chance(0.3))
            made.colors = {static_cast<std::uint8_t>(io_random.below(16)),
                           static_cast<std::uint8_t>(io_random.below(16))};
          if (io_random.chance(0.3)) made.alpha = static_cast<float>(io_random.uniform(0.1, 0.9));
          if (io_random.chance(0.3)) made.full_bright = true;
          if (io_random.chance(0.3))
            models.viewpoint.lights.push_back({made.origin_world + io_random.in_cube(50),
                                               static_cast<float>(io_random.uniform(100, 300)), 0,
                                               glm::abs(io_random.in_cube(1.5))});
          models.instances.push_back(made);
        }
        models.weapon = random_instance(models, io_random.uniform(20, 40), io_random);
        models.weapon->scale = 0.18f;
        if (io_random.chance(0.3)) models.weapon->alpha = 0.5f;
        if (number % 2 == 1) models.fog = {.density = 0.1f, .color = {0.3f, 0.4f, 0.2f}};
      },
      [](int, render::Scene& io_scene) { io_scene.liquid_alpha = kClearLiquids; });
}

TEST(GlIndexed, ShowsModelsOfStockLevels) {
  DATA_FOLDER_OR_SKIP(data);
  std::vector<ModelPtr> stock;
  for (const char* name : {"soldier", "ogre", "demon", "zombie", "player", "armor", "flame", "g_rock2"})
    stock.push_back(load_model(data / "id1" / "progs" / (std::string(name) + ".mdl")));
  compare_indexed(
      test::stock_level(data, "lq_e1m2"), test::effort(20, 2),
      [&](int, IndexedView& io_view, test::Random& io_random) {
        io_view.models.models = stock;
        for (int i = 0; i < 10; ++i) {
          io_view.models.instances.push_back(
              random_instance(io_view.models, io_random.log_uniform(80, 600), io_random));
          if (io_random.chance(0.2)) io_view.models.instances.back().alpha = 0.5f;
        }
      },
      kUnchangedScene);
}

TEST(GlIndexed, ShowsSpritesAndParticles) {
  compare_indexed(
      test::small_level(), test::effort(20, 3),
      [](int, IndexedView& io_view, test::Random& io_random) {
        const render::Scene scene{.camera = io_view.viewpoint().camera};
        formats::SprPicture picture{-20, 25, 40, 50, {}};
        for (int i = 0; i < 40 * 50; ++i)
          picture.texels.push_back(
              static_cast<std::uint8_t>(io_random.chance(0.2) ? std::size_t{255} : io_random.below(255)));
        io_view.spr = {
            {.orientation = formats::SprOrientation::kParallel, .frames = {{{std::move(picture)}, {}}}}};
        for (int i = 0; i < 30; ++i)
          io_view.sprites.push_back(
              {.sprite = io_view.spr.data(),
               .picture = &io_view.spr[0].frames[0].pictures[0],
               .origin_world = point_in_view(scene, io_random.log_uniform(20, 400), 0.8, io_random),
               .alpha = io_random.chance(0.5) ? 1.0f : static_cast<float>(io_random.uniform(0, 1))});
        for (int i = 0; i < 2000; ++i) {
          const math::Vec3 at = point_in_view(scene, io_random.log_uniform(4, 2000), 1.1, io_random);
          io_view.x.push_back(at.x);
          io_view.y.push_back(at.y);
          io_view.z.push_back(at.z);
          io_view.color.push_back(static_cast<std::uint8_t>(io_random.below(256)));
        }
      },
      [](int number, render::Scene& io_scene) {
        if (number % 3 == 1) io_scene.fog = {.density = 0.2f, .color = {0.8f, 0.5f, 0.2f}};
        if (number % 3 == 2) io_scene.liquid_alpha = kClearLiquids;
      });
}

TEST(GlIndexed, ShowsLinesUnderWater) {
  compare_indexed(
      test::small_level(), test::effort(10, 2),
      [](int, IndexedView& io_view, test::Random& io_random) {
        const render::Scene scene{.camera = io_view.viewpoint().camera};
        for (int i = 0; i < 100; ++i)
          io_view.lines.push_back({point_in_view(scene, 100, 1.2, io_random),
                                   point_in_view(scene, 300, 1.2, io_random),
                                   {static_cast<std::uint8_t>(io_random.bits()), 200, 40},
                                   io_random.chance(0.5)});
      },
      [](int number, render::Scene& io_scene) {
        io_scene.underwater = number % 2 == 0;
        io_scene.tint = {{130, 80, 50}, 0.5f};
      });
}

TEST(GlIndexed, ShowsSkyboxes) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  pair.set_format(render::PixelFormat::kIndexed);
  for (int number = 0; number < test::effort(16, 3); ++number) {
    test::Random random(static_cast<std::uint64_t>(number));
    render::Skybox skybox;
    const std::uint32_t size = 1u << number % 8;
    for (formats::Image& side : skybox.sides) {
      side = {.width = size, .height = size, .pixels = {}};
      while (side.pixels.size() < std::size_t{size} * size)
        side.pixels.push_back(0xff000000u | static_cast<std::uint32_t>(random.bits()));
    }
    SceneView view = any_sky_view(*level.level, random);
    view.scene.skybox = &skybox;
    if (number % 4 == 1) view.scene.fog = {.density = 0.1f, .color = {0.8f, 0.5f, 0.2f}};
    EXPECT_GE(pair.compare(view.scene, {}), kEqualIndices) << number;
  }
}

// The tint is the frame's, and changes its palette.
TEST(GlIndexed, LeavesTheTintToThePalette) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  pair.set_format(render::PixelFormat::kIndexed);
  test::Random random(1);
  SceneView view = any_view(*level.level, random);
  for (const float opacity : {0.5f, 0.0f}) {
    view.scene.tint = {{130, 80, 50}, opacity};
    EXPECT_GE(pair.compare(view.scene, {}), kEqualIndices);
    const formats::Palette cpu = render::shown_palette(pair.cpu_frame(), level.palette);
    EXPECT_EQ(render::shown_palette(pair.gl_frame(), level.palette), cpu);
    EXPECT_EQ(cpu == level.palette, opacity == 0);
  }
}

// Frames of both formats alternate. Nothing that was drawn before may change a picture.
TEST(GlIndexed, FollowsTheFormatOfEachFrame) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  for (int number = 0; number < test::effort(8, 2); ++number) {
    test::Random random(static_cast<std::uint64_t>(number / 4));
    SceneView view = any_view(*level.level, random);
    view.scene.liquid_alpha = kClearLiquids;
    pair.set_format(number % 2 == 0 ? render::PixelFormat::kIndexed : render::PixelFormat::kRgb);
    EXPECT_GE(pair.compare(view.scene, {}), kEqualIndices) << number;
  }
}

}  // namespace
}  // namespace temblor::render_gl
