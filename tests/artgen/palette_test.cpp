#include "artgen/palette.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

namespace temblor::artgen {
namespace {

int brightness(const formats::Rgb& color) {
  return color.r + color.g + color.b;
}

TEST(Palette, RampsGetBrighterAndRepeatNoColor) {
  const formats::Palette palette = make_palette();
  EXPECT_EQ(palette[0], (formats::Rgb{0, 0, 0}));
  std::set<std::tuple<int, int, int>> colors;
  for (std::size_t i = 0; i < palette.size(); ++i) {
    EXPECT_TRUE(colors.insert({palette[i].r, palette[i].g, palette[i].b}).second) << i;
    if (i % kRampColors != 0 && i != kTransparent) {
      EXPECT_GT(brightness(palette[i]), brightness(palette[i - 1])) << i;
    }
  }
}

TEST(Palette, RampColorsAreInTheirRampAndNeverTransparent) {
  EXPECT_EQ(ramp_color(Ramp::kGray, 0), 0);
  EXPECT_EQ(ramp_color(Ramp::kGray, 1), 15);
  EXPECT_EQ(ramp_color(Ramp::kBrick, -3), 32);
  EXPECT_EQ(ramp_color(Ramp::kBrick, 0.5), 40);
  EXPECT_EQ(ramp_color(Ramp::kFire, 0), kFirstFullbright);
  EXPECT_EQ(ramp_color(Ramp::kElectric, 7), kTransparent - 1);
}

}  // namespace
}  // namespace temblor::artgen
