// Particles on the graphics card, next to the CPU's picture.
#include <gtest/gtest.h>

#include "render_gl/gl_pictures.h"
#include "render_gl/scene_views.h"
#include "support/effort.h"

namespace temblor::render_gl {
namespace {

// The squares themselves are exact, also their colors without fog. Others are at edges of the level's faces,
// and where a square is as far as a wall.
constexpr double kParticlesEqualShare = 0.9995;

struct Cloud {
  std::vector<float> x, y, z;
  std::vector<std::uint8_t> color;
  void add(const math::Vec3& place, std::size_t index) {
    x.push_back(place.x);
    y.push_back(place.y);
    z.push_back(place.z);
    color.push_back(static_cast<std::uint8_t>(index));
  }
  render::ParticleCloud view() const { return {x, y, z, color}; }
};

// From distances that are cut off, over those of the largest and smallest squares, to far behind walls; some
// share a position, and some are beyond the borders of the picture.
Cloud make_cloud(std::size_t count, const render::Scene& scene, test::Random& io_random) {
  Cloud cloud;
  while (cloud.x.size() < count) {
    if (!cloud.x.empty() && io_random.chance(0.1))
      cloud.add({cloud.x.back(), cloud.y.back(), cloud.z.back()}, io_random.below(256));
    else
      cloud.add(point_in_view(scene, io_random.log_uniform(4, 2000), 1.1, io_random), io_random.below(256));
  }
  return cloud;
}

TEST(GlParticles, AreTheCpusSquares) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  for (int number = 0; number < test::effort(30, 3); ++number) {
    test::Random random(static_cast<std::uint64_t>(number));
    SceneView view = any_view(*level.level, random);
    if (number % 3 == 1) {
      view.scene.camera.projection = render::Projection::kOrthographic;
      view.scene.camera.units_per_pixel = number % 2 == 0 ? 0.2f : 1.5f;
    }
    const Cloud cloud = make_cloud(number % 2 == 0 ? 5000 : 50, view.scene, random);
    view.scene.particles = cloud.view();
    // In parallel projection, a whole side of a face may lie where rounding decides.
    EXPECT_GE(pair.compare(view.scene, {.threads = 1 + number % 3}),
              number % 3 == 1 ? 0.998 : kParticlesEqualShare)
        << number;
  }
}

TEST(GlParticles, AreFogged) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  for (int number = 0; number < test::effort(10, 2); ++number) {
    test::Random random(static_cast<std::uint64_t>(number));
    SceneView view = any_view(*level.level, random);
    const Cloud cloud = make_cloud(5000, view.scene, random);
    view.scene.particles = cloud.view();
    view.scene.fog = {.density = number % 2 == 0 ? 0.1f : 1.0f, .color = {0.8f, 0.5f, 0.2f}};
    EXPECT_GE(pair.compare(view.scene, {}), kParticlesEqualShare) << number;
  }
}

// A row of particles along each border of the picture. They do not cover each other, since their depth may
// differ by rounding only.
TEST(GlParticles, AreCutAtTheBorders) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  test::Random random(2);
  SceneView view = any_view(*level.level, random);
  const math::Basis axes = view_axes(view.scene);
  Cloud cloud;
  for (int i = -20; i <= 20; ++i)
    for (const float side : {-1.0f, 1.0f}) {
      const float along = static_cast<float>(i) / 20.0f;
      const auto add = [&](float x, float y) {
        constexpr float kDistance = 9;
        cloud.add(view.scene.camera.origin_world + math::Vec3(axes.forward) * kDistance +
                      math::Vec3(axes.right) * (x * kDistance) + math::Vec3(axes.up) * (y * kDistance),
                  random.below(256));
      };
      add(side, along * 0.75f);
      add(along, side * 0.75f);
    }
  view.scene.particles = cloud.view();
  EXPECT_GE(pair.compare(view.scene, {}), kParticlesEqualShare);
}

TEST(GlParticles, AreDrawnBehindTranslucentLayers) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  for (int number = 0; number < test::effort(10, 2); ++number) {
    test::Random random(static_cast<std::uint64_t>(number));
    SceneView view = any_view(*level.level, random);
    for (render::BrushModelInstance& model : view.viewpoint.brush_models) model.alpha = 0.4f;
    const Cloud cloud = make_cloud(2000, view.scene, random);
    view.scene.particles = cloud.view();
    view.scene.liquid_alpha = {.water = 0.5f, .slime = 0.7f, .lava = 0.9f, .teleport = 0.3f};
    EXPECT_GE(pair.compare(view.scene, {}), kParticlesEqualShare) << number;
  }
}

}  // namespace
}  // namespace temblor::render_gl
