// Mip levels of textures with holes.
#include "render/surfaces/cutout_textures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/levels/drawable_level.h"
#include "support/random.h"

namespace temblor::render {
namespace {

double opaque_share(const std::vector<std::uint8_t>& texels) {
  const auto clear = std::count(texels.begin(), texels.end(), kClearIndex);
  return 1 - static_cast<double>(clear) / static_cast<double>(texels.size());
}

class CutoutTexture : public testing::Test {
 protected:
  // A level with one texture, `width` x `height`, whose texels are given by `texel`.
  template <typename Texel>
  const world::Texture& make(std::uint32_t width, std::uint32_t height, Texel texel) {
    level_.textures.resize(1);
    world::Texture& texture = level_.textures[0];
    texture = {};
    texture.kind = world::TextureKind::kCutout;
    texture.width = width;
    texture.height = height;
    for (std::uint32_t y = 0; y < height; ++y)
      for (std::uint32_t x = 0; x < width; ++x) texture.mips[0].push_back(texel(x, y));
    cutouts_ = CutoutTextures(level_, tables_);
    return cutouts_.drawn(level_, world::TextureIndex{0});
  }

  const test::DrawableLevel drawable_ = test::small_level({.tiny = true});
  const ColorTables tables_ = make_color_tables(drawable_.palette, drawable_.colormap);
  world::Level level_;
  CutoutTextures cutouts_;
};

// Wires of one texel, grids, foliage, bars: none becomes thinner in the distance.
TEST_F(CutoutTexture, KeepsAsMuchOfItOpaque) {
  const auto wire = [](std::uint32_t x, std::uint32_t y) { return x % 8 == 0 || y % 8 == 3; };
  const auto thin = [](std::uint32_t x, std::uint32_t) { return x % 16 == 5; };
  const auto bars = [](std::uint32_t x, std::uint32_t) { return x % 16 < 8; };
  const auto foliage = [](std::uint32_t x, std::uint32_t y) {
    return test::Random(x * 977u + y).chance(0.35);
  };
  const auto expect_share = [&](auto is_opaque, const char* name) {
    const world::Texture& texture = make(64, 128, [&](std::uint32_t x, std::uint32_t y) {
      return is_opaque(x, y) ? std::uint8_t{7} : kClearIndex;
    });
    const double share = opaque_share(texture.mips[0]);
    for (std::size_t mip = 1; mip < 4; ++mip) {
      EXPECT_NEAR(opaque_share(texture.mips[mip]), share, 0.06) << name << ", mip " << mip;
      // Distributed evenly: the same share in each quarter.
      const std::size_t quarter = texture.mips[mip].size() / 4;
      for (std::size_t i = 0; i < 4; ++i) {
        const auto begin = texture.mips[mip].begin() + static_cast<std::ptrdiff_t>(i * quarter);
        EXPECT_NEAR(opaque_share({begin, begin + static_cast<std::ptrdiff_t>(quarter)}), share, 0.15)
            << name << ", mip " << mip << ", quarter " << i;
      }
    }
  };
  expect_share(wire, "wire");
  expect_share(thin, "thin");
  expect_share(bars, "bars");
  expect_share(foliage, "foliage");
}

// The color of clear texels shows nowhere, even if the compiler mixed it into the mip levels.
TEST_F(CutoutTexture, HasNoFringes) {
  test::Random random(1);
  const world::Texture& texture = make(32, 32, [&](std::uint32_t, std::uint32_t) {
    return random.chance(0.5) ? kClearIndex : static_cast<std::uint8_t>(16 + random.below(2));
  });
  const auto brightness = [&](std::uint8_t index) {
    const formats::Rgb color = drawable_.palette[index];
    return color.r + color.g + color.b;
  };
  const int low = std::min(brightness(16), brightness(17)), high = std::max(brightness(16), brightness(17));
  for (std::size_t mip = 1; mip < 4; ++mip)
    for (const std::uint8_t texel : texture.mips[mip]) {
      if (texel == kClearIndex) continue;
      EXPECT_GE(brightness(texel), low - 6);
      EXPECT_LE(brightness(texel), high + 6);
      EXPECT_FALSE(tables_.match.is_fullbright(texel));
    }
}

TEST_F(CutoutTexture, StaysWhollyClearOrOpaque) {
  for (const std::uint8_t index : {kClearIndex, std::uint8_t{9}}) {
    const world::Texture& texture = make(16, 24, [&](std::uint32_t, std::uint32_t) { return index; });
    for (std::size_t mip = 1; mip < 4; ++mip) {
      EXPECT_EQ(texture.mips[mip].size(), (16u >> mip) * (24u >> mip));
      for (const std::uint8_t texel : texture.mips[mip])
        EXPECT_EQ(texel == kClearIndex, index == kClearIndex);
    }
  }
}

// Opaque texels only in the right half: none appear far from them on the left.
TEST_F(CutoutTexture, IsClearWhereAllIsClear) {
  const world::Texture& texture = make(64, 64, [](std::uint32_t x, std::uint32_t y) {
    return x >= 32 && (x + y) % 3 == 0 ? std::uint8_t{7} : kClearIndex;
  });
  for (std::size_t mip = 1; mip < 4; ++mip) {
    const std::size_t width = 64u >> mip;
    for (std::size_t i = 0; i < texture.mips[mip].size(); ++i)
      if (i % width < width / 2) {
        ASSERT_EQ(texture.mips[mip][i], kClearIndex);
      }
  }
}

TEST_F(CutoutTexture, ShiningTexelsStaySo) {
  const world::Texture& texture = make(
      16, 16, [](std::uint32_t x, std::uint32_t) { return x % 2 == 0 ? std::uint8_t{240} : kClearIndex; });
  for (std::size_t mip = 1; mip < 4; ++mip)
    for (const std::uint8_t texel : texture.mips[mip])
      EXPECT_TRUE(texel == kClearIndex || tables_.match.is_fullbright(texel));
}

TEST(CutoutTextures, LeavesOthersAlone) {
  const test::DrawableLevel drawable = test::small_level();
  const ColorTables tables = make_color_tables(drawable.palette, drawable.colormap);
  const CutoutTextures cutouts(*drawable.level, tables);
  for (std::size_t i = 0; i < drawable.level->textures.size(); ++i)
    if (drawable.level->textures[i].kind != world::TextureKind::kCutout) {
      EXPECT_EQ(&cutouts.drawn(*drawable.level, base::to_index<world::TextureIndex>(i)),
                &drawable.level->textures[i]);
    }
}

}  // namespace
}  // namespace temblor::render
