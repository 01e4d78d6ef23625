// Filters of textures: r_filter and r_filter_sharp.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "math/angles.h"
#include "render_gl/gl_pictures.h"
#include "render_gl/model_scenes.h"
#include "support/effort.h"
#include "support/pictures/viewpoints.h"

namespace temblor::render_gl {
namespace {

using render::TextureFilter;

constexpr TextureFilter kBlending[] = {TextureFilter::kBilinear, TextureFilter::kTrilinear,
                                       TextureFilter::kAnisotropic};

render::Scene see(const test::Viewpoint& viewpoint, const world::Level& level, float units_per_pixel) {
  render::Scene scene = viewpoint.scene(level);
  if (units_per_pixel == 0) return scene;
  scene.camera.projection = render::Projection::kOrthographic;
  scene.camera.units_per_pixel = units_per_pixel;
  return scene;
}

render::FrameBuffer draw(RendererPair& pair, const render::Scene& scene, const render::Settings& settings) {
  render::FrameBuffer frame(320, 200, render::PixelFormat::kRgb);
  const auto drawn = pair.gl().render(scene, settings, frame);
  EXPECT_TRUE(drawn.ok());
  return frame;
}

double green(const render::FrameBuffer& frame, int x, int y) {
  return frame.rgb()[static_cast<std::size_t>(y) * 320 + static_cast<std::size_t>(x)] >> 8 & 255;
}

// The mean square of the difference between neighbors in a row: how rough a picture is. A step that is spread
// over several pixels counts less.
double compute_roughness(const render::FrameBuffer& frame) {
  double sum = 0;
  for (int y = 0; y < 200; ++y)
    for (int x = 1; x < 320; ++x) sum += std::pow(green(frame, x, y) - green(frame, x - 1, y), 2);
  return sum / (200 * 319);
}

// The mean over a picture, which blending keeps.
double compute_mean(const render::FrameBuffer& frame) {
  double sum = 0;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 320; ++x) sum += green(frame, x, y);
  return sum / (200 * 320);
}

double equal_share(const render::FrameBuffer& a, const render::FrameBuffer& b) {
  int equal = 0;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 320; ++x) equal += std::abs(green(a, x, y) - green(b, x, y)) <= 2;
  return equal / (320.0 * 200);
}

// Texels of many pixels: blending makes the picture smooth, and sharp texels stay those of kNearest, except
// for a pixel at their edges.
TEST(GlFilters, BlendLargeTexels) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  for (int number = 0; number < test::effort(6, 2); ++number) {
    test::Random random(static_cast<std::uint64_t>(number));
    const test::Viewpoint viewpoint{.camera = test::random_camera(*level.level, random)};
    const render::Scene scene = see(viewpoint, *level.level, 0.1f);
    const render::FrameBuffer nearest = draw(pair, scene, {});
    for (const TextureFilter filter : kBlending) {
      const render::FrameBuffer smooth = draw(pair, scene, {.filter = filter});
      EXPECT_LT(compute_roughness(smooth), 0.8 * compute_roughness(nearest)) << "view " << number;
      EXPECT_NEAR(compute_mean(smooth), compute_mean(nearest), 4) << "view " << number;
      const render::FrameBuffer sharp = draw(pair, scene, {.filter = filter, .sharp_texels = true});
      EXPECT_GT(equal_share(sharp, nearest), equal_share(smooth, nearest)) << "view " << number;
      EXPECT_NEAR(compute_mean(sharp), compute_mean(nearest), 4) << "view " << number;
    }
  }
}

// Perspective, with all kinds of faces: pictures stay as bright, and none is black or torn.
TEST(GlFilters, KeepTheBrightnessOfAnyView) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  for (int number = 0; number < test::effort(10, 2); ++number) {
    test::Random random(static_cast<std::uint64_t>(number));
    test::Viewpoint viewpoint{.camera = test::random_camera(*level.level, random),
                              .brush_models = test::shown_brush_models(*level.level)};
    viewpoint.lights = test::random_lights(viewpoint.camera.origin_world, 3, random);
    viewpoint.marks = test::random_marks(*level.level, 20, random);
    const render::Scene scene = see(viewpoint, *level.level, 0);
    const render::FrameBuffer nearest = draw(pair, scene, {});
    for (const TextureFilter filter : kBlending)
      for (const bool sharp : {false, true})
        EXPECT_NEAR(compute_mean(draw(pair, scene, {.filter = filter, .sharp_texels = sharp})),
                    compute_mean(nearest), 6)
            << "view " << number << ", filter " << static_cast<int>(filter);
    const render::FrameBuffer again = draw(pair, scene, {});
    EXPECT_EQ(equal_share(again, nearest), 1) << "a filter changes later frames";
  }
}

// Skins are squares of one color, whose borders blend.
TEST(GlFilters, BlendSkins) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  int seen = 0;
  for (int number = 0; number < test::effort(8, 3); ++number) {
    test::Random random(static_cast<std::uint64_t>(number));
    const ModelScene models = random_scene(make_small_models(), *level.level, 6, random);
    const render::Scene scene = models.scene(*level.level);
    render::Scene without = scene;
    without.alias_models = {};
    // Only the models' pixels differ between the two.
    const auto draw_models = [&](const render::Settings& settings) {
      const render::FrameBuffer background = draw(pair, without, settings);
      render::FrameBuffer frame = draw(pair, scene, settings);
      for (std::size_t i = 0; i < frame.pixel_count(); ++i)
        if (frame.rgb()[i] == background.rgb()[i]) frame.rgb()[i] = 0xff000000u;
      return frame;
    };
    const render::FrameBuffer nearest = draw_models({});
    const render::FrameBuffer smooth = draw_models({.filter = TextureFilter::kBilinear});
    const render::FrameBuffer sharp = draw_models({.filter = TextureFilter::kBilinear, .sharp_texels = true});
    if (compute_roughness(nearest) < 10) continue;  // the models are hidden, or almost
    ++seen;
    EXPECT_LT(equal_share(smooth, nearest), 1) << "view " << number;
    EXPECT_LT(compute_roughness(smooth), compute_roughness(nearest)) << "view " << number;
    EXPECT_GE(equal_share(sharp, nearest), equal_share(smooth, nearest)) << "view " << number;
    EXPECT_NEAR(compute_mean(smooth), compute_mean(nearest), 3) << "view " << number;
  }
  EXPECT_GE(seen, 2);
}

// A sprite of 4 x 4 texels that faces the camera, 40 pixels each: a column is clear.
TEST(GlFilters, BlendSpritesWithinTheirOutline) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  constexpr std::uint8_t kDark = 0, kBright = 15, kClear = 255;
  formats::Spr sprite{.orientation = formats::SprOrientation::kParallel};
  formats::SprPicture picture{-2, 2, 4, 4, {}};
  for (int row = 0; row < 4; ++row)
    for (const std::uint8_t texel : {kDark, kBright, kBright, kClear}) picture.texels.push_back(texel);
  sprite.frames.push_back({{picture}, {}});
  test::Random random(1);
  const test::Viewpoint viewpoint{.camera = test::random_camera(*level.level, random)};
  render::Scene scene = see(viewpoint, *level.level, 1.0f / 40);
  const math::Basis axes = math::basis_from_angles(scene.camera.angles_deg);
  const std::vector<render::SpriteInstance> sprites = {
      {.sprite = &sprite,
       .picture = &sprite.frames[0].pictures[0],
       .origin_world = scene.camera.origin_world + math::Vec3(8.0 * axes.forward)}};
  scene.sprites = sprites;
  render::Scene without = scene;
  without.sprites = {};
  const render::FrameBuffer background = draw(pair, without, {.filter = TextureFilter::kBilinear});
  const render::FrameBuffer nearest = draw(pair, scene, {});
  const render::FrameBuffer smooth = draw(pair, scene, {.filter = TextureFilter::kBilinear});
  const auto shade = [&](std::uint8_t index) { return static_cast<double>(level.palette[index].g); };
  // Texels are 40 pixels wide, from column 80 on: the border of the first two is at 120.
  const int y = 100;
  EXPECT_NEAR(green(nearest, 110, y), shade(kDark), 2);
  EXPECT_NEAR(green(nearest, 130, y), shade(kBright), 2);
  EXPECT_NEAR(green(smooth, 100, y), shade(kDark), 4);
  EXPECT_NEAR(green(smooth, 120, y), (shade(kDark) + shade(kBright)) / 2, 4);
  EXPECT_NEAR(green(smooth, 140, y), shade(kBright), 4);
  EXPECT_NEAR(green(smooth, 198, y), shade(kBright), 4) << "clear texels must not darken others";
  EXPECT_EQ(green(smooth, 202, y), green(background, 202, y)) << "clear beyond the border";
}

}  // namespace
}  // namespace temblor::render_gl
