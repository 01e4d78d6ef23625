// Levels whose textures have colors of their own, as whole pictures. Each texture is a picture in exactly the
// palette's colors, so the stock picture is the expectation.
#include <gtest/gtest.h>

#include <cmath>

#include "formats/images/resample.h"
#include "render/color/own_colors.h"
#include "render/renderer.h"
#include "support/effort.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/frames.h"
#include "support/pictures/viewpoints.h"

namespace temblor::test {
namespace {

using render::PixelFormat;

// The lit palette entry nearest to the color of `index`, so that no texel is full-bright and equal colors
// have equal indices.
std::uint8_t dull_index(const formats::MipColors& colors, std::uint8_t index) {
  return colors.dull.find(colors.palette[index]);
}

// The small level without full-bright texels, with the textures as they are or as pictures with `scale` times
// the width and height.
struct ColoredLevels {
  DrawableLevel stock, colored;

  explicit ColoredLevels(std::uint32_t scale) : stock(small_level()), colored(stock) {
    const formats::MipColors colors(stock.palette);
    world::Level own = *stock.level, pictured = *stock.level;
    own.identity = std::make_shared<const world::LevelIdentity>();
    pictured.identity = std::make_shared<const world::LevelIdentity>();
    for (std::size_t i = 0; i < own.textures.size(); ++i) {
      world::Texture& texture = own.textures[i];
      const formats::TextureFrame frame{texture.width, texture.height,
                                        texture.kind == world::TextureKind::kCutout};
      formats::Image picture{texture.width, texture.height, {}};
      for (std::uint8_t& index : texture.mips[0]) {
        const bool clear = frame.has_holes && index == formats::kTransparentIndex;
        if (!clear) index = dull_index(colors, index);
        picture.pixels.push_back(clear ? 0 : render::to_rgb(stock.palette[index]));
      }
      formats::ColoredTexture made = formats::make_colored_texture(
          frame, formats::resample(picture, texture.width * scale, texture.height * scale), {}, colors);
      texture.mips = made.mips;  // the same smaller levels in both
      pictured.textures[i].mips = std::move(made.mips);
      pictured.textures[i].colors = std::make_shared<const formats::TextureColors>(std::move(made.colors));
    }
    stock.level = std::make_shared<const world::Level>(std::move(own));
    colored.level = std::make_shared<const world::Level>(std::move(pictured));
  }
};

FrameCopy draw(const DrawableLevel& drawable, const Viewpoint& viewpoint, const render::Settings& settings,
               PixelFormat format) {
  render::Renderer renderer(drawable.palette, drawable.colormap);
  render::FrameBuffer frame(200, 150, format);
  renderer.render(viewpoint.scene(*drawable.level), settings, frame);
  return copy_picture(frame);
}

Viewpoint any_viewpoint(const world::Level& level, std::uint64_t seed) {
  Random random(seed);
  Viewpoint viewpoint{.camera = random_camera(level, random), .brush_models = shown_brush_models(level)};
  viewpoint.lights = random_lights(viewpoint.camera.origin_world, 3, random);
  return viewpoint;
}

// Mip 0 shows the same colors, whether they come from the palette or from the pictures.
TEST(ColoredTextures, InThePalettesColorsLookLikeStockTextures) {
  const ColoredLevels levels(1);
  for (int seed = 0; seed < effort(20, 4); ++seed) {
    const Viewpoint viewpoint = any_viewpoint(*levels.stock.level, static_cast<std::uint64_t>(seed));
    for (const PixelFormat format : {PixelFormat::kIndexed, PixelFormat::kRgb}) {
      const render::Settings settings{.force_mip = 0};
      EXPECT_EQ(differing_pixels(draw(levels.stock, viewpoint, settings, format),
                                 draw(levels.colored, viewpoint, settings, format)),
                0u)
          << seed;
    }
  }
}

// Four times the width and height, enlarged without new detail, is the same picture where mip 0 or finer is
// drawn. Light is not, since it is interpolated in finer steps. At the borders of texels, rounding may
// differ.
TEST(ColoredTextures, WithMoreTexelsLieInTheSamePlaces) {
  const ColoredLevels levels(4);
  ASSERT_EQ(levels.colored.level->textures[0].finest_mip(), -2);
  std::size_t differing = 0, pixels = 0;
  for (int seed = 0; seed < effort(20, 4); ++seed) {
    const Viewpoint viewpoint = any_viewpoint(*levels.stock.level, static_cast<std::uint64_t>(seed));
    for (const render::MipRule rule : {render::MipRule::kFootprint, render::MipRule::kStock}) {
      const render::Settings settings{.mip_rule = rule, .light_view = render::LightView::kFullBright};
      // In 256 colors, where the smaller mip levels are equal too.
      differing += differing_pixels(draw(levels.stock, viewpoint, settings, PixelFormat::kIndexed),
                                    draw(levels.colored, viewpoint, settings, PixelFormat::kIndexed));
      pixels += 200 * 150;
    }
  }
  EXPECT_LT(static_cast<double>(differing) / static_cast<double>(pixels), 0.005);
}

// Settings that must not matter for pictures, with fine mip levels.
TEST(ColoredTextures, LookTheSameWithAnyThreadsAndKernels) {
  const ColoredLevels levels(4);
  for (int seed = 0; seed < effort(6, 2); ++seed) {
    const Viewpoint viewpoint = any_viewpoint(*levels.colored.level, static_cast<std::uint64_t>(seed));
    for (const PixelFormat format : {PixelFormat::kIndexed, PixelFormat::kRgb}) {
      const FrameCopy expected = draw(levels.colored, viewpoint, {.threads = 1}, format);
      EXPECT_EQ(draw(levels.colored, viewpoint, {.threads = 3}, format), expected);
      EXPECT_EQ(draw(levels.colored, viewpoint, {.threads = 1, .simd_kernels = false}, format), expected);
      EXPECT_EQ(draw(levels.colored, viewpoint, {.threads = 1, .surface_cache = false}, format), expected);
    }
  }
}

TEST(AddSaturated, StopsEachByteAt255) {
  Random random(1);
  for (int i = 0; i < effort(100000, 10000); ++i) {
    const auto a = static_cast<std::uint32_t>(random.bits()), b = static_cast<std::uint32_t>(random.bits());
    std::uint32_t expected = 0;
    for (unsigned shift = 0; shift < 32; shift += 8)
      expected |= std::min(255u, (a >> shift & 255) + (b >> shift & 255)) << shift;
    ASSERT_EQ(render::add_saturated(a, b), expected);
  }
}

}  // namespace
}  // namespace temblor::test
