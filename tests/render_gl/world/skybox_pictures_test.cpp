// Skyboxes on the graphics card, next to the CPU's picture.
#include <gtest/gtest.h>

#include "render_gl/gl_pictures.h"
#include "render_gl/scene_views.h"
#include "support/effort.h"

namespace temblor::render_gl {
namespace {

// Strong colors, so that a texel that is a little off shows.
formats::Image make_side(std::uint32_t width, std::uint32_t height, test::Random& io_random) {
  formats::Image image{.width = width, .height = height, .pixels = {}};
  for (std::uint32_t i = 0; i < width * height; ++i)
    image.pixels.push_back(0xff000000u | static_cast<std::uint32_t>(io_random.bits()));
  return image;
}

render::Skybox make_skybox(std::uint32_t size, test::Random& io_random) {
  render::Skybox skybox;
  for (formats::Image& side : skybox.sides) side = make_side(size, size, io_random);
  return skybox;
}

// Rays differ in the last digits: a texel of one color next to another shows that at most as a step of the
// interpolation, of 1/256.
constexpr double kSkyboxEqualShare = 0.9995;

TEST(GlSkybox, ShowsTheCpusSides) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  for (int number = 0; number < test::effort(24, 3); ++number) {
    test::Random random(static_cast<std::uint64_t>(number));
    const render::Skybox skybox = make_skybox(1u << number % 8, random);
    SceneView view = any_sky_view(*level.level, random);
    view.scene.skybox = &skybox;
    if (number % 4 == 1) view.scene.fog = {.density = 0.1f, .color = {0.8f, 0.5f, 0.2f}};
    if (number % 4 == 2) {
      view.scene.camera.projection = render::Projection::kOrthographic;
      view.scene.camera.units_per_pixel = 1;
    }
    EXPECT_GE(pair.compare(view.scene, {}), kSkyboxEqualShare) << number;
  }
}

TEST(GlSkybox, TakesSidesOfDifferentSizesAndMissingSides) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  for (int number = 0; number < test::effort(16, 3); ++number) {
    test::Random random(static_cast<std::uint64_t>(number));
    render::Skybox skybox;
    for (std::size_t side = 0; side < 6; ++side)
      if (!random.chance(0.4))
        skybox.sides[side] = make_side(1 + static_cast<std::uint32_t>(random.below(60)),
                                       1 + static_cast<std::uint32_t>(random.below(60)), random);
    SceneView view = any_sky_view(*level.level, random);
    view.scene.skybox = &skybox;
    if (number % 2 == 1) view.scene.fog = {.density = 0.02f, .color = {0.1f, 0.9f, 0.4f}};
    EXPECT_GE(pair.compare(view.scene, {}), kSkyboxEqualShare) << number;
  }
}

// Empty sides have the fog's color, so the same skybox must be uploaded again when that changes, and another
// one of the same size, too.
TEST(GlSkybox, ChangesFromFrameToFrame) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  test::Random random(5);
  const render::Skybox first = make_skybox(16, random), second = make_skybox(16, random);
  const render::Skybox empty;
  SceneView view = any_sky_view(*level.level, random);
  for (const render::Skybox* skybox : {&first, &second, &empty, static_cast<const render::Skybox*>(nullptr)})
    for (const float red : {0.0f, 0.5f, 1.0f}) {
      view.scene.skybox = skybox;
      view.scene.fog = {.density = 0.01f, .color = {red, 1, 0}};
      EXPECT_GE(pair.compare(view.scene, {}), kSkyboxEqualShare);
    }
}

}  // namespace
}  // namespace temblor::render_gl
