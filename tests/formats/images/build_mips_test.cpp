#include "formats/images/build_mips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "artgen/palette.h"
#include "formats/archives/wad.h"
#include "formats/images/wad_texture.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/random.h"

namespace temblor::formats {
namespace {

using Mips = std::array<std::vector<std::uint8_t>, 4>;

bool is_bright(std::uint8_t index) {
  return index >= 224;
}

const MipColors& made_colors() {
  static const MipColors colors(artgen::make_palette());
  return colors;
}

// The mean square of each channel, over all texels that are not holes.
std::array<double, 3> mean_light(const std::vector<std::uint8_t>& mip, bool has_holes,
                                 const Palette& palette) {
  std::array<double, 3> sum{};
  double count = 0;
  for (const std::uint8_t index : mip) {
    if (has_holes && index == 255) continue;
    const Rgb& color = palette[index];
    sum[0] += color.r * color.r;
    sum[1] += color.g * color.g;
    sum[2] += color.b * color.b;
    ++count;
  }
  for (double& channel : sum) channel /= std::max(count, 1.0);
  return sum;
}

std::size_t count_matching(const std::vector<std::uint8_t>& mip, bool (*is_one)(std::uint8_t)) {
  return static_cast<std::size_t>(std::count_if(mip.begin(), mip.end(), is_one));
}

// Checks the rules for every texel, given the four above it.
void check_texels(const Mips& mips, std::uint32_t width, std::uint32_t height, bool has_holes) {
  for (unsigned k = 1; k < 4; ++k) {
    const std::uint32_t w = width >> k, h = height >> k;
    ASSERT_EQ(mips[k].size(), std::size_t{w} * h);
    for (std::uint32_t y = 0; y < h; ++y)
      for (std::uint32_t x = 0; x < w; ++x) {
        int holes = 0, bright = 0;
        for (const std::uint32_t i : {0u, 1u, 2u, 3u}) {
          const std::uint8_t above =
              mips[k - 1][std::size_t{2 * y + i / 2} * (width >> (k - 1)) + 2 * x + i % 2];
          if (has_holes && above == 255)
            ++holes;
          else if (is_bright(above))
            ++bright;
        }
        const std::uint8_t index = mips[k][std::size_t{y} * w + x];
        ASSERT_EQ(index == 255, holes >= 3) << "mip " << k << " at " << x << ", " << y;
        const bool is_got_bright = index != 255 && is_bright(index);
        ASSERT_TRUE(!is_got_bright || 2 * bright >= 4 - holes);
        ASSERT_TRUE(is_got_bright || bright != 4);
      }
  }
}

TEST(BuildMips, KeepsSingleColor) {
  for (const std::uint8_t index : std::initializer_list<std::uint8_t>{0, 15, 100, 223, 224, 254}) {
    const Mips mips = build_mips(std::vector<std::uint8_t>(32 * 16, index), 32, 16, false, made_colors());
    for (unsigned k = 0; k < 4; ++k) {
      ASSERT_EQ(mips[k].size(), std::size_t{32u >> k} * (16u >> k));
      for (const std::uint8_t got : mips[k])
        EXPECT_EQ(made_colors().palette[got], made_colors().palette[index]);
    }
  }
}

TEST(BuildMips, DithersMeanOfTwoColors) {
  // A checkerboard of black and white has half the light of white, like a gray of 255 / sqrt(2).
  Palette palette{};
  for (std::size_t i = 0; i < 3; ++i) palette[i] = Rgb{255, 255, 255};
  palette[0] = {0, 0, 0};
  palette[1] = {180, 180, 180};
  const MipColors colors(palette);
  std::vector<std::uint8_t> board(64 * 64);
  for (std::size_t i = 0; i < board.size(); ++i) board[i] = (i + i / 64) % 2 == 0 ? 0 : 2;
  const Mips mips = build_mips(board, 64, 64, false, colors);
  EXPECT_GT(std::count(mips[1].begin(), mips[1].end(), 1), 1000);  // of 1024: almost everywhere
  // If the palette lacks that gray, half of the texels are white.
  palette[1] = {0, 0, 0};
  const Mips dithered = build_mips(board, 64, 64, false, MipColors(palette));
  EXPECT_NEAR(static_cast<double>(std::count(dithered[1].begin(), dithered[1].end(), 2)), 512, 20);
}

TEST(BuildMips, OddSizesDropLastTexels) {
  const Mips mips = build_mips(std::vector<std::uint8_t>(5 * 3, 7), 5, 3, false, made_colors());
  EXPECT_EQ(mips[1].size(), 2u);
  EXPECT_EQ(mips[2].size(), 0u);
}

TEST(BuildMips, RandomTextures) {
  for (int seed = 0; seed < test::effort(60, 10); ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(static_cast<std::uint64_t>(seed));
    const auto width = static_cast<std::uint32_t>(16 * (1 + random.below(4)));
    const auto height = static_cast<std::uint32_t>(16 * (1 + random.below(4)));
    const bool has_holes = random.chance(0.5);
    const double bright_share = random.uniform(0, 1), hole_share = has_holes ? random.uniform(0, 1) : 0;
    std::vector<std::uint8_t> mip0(std::size_t{width} * height);
    for (std::uint8_t& index : mip0)
      index = static_cast<std::uint8_t>(random.chance(hole_share)     ? 255
                                        : random.chance(bright_share) ? 224 + random.below(31)
                                                                      : random.below(224));
    const Mips mips = build_mips(mip0, width, height, has_holes, made_colors());
    EXPECT_EQ(mips[0], mip0);
    check_texels(mips, width, height, has_holes);
  }
}

TEST(BuildMips, StockTexturesKeepTheirMeanColor) {
  DATA_FOLDER_OR_SKIP(data);
  const auto palette = read_palette(test::read_file(data / "id1" / "gfx" / "palette.lmp"));
  ASSERT_TRUE(palette.ok());
  const MipColors colors(*palette);
  int textures = 0;
  for (const char* wad : {"lq_tech.wad", "lq_liquidsky.wad", "lq_dev.wad"}) {
    const base::ByteVector bytes = test::read_file(data / "wads" / wad);
    const auto lumps = read_wad(bytes);
    for (const WadLump& lump : lumps.value()) {
      if (test::kQuick && textures >= 20) break;
      if (lump.type != kWadTexture) continue;
      SCOPED_TRACE(lump.name);
      const WadTexture texture = read_wad_texture(lump.data).value();
      const bool has_holes = texture.name.starts_with('{');
      const Mips mips = build_mips(texture.mips[0], texture.width, texture.height, has_holes, colors);
      check_texels(mips, texture.width, texture.height, has_holes);
      ++textures;
      // Thin lines at the edge of a hole and fullbright specks have another weight in smaller levels.
      if (has_holes || count_matching(mips[0], is_bright) != 0) continue;
      const auto whole = mean_light(mips[0], false, *palette);
      for (unsigned k = 1; k < 4; ++k) {
        const auto mean = mean_light(mips[k], false, *palette);
        for (std::size_t c = 0; c < 3; ++c) {
          const double off = std::abs(std::sqrt(mean[c]) - std::sqrt(whole[c]));
          EXPECT_LT(off, 2 + 48.0 / (std::min(texture.width, texture.height) >> k))
              << "mip " << k << ", of 255";
        }
      }
    }
  }
  EXPECT_GE(textures, 20);
}

}  // namespace
}  // namespace temblor::formats
