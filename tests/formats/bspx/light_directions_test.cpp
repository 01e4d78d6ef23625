#include "formats/bspx/light_directions.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "support/random.h"

namespace temblor::test {
namespace {

using namespace std::string_literals;

TEST(LightDirections, VectorsSurvivePacking) {
  Random random(7);
  for (int i = 0; i < 10'000; ++i) {
    math::Vec3 vector;
    for (int axis = 0; axis < 3; ++axis) vector[axis] = static_cast<float>(random.uniform(-1, 1));
    const auto packed = formats::pack_direction(vector);
    const math::Vec3 back = formats::unpack_direction(packed);
    for (int axis = 0; axis < 3; ++axis) ASSERT_NEAR(back[axis], vector[axis], 0.5 / 127 + 1e-6) << i;
  }
  EXPECT_EQ(formats::pack_direction({0, 0, 1}), (std::array<std::uint8_t, 3>{128, 128, 255}));
  EXPECT_EQ(formats::pack_direction({-1, -7, 7}), (std::array<std::uint8_t, 3>{1, 1, 255}));
}

TEST(LightDirections, LumpHasThreeBytesForEachSample) {
  formats::Bsp bsp;
  bsp.lighting.resize(2);
  EXPECT_TRUE(formats::read_light_directions(bsp).value().empty());
  const std::vector<std::uint8_t> samples{128, 128, 255, 1, 128, 128};
  for (int time = 0; time < 2; ++time) formats::set_light_directions(samples, bsp);
  EXPECT_EQ(bsp.bspx.size(), 1u);
  EXPECT_EQ(formats::read_light_directions(bsp).value(), samples);
  bsp.lighting.resize(3);
  EXPECT_EQ(formats::read_light_directions(bsp).error().what,
            "lump LIGHTINGDIR: 6 bytes, but 3 samples need 9");
  formats::set_light_directions({}, bsp);
  EXPECT_TRUE(bsp.bspx.empty());
}

TEST(LightDirections, FileHasTheHeaderOfColoredLight) {
  const std::string file = "QLIT\1\0\0\0\x80\x80\xff"s;
  const auto samples = formats::read_lux(base::as_bytes(file));
  ASSERT_TRUE(samples.ok());
  EXPECT_EQ(*samples, (std::vector<std::uint8_t>{128, 128, 255}));
  EXPECT_EQ(base::as_text(formats::write_lux(*samples)), file);
  for (std::size_t size = 0; size < file.size(); ++size)
    EXPECT_EQ(formats::read_lux(base::as_bytes(file.substr(0, size))).ok(), size == 8) << size;
  EXPECT_EQ(formats::read_lux(base::as_bytes("QLIT\2\0\0\0"s)).error().what,
            "version 2 of light directions is not supported (supported: 1)");
}

}  // namespace
}  // namespace temblor::test
