// How textures become drawable: kinds, missing textures, mip levels.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "support/game_data.h"
#include "world/level.h"
#include "world/test_levels.h"

namespace temblor::world {
namespace {

// The tiny level with these textures instead of its own. If there are fewer, some faces have no texture.
TestLevel level_with(std::vector<formats::BspMiptex> miptexes) {
  formats::Bsp bsp = artgen::make_small_level({.tiny = true});
  bsp.miptexes = std::move(miptexes);
  return test_level("textures", std::move(bsp));
}

formats::BspMiptex numbered_miptex(std::string name, std::uint32_t width, std::uint32_t height) {
  formats::BspMiptex miptex;
  miptex.present = true;
  miptex.name = std::move(name);
  miptex.width = width;
  miptex.height = height;
  for (std::uint32_t i = 0; i < width * height; ++i)
    miptex.mips[0].push_back(static_cast<std::uint8_t>(i % 253));
  return miptex;
}

void expect_drawable(const Texture& texture) {
  EXPECT_GE(texture.width, 1u);
  EXPECT_GE(texture.height, 1u);
  for (unsigned mip = 0; mip < 4; ++mip) {
    const std::size_t width = std::max(1u, texture.width >> mip);
    const std::size_t height = std::max(1u, texture.height >> mip);
    EXPECT_EQ(texture.mips[mip].size(), width * height) << texture.name << " mip " << mip;
  }
}

TEST(Textures, KindComesFromTheName) {
  const std::pair<const char*, TextureKind> kinds[] = {
      {"brick", TextureKind::kOpaque}, {"sky1", TextureKind::kSky},      {"SKY_b", TextureKind::kSky},
      {"sk", TextureKind::kOpaque},    {"*lava", TextureKind::kLiquid},  {"{grate", TextureKind::kCutout},
      {"+0a", TextureKind::kOpaque},   {"whisky", TextureKind::kOpaque}, {"", TextureKind::kOpaque},
  };
  std::vector<formats::BspMiptex> miptexes;
  for (const auto& [name, kind] : kinds) miptexes.push_back(numbered_miptex(name, 16, 16));
  const TestLevel test = level_with(miptexes);
  for (std::size_t i = 0; i < std::size(kinds); ++i)
    EXPECT_EQ(test.level->textures[i].kind, kinds[i].second) << kinds[i].first;
}

// The names mean more in a level of Half-Life.
TEST(Textures, HalfLifeHasOtherLiquidsAndTexturesThatShowNothing) {
  for (const bool half_life : {false, true}) {
    formats::Bsp bsp = artgen::make_small_level({.tiny = true});
    if (half_life) bsp.version = formats::BspVersion::k30;
    bsp.miptexes = {numbered_miptex("!water", 16, 16), numbered_miptex("AAATRIGGER", 16, 16),
                    numbered_miptex("clipper", 16, 16)};
    const TestLevel test = test_level("textures", std::move(bsp));
    EXPECT_EQ(test.level->textures[0].kind, half_life ? TextureKind::kLiquid : TextureKind::kOpaque);
    const Texture& tool = test.level->textures[1];
    expect_drawable(tool);
    EXPECT_EQ(tool.kind, half_life ? TextureKind::kCutout : TextureKind::kOpaque);
    EXPECT_EQ(std::ranges::all_of(tool.mips[0], [](int index) { return index == 255; }), half_life);
    EXPECT_FALSE(tool.missing);
    EXPECT_EQ(test.level->textures[2].kind, TextureKind::kOpaque);
  }
}

TEST(Textures, OfStockLevelsAreKeptAsStored) {
  DATA_FOLDER_OR_SKIP(base_folder);
  for (const TestLevel& test : stock_levels(base_folder)) {
    for (std::size_t i = 0; i < test.bsp.miptexes.size(); ++i) {
      const Texture& texture = test.level->textures[i];
      expect_drawable(texture);
      EXPECT_EQ(texture.missing, test.bsp.miptexes[i].mips[0].empty());
      if (!texture.missing) {
        EXPECT_EQ(texture.mips, test.bsp.miptexes[i].mips) << texture.name;
      }
    }
  }
}

TEST(Textures, MissingOnesAreACheckerAndSaySo) {
  formats::BspMiptex elsewhere;
  elsewhere.present = true;
  elsewhere.name = "*elsewhere";
  elsewhere.width = elsewhere.height = 16;
  const TestLevel test = level_with({formats::BspMiptex{}, elsewhere});
  for (const Texture& texture : test.level->textures) {
    EXPECT_TRUE(texture.missing);
    EXPECT_EQ(texture.width, 64u);
    EXPECT_EQ(texture.height, 64u);
    expect_drawable(texture);
    const std::uint8_t first = texture.mips[0][0];
    EXPECT_NE(texture.mips[0][8], first);
    EXPECT_NE(texture.mips[0][8 * 64], first);
    EXPECT_EQ(texture.mips[0][8 * 64 + 8], first);
  }
  EXPECT_EQ(test.level->textures[1].kind, TextureKind::kLiquid);
  EXPECT_EQ(test.level->textures[1].name, "*elsewhere");
}

TEST(Textures, ThatALevelDoesNotHaveAtAllAreTheLastOne) {
  const TestLevel test = level_with({});
  ASSERT_EQ(test.level->textures.size(), 1u);
  for (const Face& face : test.level->faces) EXPECT_EQ(base::to_size(face.texture), 0u);
}

TEST(Textures, MipLevelsThatAreNotThereAreSampled) {
  const std::pair<std::uint32_t, std::uint32_t> sizes[] = {{1, 1}, {7, 5}, {16, 2}, {3, 64}, {33, 100}};
  for (const auto& [width, height] : sizes) {
    const TestLevel test = level_with({numbered_miptex("odd", width, height)});
    const Texture& texture = test.level->textures[0];
    EXPECT_FALSE(texture.missing);
    expect_drawable(texture);
    for (unsigned mip = 1; mip < 4; ++mip) {
      const std::uint32_t mip_width = std::max(1u, width >> mip);
      for (std::size_t i = 0; i < texture.mips[mip].size(); ++i) {
        const std::size_t x = (i % mip_width) << mip;
        const std::size_t y = (i / mip_width) << mip;
        ASSERT_EQ(texture.mips[mip][i], (y * width + x) % 253) << width << "x" << height << " mip " << mip;
      }
    }
  }
}

}  // namespace
}  // namespace temblor::world
