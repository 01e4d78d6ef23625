#include "formats/images/palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/game_data.h"
#include "support/mutations.h"

namespace temblor::formats {
namespace {

Palette random_palette(test::Random& random) {
  Palette palette;
  for (Rgb& color : palette)
    color = {static_cast<std::uint8_t>(random.below(256)), static_cast<std::uint8_t>(random.below(256)),
             static_cast<std::uint8_t>(random.below(256))};
  return palette;
}

// Squared distances are exact, so ties are real ties.
double distance(const Rgb& color, const std::array<double, 3>& target) {
  const double r = color.r - target[0], g = color.g - target[1], b = color.b - target[2];
  return r * r + g * g + b * b;
}

std::array<double, 3> lit(const Rgb& color, int row) {
  const auto channel = [row](int value) {
    return std::min(255.0, std::floor(value * (63 - row) / 32.0 + 0.5));
  };
  return {channel(color.r), channel(color.g), channel(color.b)};
}

TEST(Palette, ReadsRgbTriples) {
  base::ByteVector bytes(768);
  bytes[3 * 7] = std::byte{1};
  bytes[3 * 7 + 1] = std::byte{2};
  bytes[3 * 7 + 2] = std::byte{3};
  const auto palette = read_palette(bytes);
  ASSERT_TRUE(palette.ok());
  EXPECT_EQ((*palette)[7], (Rgb{1, 2, 3}));
  EXPECT_EQ((*palette)[8], (Rgb{0, 0, 0}));
  EXPECT_EQ(write_palette(*palette), bytes);
}

TEST(Palette, NeedsAllColors) {
  for (const std::size_t size : {0, 1, 767}) EXPECT_FALSE(read_palette(base::ByteVector(size)).ok()) << size;
  for (const std::size_t size : {768, 769, 16384})
    EXPECT_TRUE(read_palette(base::ByteVector(size)).ok()) << size;
}

TEST(Colormap, ReadsWithAndWithoutFullbrightCount) {
  test::Random random(3);
  base::ByteVector bytes = test::random_bytes(random, 16384);
  const auto without = read_colormap(bytes);
  ASSERT_TRUE(without.ok());
  EXPECT_EQ(without->fullbrights, 32);
  EXPECT_TRUE(std::ranges::equal(without->rows, base::as_u8(bytes)));
  bytes.push_back(std::byte{16});
  const auto with = read_colormap(bytes);
  ASSERT_TRUE(with.ok());
  EXPECT_EQ(with->fullbrights, 16);
  EXPECT_EQ(write_colormap(*with), bytes);
}

TEST(Colormap, NeedsAllRows) {
  for (const std::size_t size : {0, 768, 16383})
    EXPECT_FALSE(read_colormap(base::ByteVector(size)).ok()) << size;
  base::ByteVector long_file(16390, std::byte{7});
  long_file[16384] = std::byte{20};
  ASSERT_TRUE(read_colormap(long_file).ok());
  EXPECT_EQ(read_colormap(long_file)->fullbrights, 20);
}

TEST(Colormap, ComputedColormapUsesNearestColors) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    test::Random random(seed);
    const Palette palette = random_palette(random);
    const Colormap colormap = make_colormap(palette);
    for (int row = 0; row < 64; ++row) {
      for (int index = 0; index < 256; ++index) {
        const int chosen = colormap.rows[static_cast<std::size_t>(row * 256 + index)];
        if (index >= 224) {
          ASSERT_EQ(chosen, index);
          continue;
        }
        ASSERT_NE(chosen, 255);
        const auto target = lit(palette[static_cast<std::size_t>(index)], row);
        const double chosen_distance = distance(palette[static_cast<std::size_t>(chosen)], target);
        for (int other = 0; other < 255; ++other) {
          const double other_distance = distance(palette[static_cast<std::size_t>(other)], target);
          ASSERT_TRUE(chosen_distance < other_distance ||
                      (chosen_distance == other_distance && chosen <= other))
              << "seed " << seed << " row " << row << " index " << index << ": " << chosen << " or " << other;
        }
      }
    }
  }
}

TEST(Colormap, ComputedColormapEqualsStock) {
  DATA_FOLDER_OR_SKIP(data);
  const auto palette = read_palette(test::read_file(data / "id1" / "gfx" / "palette.lmp"));
  const auto stock = read_colormap(test::read_file(data / "id1" / "gfx" / "colormap.lmp"));
  ASSERT_TRUE(palette.ok() && stock.ok());
  EXPECT_EQ(make_colormap(*palette).rows, stock->rows);
}

}  // namespace
}  // namespace temblor::formats
