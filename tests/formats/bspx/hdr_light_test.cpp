#include "formats/bspx/hdr_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace temblor::test {
namespace {

using math::Vec3;

// Values that follow from the definition of RGB9_E5.
TEST(HdrLight, PacksKnownValues) {
  EXPECT_EQ(formats::pack_e5bgr9(Vec3(0.0f)), 0u);
  // 1 = 256 * 2^(16 - 24).
  EXPECT_EQ(formats::pack_e5bgr9(Vec3(1, 0.5f, 0)), 16u << 27 | 128u << 9 | 256u);
  EXPECT_EQ(formats::pack_e5bgr9(Vec3(0, 0, 65408)), 31u << 27 | 511u << 18);
  EXPECT_EQ(formats::pack_e5bgr9(Vec3(1e9f, -5, 0)), 31u << 27 | 511u) << "limited";
  // 511.9 / 512 rounds up to 512, which needs the next exponent.
  EXPECT_EQ(formats::unpack_e5bgr9(formats::pack_e5bgr9(Vec3(511.9f / 512))).x, 1.0f);
  EXPECT_EQ(formats::unpack_e5bgr9(16u << 27 | 128u << 9 | 256u), Vec3(1, 0.5f, 0));
}

TEST(HdrLight, IsExactToNineBitsOfTheBrightestChannel) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> exponent(-12, 15.9f), share(0, 1);
  for (int i = 0; i < 20000; ++i) {
    const float brightest = std::exp2(exponent(random));
    const Vec3 light(brightest, brightest * share(random), brightest * share(random));
    const Vec3 back = formats::unpack_e5bgr9(formats::pack_e5bgr9(light));
    for (int channel = 0; channel < 3; ++channel)
      ASSERT_LE(std::abs(back[channel] - light[channel]), brightest / 511) << light.x << " " << channel;
  }
}

TEST(HdrLight, HasOneNumberForEachSample) {
  formats::Bsp bsp;
  EXPECT_TRUE(formats::read_hdr_light(bsp).value().empty());
  bsp.lighting = {1, 2, 3};
  const std::vector<std::uint32_t> samples = {7, 0xffffffff, 9};
  formats::set_hdr_light(samples, bsp);
  EXPECT_EQ(formats::read_hdr_light(bsp).value(), samples);
  bsp.lighting.push_back(4);
  EXPECT_FALSE(formats::read_hdr_light(bsp).ok());
  formats::set_hdr_light({}, bsp);
  EXPECT_TRUE(bsp.bspx.empty());
}

}  // namespace
}  // namespace temblor::test
