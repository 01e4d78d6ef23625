#include "formats/nearest_colour.h"

#include <gtest/gtest.h>

#include <array>
#include <utility>

#include "artgen/palette.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::formats {
namespace {

// By the definition.
std::uint8_t nearest(const Palette& palette, std::size_t first, std::size_t count, Rgb colour) {
  std::pair<int, std::size_t> best{1 << 30, 0};
  for (std::size_t i = first; i < first + count; ++i) {
    const int dr = palette[i].r - colour.r, dg = palette[i].g - colour.g, db = palette[i].b - colour.b;
    best = std::min(best, {dr * dr + dg * dg + db * db, i});
  }
  return static_cast<std::uint8_t>(best.second);
}

Rgb random_colour(test::Random& random) {
  const std::uint64_t bits = random.bits();
  return {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8),
          static_cast<std::uint8_t>(bits >> 16)};
}

TEST(NearestColour, IsTheDefinitions) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    test::Random random(seed);
    Palette palette = artgen::make_palette();
    if (seed > 0)
      for (Rgb& colour : palette) colour = random_colour(random);
    if (seed == 2) palette.fill({1, 2, 3});
    const std::pair<std::size_t, std::size_t> ranges[] = {{0, 224}, {224, 31}, {0, 255}, {7, 1}};
    const auto [first, count] = ranges[seed];
    const NearestColour finder(palette, first, count);
    for (int i = 0; i < test::effort(100000, 10000); ++i) {
      const Rgb colour = random_colour(random);
      ASSERT_EQ(finder.find(colour), nearest(palette, first, count, colour)) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace temblor::formats
