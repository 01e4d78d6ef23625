// Tests that the comparison of pictures finds the differences it is meant to find.
#include "golden/golden_picture.h"

#include <algorithm>
#include <cstdint>

#include "support/random.h"

namespace temblor::test {
namespace {

constexpr std::uint32_t kWidth = 256, kHeight = 160;

// Stones of 16 pixels, each with a slightly different grain.
formats::Image wall() {
  Random random(1);
  formats::Image image{kWidth, kHeight, {}};
  for (std::uint32_t y = 0; y < kHeight; ++y)
    for (std::uint32_t x = 0; x < kWidth; ++x) {
      const std::uint32_t tone =
          (x % 16 == 0 || y % 16 == 0 ? 40u : 100u) + static_cast<std::uint32_t>(random.below(30));
      image.pixels.push_back(0xff000000u | tone << 16 | tone << 8 | tone / 2);
    }
  return image;
}

TEST(GoldenPicture, IsLikeItself) {
  EXPECT_TRUE(is_like(wall(), wall(), {}));
  EXPECT_TRUE(is_like(wall(), wall(), {.differing_percent = 0, .far_off = 0}));
}

TEST(GoldenPicture, IsNotLikeItselfShiftedByAPixel) {
  formats::Image shifted = wall();
  std::rotate(shifted.pixels.begin(), shifted.pixels.begin() + 1, shifted.pixels.end());
  EXPECT_FALSE(is_like(wall(), shifted, {}));
}

TEST(GoldenPicture, IsNotLikeItselfALevelBrighter) {
  formats::Image brighter = wall();
  for (std::uint32_t& pixel : brighter.pixels) pixel += 0x010101;
  EXPECT_FALSE(is_like(wall(), brighter, {}));
  EXPECT_TRUE(is_like(wall(), brighter, {.step = 1}));
  for (std::uint32_t& pixel : brighter.pixels) pixel += 0x010101;
  EXPECT_FALSE(is_like(wall(), brighter, {.step = 1}));
}

TEST(GoldenPicture, IsNotLikeItselfWithAHole) {
  formats::Image holed = wall();
  for (std::uint32_t i = 0; i < 5; ++i) holed.pixels[(80 + i) * kWidth + 100 + i] = 0xff000000u;
  EXPECT_FALSE(is_like(wall(), holed, {.step = 3}));
}

TEST(GoldenPicture, IsLikeItselfWithFewPixelsMoved) {
  formats::Image moved = wall();
  for (std::uint32_t i = 0; i < 50; ++i) moved.pixels[i * 700] ^= 0x10;
  for (std::uint32_t i = 0; i < 4; ++i) moved.pixels[i * 9000 + 5] = 0xffffffffu;
  EXPECT_TRUE(is_like(wall(), moved, {}));
}

TEST(GoldenPicture, IsNotLikeOneOfAnotherSize) {
  const formats::Image row{8, 1, std::vector<std::uint32_t>(8)}, column{1, 8, row.pixels};
  EXPECT_FALSE(is_like(row, column, {}));
  EXPECT_EQ(side_by_side(row, column).width, 8u + 1u + 2 * 4);
}

TEST(GoldenPicture, DifferenceIsShownEightTimesBesideBoth) {
  const formats::Image expected{1, 2, {0xff102030u, 0xff000000u}}, got{1, 2, {0xff0f2235u, 0xffff0000u}};
  const formats::Image shown = side_by_side(expected, got);
  ASSERT_EQ(shown.width, 3u * 5);
  ASSERT_EQ(shown.height, 2u);
  EXPECT_EQ(shown.pixels[0], 0xff102030u);
  EXPECT_EQ(shown.pixels[5], 0xff0f2235u);
  EXPECT_EQ(shown.pixels[10], 0xff081028u);
  EXPECT_EQ(shown.pixels[25], 0xffff0000u);
}

}  // namespace
}  // namespace temblor::test
