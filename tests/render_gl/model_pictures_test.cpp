// Alias models on the graphics card, next to the CPU's pictures.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "render_gl/model_scenes.h"
#include "support/effort.h"
#include "support/game_data.h"

namespace temblor::render_gl {
namespace {

// The rest lies at edges, and at the borders of a skin's squares.
constexpr double kWholeShare = 0.99, kOwnShare = 0.97;

struct ModelTest {
  test::DrawableLevel drawable = test::small_level({.colored_light = true});
  std::vector<ModelPtr> models = make_small_models();
  int instances = 8;
  render::Settings settings = {};
  std::size_t min_own_pixels = 1000;  // per view, on average
  double whole_share = kWholeShare, own_share = kOwnShare;
  ClipControl clip_control = ClipControl::kIfSupported;
};

// Compares views of random scenes; `change` may change a scene.
template <typename Change>
void compare_model_views(const ModelTest& test, int views, Change change) {
  RENDERER_PAIR_OR_SKIP(pair, test.drawable, test.clip_control);
  ModelShares total{0, 0, 0}, worst;
  for (int number = 0; number < views; ++number) {
    test::Random random(static_cast<std::uint64_t>(number));
    ModelScene scene = random_scene(test.models, *test.drawable.level, test.instances, random);
    change(scene, random);
    const ModelShares shares = compare_models(pair, scene, *test.drawable.level, test.settings);
    EXPECT_GE(shares.whole, test.whole_share) << "view " << number;
    if (shares.own_pixels > 500) {
      EXPECT_GE(shares.own, test.own_share) << "view " << number;
    }
    total.whole += shares.whole / views;
    total.own += shares.own * static_cast<double>(shares.own_pixels);
    total.own_pixels += shares.own_pixels;
    worst.whole = std::min(worst.whole, shares.whole);
    if (shares.own_pixels > 500) worst.own = std::min(worst.own, shares.own);
  }
  EXPECT_GE(total.own_pixels, static_cast<std::size_t>(views) * test.min_own_pixels);
  std::cout << "[          ] all pixels: " << total.whole << ", worst view " << worst.whole
            << "; the models' pixels: "
            << total.own / static_cast<double>(std::max<std::size_t>(total.own_pixels, 1)) << ", worst view "
            << worst.own << "\n";
}

constexpr auto kNoChange = [](ModelScene&, test::Random&) {};

TEST(GlModels, BlendPoses) {
  compare_model_views({}, test::effort(10, 2), kNoChange);
}

TEST(GlModels, ShowPlayerColors) {
  compare_model_views({}, test::effort(10, 2), [](ModelScene& io_scene, test::Random& io_random) {
    for (render::AliasInstance& instance : io_scene.instances)
      instance.colors = {static_cast<std::uint8_t>(io_random.below(16)),
                         static_cast<std::uint8_t>(io_random.below(16))};
  });
}

TEST(GlModels, AreFullBright) {
  compare_model_views({}, test::effort(6, 2), [](ModelScene& io_scene, test::Random&) {
    for (render::AliasInstance& instance : io_scene.instances) instance.full_bright = true;
  });
}

TEST(GlModels, AreLitInColor) {
  compare_model_views({}, test::effort(10, 2), [](ModelScene& io_scene, test::Random& io_random) {
    for (render::AliasInstance& instance : io_scene.instances) {
      instance.min_light = static_cast<float>(io_random.below(100));
      const math::Vec3 place = instance.origin_world + io_random.in_cube(50);
      const auto radius = static_cast<float>(io_random.uniform(100, 300));
      io_scene.viewpoint.lights.push_back({place, radius, 0, glm::abs(io_random.in_cube(1.5))});
    }
  });
}

TEST(GlModels, AreTranslucent) {
  compare_model_views({}, test::effort(20, 2), [](ModelScene& io_scene, test::Random& io_random) {
    for (render::AliasInstance& instance : io_scene.instances)
      if (io_random.chance(0.7)) instance.alpha = static_cast<float>(io_random.uniform(0, 1));
    io_scene.liquid_alpha = {.water = 0.5f, .slime = 0.5f, .lava = 0.5f, .teleport = 0.5f};
  });
}

TEST(GlModels, HaveAnyScale) {
  compare_model_views({}, test::effort(10, 2), [](ModelScene& io_scene, test::Random& io_random) {
    for (render::AliasInstance& instance : io_scene.instances) {
      const double scale = io_random.log_uniform(0.1, 3);
      instance = random_instance(io_scene, 120 * scale * io_random.uniform(1, 3), io_random);
      instance.scale = static_cast<float>(scale);
    }
  });
}

TEST(GlModels, AreFogged) {
  compare_model_views({}, test::effort(20, 2), [](ModelScene& io_scene, test::Random& io_random) {
    io_scene.fog = {.density = static_cast<float>(io_random.log_uniform(0.05, 0.5)),
                    .color = {0.8f, 0.5f, 0.2f}};
    for (render::AliasInstance& instance : io_scene.instances)
      if (io_random.chance(0.3)) instance.alpha = 0.6f;
    io_scene.weapon = random_instance(io_scene, 50, io_random);
    io_scene.weapon->scale = 0.4f;
  });
}

TEST(GlModels, AreViewWeapons) {
  compare_model_views({}, test::effort(20, 2), [](ModelScene& io_scene, test::Random& io_random) {
    io_scene.weapon = random_instance(io_scene, io_random.uniform(20, 40), io_random);
    io_scene.weapon->scale = 0.18f;
    if (io_random.chance(0.3)) io_scene.weapon->alpha = 0.5f;
  });
}

TEST(GlModels, AreDrawnInParallelProjection) {
  compare_model_views({}, test::effort(10, 2), [](ModelScene& io_scene, test::Random& io_random) {
    io_scene.viewpoint.camera.projection = render::Projection::kOrthographic;
    io_scene.viewpoint.camera.units_per_pixel = 0.5f;
    io_scene.weapon = random_instance(io_scene, 40, io_random);
  });
}

TEST(GlModels, HavePosesOf16Bits) {
  compare_model_views({.models = make_wide_models()}, test::effort(10, 2), kNoChange);
}

TEST(GlModels, HaveMoreSkinsThanATextureHasLayers) {
  compare_model_views({.models = {make_box_with_skins(5000)}}, test::effort(4, 1), kNoChange);
}

TEST(GlModels, NeedNoClipControl) {
  compare_model_views({.clip_control = ClipControl::kNo}, test::effort(10, 2),
                      [](ModelScene& io_scene, test::Random& io_random) {
                        io_scene.weapon = random_instance(io_scene, 40, io_random);
                        io_scene.weapon->scale = 0.3f;
                        io_scene.instances.front().alpha = 0.5f;
                      });
}

TEST(GlModels, AreManyAtOnce) {
  compare_model_views({.instances = 300}, test::effort(3, 1), kNoChange);
}

// Their skins are finer, so more texels differ where the CPU maps them affinely.
TEST(GlModels, AreThoseOfStockLevels) {
  DATA_FOLDER_OR_SKIP(data);
  ModelTest test{.drawable = test::stock_level(data, "lq_e1m2"),
                 .models = {},
                 .instances = 10,
                 .whole_share = 0.985,
                 .own_share = 0.94};
  for (const char* name : {"soldier", "ogre", "demon", "zombie", "player", "armor", "flame", "g_rock2"})
    test.models.push_back(load_model(data / "id1" / "progs" / (std::string(name) + ".mdl")));
  compare_model_views(test, test::effort(20, 2), [](ModelScene& io_scene, test::Random& io_random) {
    for (render::AliasInstance& instance : io_scene.instances) {
      if (io_random.chance(0.2)) instance.alpha = 0.5f;
      if (io_random.chance(0.2)) instance.colors = {4, 13};
    }
  });
}

// Models around the eye, and weapons that reach behind it. The light of triangles that are cut at the near
// plane differs (alias_shaders.h), so these are full-bright.
TEST(GlModels, AreCutAtTheNearPlane) {
  compare_model_views({.instances = 0, .whole_share = 0.985}, test::effort(30, 2),
                      [](ModelScene& io_scene, test::Random& io_random) {
                        for (int i = 0; i < 2; ++i)
                          io_scene.instances.push_back(random_instance(io_scene, 25, io_random));
                        if (io_random.chance(0.5)) io_scene.weapon = random_instance(io_scene, 20, io_random);
                        for (render::AliasInstance& instance : io_scene.instances)
                          instance.full_bright = true;
                        if (io_scene.weapon) io_scene.weapon->full_bright = true;
                      });
}

// The CPU computes another light where triangles are cut, but both lie between those of the corners.
TEST(GlModels, AreLitWithinBoundsWhereTheyAreCut) {
  const ModelTest test;
  RENDERER_PAIR_OR_SKIP(pair, test.drawable);
  for (int number = 0; number < test::effort(20, 2); ++number) {
    test::Random random(static_cast<std::uint64_t>(number));
    ModelScene scene = random_scene(test.models, *test.drawable.level, 0, random);
    scene.instances.push_back(random_instance(scene, 25, random));
    EXPECT_GE(pair.compare(scene.scene(*test.drawable.level), {}, 64), 0.999) << "view " << number;
  }
}

// Nothing that was drawn before may change a picture.
TEST(GlModels, DoNotDependOnEarlierFrames) {
  const ModelTest test;
  RENDERER_PAIR_OR_SKIP(pair, test.drawable);
  const auto draw = [&](std::uint64_t seed, int width) {
    test::Random random(seed);
    // Models of their own, so that earlier ones are freed.
    ModelScene scene = random_scene(make_small_models(), *test.drawable.level, 8, random);
    for (std::size_t i = 0; i < scene.instances.size(); i += 2) scene.instances[i].alpha = 0.5f;
    scene.weapon = random_instance(scene, 40, random);
    if (seed % 2 == 1) scene.weapon->alpha = 0.5f;
    render::FrameBuffer frame(width, 200, render::PixelFormat::kRgb);
    EXPECT_TRUE(pair.gl().render(scene.scene(*test.drawable.level), {}, frame).ok());
    return std::vector<std::uint32_t>(frame.rgb().begin(), frame.rgb().end());
  };
  const std::vector<std::uint32_t> first = draw(0, 320), second = draw(1, 320);
  draw(2, 333);
  draw(3, 320);
  EXPECT_EQ(draw(0, 320), first);
  EXPECT_EQ(draw(1, 320), second);
}

TEST(GlModels, OfAnySizeAreDrawnOrLeftOut) {
  const ModelTest test;
  RENDERER_PAIR_OR_SKIP(pair, test.drawable);
  const float wrong[] = {std::nanf(""), HUGE_VALF, -HUGE_VALF, 3e38f};
  render::FrameBuffer frame(160, 100, render::PixelFormat::kRgb);
  for (int number = 0; number < test::effort(200, 20); ++number) {
    test::Random random(static_cast<std::uint64_t>(number));
    ModelScene scene = random_scene(test.models, *test.drawable.level, 0, random);
    render::AliasInstance instance = random_instance(scene, random.log_uniform(1e-3, 1e5), random);
    instance.scale = static_cast<float>(random.log_uniform(1e-12, 1e12));
    if (number % 5 == 0) instance.origin_world[number / 5 % 3] = wrong[random.below(4)];
    if (number % 7 == 0) instance.scale = wrong[random.below(4)];
    if (number % 13 == 0) instance.blend = wrong[random.below(4)];
    if (number % 2 == 0) instance.alpha = 0.5f;
    scene.instances = {instance};
    scene.weapon = instance;
    ASSERT_TRUE(pair.gl().render(scene.scene(*test.drawable.level), {}, frame).ok()) << "view " << number;
  }
}

TEST(GlModels, AreLeftOutWithoutDepth) {
  compare_model_views({.instances = 0, .settings = {.fill_depth = false}, .min_own_pixels = 0}, 2,
                      [](ModelScene& io_scene, test::Random& io_random) {
                        io_scene.instances.push_back(random_instance(io_scene, 100, io_random));
                        io_scene.instances.front().alpha = 0.5f;
                        io_scene.weapon = random_instance(io_scene, 100, io_random);
                      });
}

TEST(GlModels, AreCountedAsOnTheCpu) {
  const ModelTest test;
  RENDERER_PAIR_OR_SKIP(pair, test.drawable);
  render::Renderer cpu(test.drawable.palette, test.drawable.colormap);
  render::FrameBuffer frame(160, 100, render::PixelFormat::kRgb);
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    test::Random random(seed);
    ModelScene scene = random_scene(test.models, *test.drawable.level, 10, random);
    scene.instances.front().alpha = 0.5f;
    const render::FrameStats expected = cpu.render(scene.scene(*test.drawable.level), {}, frame);
    const render::FrameStats drawn = pair.gl().render(scene.scene(*test.drawable.level), {}, frame).value();
    EXPECT_GT(drawn.models, 0u);
    EXPECT_EQ(drawn.models, expected.models);
    EXPECT_EQ(drawn.triangles, expected.triangles);
  }
}

}  // namespace
}  // namespace temblor::render_gl
