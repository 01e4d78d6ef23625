#include "formats/images/colored_texture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "artgen/palette.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::formats {
namespace {

using test::effort;
using test::Random;

const MipColors& game_colors() {
  static const MipColors colors(artgen::make_palette());
  return colors;
}

std::uint32_t to_pixel_color(Rgb color, std::uint32_t alpha = 255) {
  return alpha << 24 | std::uint32_t{color.r} << 16 | std::uint32_t{color.g} << 8 | color.b;
}

Image make_image(std::uint32_t width, std::uint32_t height, auto pixel_at) {
  Image image{width, height, {}};
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x) image.pixels.push_back(pixel_at(x, y));
  return image;
}

// The palette entries that are not full-bright and have a color of their own.
std::vector<std::uint8_t> unique_dull_indices() {
  const Palette& palette = game_colors().palette;
  std::vector<std::uint8_t> found;
  for (std::size_t i = 0; i < kFirstFullbright; ++i)
    if (std::find(palette.begin(), palette.begin() + static_cast<std::ptrdiff_t>(i), palette[i]) ==
        palette.begin() + static_cast<std::ptrdiff_t>(i))
      found.push_back(static_cast<std::uint8_t>(i));
  return found;
}

double mean_light(std::uint32_t color) {
  double sum = 0;
  for (const unsigned shift : {0u, 8u, 16u}) {
    const double channel = color >> shift & 0xff;
    sum += channel * channel;
  }
  return sum / 3;
}

TEST(ColoredTexture, KeepsTheGamesOwnColors) {
  const std::vector<std::uint8_t> usable = unique_dull_indices();
  Random random(1);
  std::vector<std::uint8_t> indices(48 * 32);
  for (std::uint8_t& index : indices) index = usable[random.below(usable.size())];
  const Image picture = make_image(48, 32, [&](std::uint32_t x, std::uint32_t y) {
    return to_pixel_color(game_colors().palette[indices[y * 48 + x]]);
  });
  const ColoredTexture made = make_colored_texture({48, 32}, picture, {}, game_colors());
  EXPECT_EQ(made.mips[0], indices);
  EXPECT_EQ(made.colors.detail, 0);
  EXPECT_EQ(made.colors.colors[0], picture.pixels);
  EXPECT_TRUE(made.colors.glow.empty());
}

// A palette of its own: any 256 colors.
TEST(ColoredTexture, ShowsAPaletteOfItsOwn) {
  Palette own;
  Random random(2);
  for (Rgb& color : own)
    color = {static_cast<std::uint8_t>(random.below(256)), static_cast<std::uint8_t>(random.below(256)),
             static_cast<std::uint8_t>(random.below(256))};
  std::vector<std::uint8_t> indices(16 * 16);
  std::iota(indices.begin(), indices.end(), std::uint8_t{0});
  for (const bool has_holes : {false, true}) {
    const ColoredTexture made = make_colored_texture({16, 16, has_holes}, indices, own, game_colors());
    for (std::size_t i = 0; i < indices.size(); ++i) {
      const bool clear = has_holes && i == 255;
      EXPECT_EQ(made.colors.colors[0][i], clear ? 0 : to_pixel_color(own[i]));
      EXPECT_EQ(made.mips[0][i] == 255, clear);
      EXPECT_TRUE(clear || made.mips[0][i] < kFirstFullbright) << "full-bright, but it does not glow";
    }
  }
}

// Independent of the search tables: a single color has no diffused error, so its first texel is the nearest
// of all dull entries.
TEST(ColoredTexture, MatchesTheNearestDullColor) {
  const Palette& palette = game_colors().palette;
  for (int seed = 0; seed < effort(3000, 300); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const Rgb color{static_cast<std::uint8_t>(random.below(256)),
                    static_cast<std::uint8_t>(random.below(256)),
                    static_cast<std::uint8_t>(random.below(256))};
    const auto distance = [&](std::size_t i) {
      const int r = palette[i].r - color.r, g = palette[i].g - color.g, b = palette[i].b - color.b;
      return r * r + g * g + b * b;
    };
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < kFirstFullbright; ++i)
      if (distance(i) < distance(nearest)) nearest = i;
    const ColoredTexture made =
        make_colored_texture({1, 1}, {1, 1, {to_pixel_color(color)}}, {}, game_colors());
    ASSERT_EQ(made.mips[0][0], nearest) << "seed " << seed;
  }
}

TEST(ColoredTexture, KeepsAsManyFineLevelsAsThePictureNeeds) {
  struct Case {
    std::uint32_t width, height;  // of the picture, for a texture of 32 x 16
    int detail;
  };
  for (const Case& c : {Case{32, 16, 0},
                        {8, 8, 0},
                        {33, 16, 1},
                        {64, 32, 1},
                        {32, 64, 2},
                        {100, 20, 2},
                        {128, 64, 2},
                        {256, 128, 3},
                        {1000, 900, 3}}) {
    const Image picture = make_image(
        c.width, c.height, [](std::uint32_t x, std::uint32_t y) { return 0xff000000u | x << 8 | y; });
    const ColoredTexture made = make_colored_texture({32, 16}, picture, {}, game_colors());
    ASSERT_EQ(made.colors.detail, c.detail) << c.width << " x " << c.height;
    ASSERT_EQ(made.colors.fine_indices.size(), static_cast<std::size_t>(c.detail));
    ASSERT_EQ(made.colors.colors.size(), static_cast<std::size_t>(c.detail + 4));
    for (int mip = -c.detail; mip < 4; ++mip) {
      const double scale = std::ldexp(1.0, -mip);
      const auto texels = static_cast<std::size_t>(32 * scale * 16 * scale);
      const auto& indices = mip < 0 ? made.colors.fine_indices[static_cast<std::size_t>(-mip - 1)]
                                    : made.mips[static_cast<std::size_t>(mip)];
      EXPECT_EQ(indices.size(), texels) << mip;
      EXPECT_EQ(made.colors.colors[static_cast<std::size_t>(mip + c.detail)].size(), texels) << mip;
    }
    EXPECT_TRUE(c.width != 256 || made.colors.colors[0] == picture.pixels) << "nothing to resample";
  }
}

// All levels emit as much light as the picture: exactly in colors, and nearly in palette entries.
TEST(ColoredTexture, KeepsItsBrightnessInAllLevels) {
  for (int seed = 0; seed < effort(40, 8); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const Image picture = make_image(128, 128, [&](std::uint32_t, std::uint32_t) {
      return to_pixel_color({static_cast<std::uint8_t>(random.below(200)),
                             static_cast<std::uint8_t>(random.below(200)),
                             static_cast<std::uint8_t>(random.below(200))});
    });
    double wanted = 0;
    for (const std::uint32_t pixel : picture.pixels) wanted += mean_light(pixel);
    wanted /= static_cast<double>(picture.pixels.size());
    const ColoredTexture made = make_colored_texture({64, 64}, picture, {}, game_colors());
    for (int mip = -1; mip < 4; ++mip) {
      const auto& colors = made.colors.colors[static_cast<std::size_t>(mip + 1)];
      double got = 0;
      for (const std::uint32_t color : colors) got += mean_light(color);
      EXPECT_NEAR(std::sqrt(got / static_cast<double>(colors.size())), std::sqrt(wanted), 1.5) << mip;
      const auto& indices = mip < 0 ? made.colors.fine_indices[0] : made.mips[static_cast<std::size_t>(mip)];
      double shown = 0;
      for (const std::uint8_t index : indices)
        shown += mean_light(to_pixel_color(game_colors().palette[index]));
      EXPECT_NEAR(std::sqrt(shown / static_cast<double>(indices.size())), std::sqrt(wanted), 6) << mip;
    }
  }
}

// A texel is full-bright in palette entries if and only if it glows more than it reflects.
TEST(ColoredTexture, GlowsWhereTheGlowIsBrighter) {
  const Image gray = make_image(16, 16, [](std::uint32_t, std::uint32_t) { return 0xff808080u; });
  const Image glow = make_image(16, 16, [](std::uint32_t x, std::uint32_t) {
    return x < 4 ? 0xff000000u : x < 8 ? 0xff404040u : x < 12 ? 0xffc0c0c0u : 0xffff8000u;
  });
  const ColoredTexture made = make_colored_texture({16, 16}, gray, glow, game_colors());
  for (std::size_t i = 0; i < 256; ++i) {
    EXPECT_EQ(made.mips[0][i] >= kFirstFullbright, i % 16 >= 8) << i;
    EXPECT_NE(made.mips[0][i], kTransparentIndex);
    EXPECT_EQ(made.colors.colors[0][i], 0xff808080u);
    EXPECT_EQ(made.colors.glow[0][i], glow.pixels[i] & 0xffffffu);
  }
  ASSERT_EQ(made.colors.glow.size(), 4u);
  EXPECT_EQ(made.colors.glow[2][3], 0xff8000u);  // a quarter of the width
  // The glow may have another size than the picture.
  const Image small_glow =
      make_image(4, 1, [&](std::uint32_t x, std::uint32_t) { return glow.pixels[x * 4]; });
  EXPECT_EQ(make_colored_texture({16, 16}, gray, small_glow, game_colors()).colors.glow, made.colors.glow);
}

// Fences: clear texels have no color, and every level is as opaque as the first.
TEST(ColoredTexture, KeepsTheShareOfHoles) {
  for (int seed = 0; seed < effort(40, 8); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const double opaque_share = random.uniform(0.1, 0.9);
    const Image picture = make_image(64, 64, [&](std::uint32_t, std::uint32_t) {
      const std::uint64_t alpha = random.chance(opaque_share) ? 128 + random.below(128) : random.below(128);
      return to_pixel_color({200, 100, 50}, static_cast<std::uint32_t>(alpha));
    });
    const auto opaque = std::ranges::count_if(picture.pixels, [](std::uint32_t p) { return p >> 24 >= 128; });
    const double wanted = static_cast<double>(opaque) / static_cast<double>(picture.pixels.size());
    const ColoredTexture made = make_colored_texture({64, 64, true}, picture, {}, game_colors());
    for (std::size_t mip = 0; mip < 4; ++mip) {
      const auto& colors = made.colors.colors[mip];
      std::size_t clear = 0;
      for (std::size_t i = 0; i < colors.size(); ++i) {
        ASSERT_EQ(colors[i] == 0, made.mips[mip][i] == kTransparentIndex);
        clear += colors[i] == 0;
        // Clear texels do not tint the others.
        ASSERT_TRUE(colors[i] == 0 || colors[i] == 0xffc86432u) << colors[i];
      }
      const double share = 1 - static_cast<double>(clear) / static_cast<double>(colors.size());
      EXPECT_NEAR(share, wanted, mip < 3 ? 0.03 : 0.06) << "seed " << seed << ", mip " << mip;
    }
    // Without holes, alpha does not matter.
    const ColoredTexture solid = make_colored_texture({64, 64, false}, picture, {}, game_colors());
    for (const std::uint32_t color : solid.colors.colors[0]) ASSERT_EQ(color, 0xffc86432u);
  }
}

}  // namespace
}  // namespace temblor::formats
