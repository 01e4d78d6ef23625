#include "formats/images/nearest_color.h"

#include <gtest/gtest.h>

#include <array>
#include <utility>

#include "artgen/palette.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::formats {
namespace {

// Searches by the definition.
std::uint8_t nearest(const Palette& palette, std::size_t first, std::size_t count, Rgb color) {
  std::pair<int, std::size_t> best{1 << 30, 0};
  for (std::size_t i = first; i < first + count; ++i) {
    const int dr = palette[i].r - color.r, dg = palette[i].g - color.g, db = palette[i].b - color.b;
    best = std::min(best, {dr * dr + dg * dg + db * db, i});
  }
  return static_cast<std::uint8_t>(best.second);
}

Rgb random_color(test::Random& random) {
  const std::uint64_t bits = random.bits();
  return {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8),
          static_cast<std::uint8_t>(bits >> 16)};
}

TEST(NearestColor, MatchesBruteForce) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    test::Random random(seed);
    Palette palette = artgen::make_palette();
    if (seed > 0)
      for (Rgb& color : palette) color = random_color(random);
    if (seed == 2) palette.fill({1, 2, 3});
    const std::pair<std::size_t, std::size_t> ranges[] = {{0, 224}, {224, 31}, {0, 255}, {7, 1}};
    const auto [first, count] = ranges[seed];
    const NearestColor finder(palette, first, count);
    for (int i = 0; i < test::effort(100000, 10000); ++i) {
      const Rgb color = random_color(random);
      ASSERT_EQ(finder.find(color), nearest(palette, first, count, color)) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace temblor::formats
