// Light channels: which lights reach which brushes, and which brushes stop them.
#include <gtest/gtest.h>

#include "compiler/light/keys/key_room.h"

namespace temblor::test {
namespace {

using math::Vec3d;

// Places on the tops of two blocks and on the floor between them; luxels lie at multiples of 16.
constexpr Vec3d kLeftTop(-64, 0, 32), kRightTop(64, 0, 32), kFloor(0, 0, 0);

std::string two_blocks(std::string_view left_keys, std::string_view right_keys) {
  return box_entity(left_keys, {-80, -16, 8}, {-48, 16, 32}) +
         box_entity(right_keys, {48, -16, 8}, {80, 16, 32});
}

TEST(LightChannels, LightReachesBrushesWithACommonChannel) {
  for (const int mask : {1, 2, 3, 4, 6}) {
    const auto level =
        lit_map(key_room(lamp(fmt::format("'_light_channel_mask' '{}'", mask)) +
                         two_blocks("'_object_channel_mask' '2'", "'_object_channel_mask' '5'")));
    const auto expect_light = [&](const Vec3d& place, int channels) {
      EXPECT_NEAR(light_at(*level, place), (mask & channels) != 0 ? find_lamp_light(place) : 0, 1)
          << mask << " and " << channels;
    };
    expect_light(kLeftTop, 2);
    expect_light(kRightTop, 5);
    expect_light(kFloor, 1);
  }
}

TEST(LightChannels, OnlyBrushesOfTheShadowChannelsStopLight) {
  // The lamp is in the ceiling: the world around it is on channel 1.
  const std::string blocks = two_blocks("'_object_channel_mask' '2'", "");
  const auto light_with = [&](const char* keys) {
    return light_at(*lit_map(key_room(lamp(keys, "0 0 264") + blocks)), kLeftTop);
  };
  EXPECT_NEAR(light_with("'_light_channel_mask' '2'"), find_lamp_light(kLeftTop, 264), 1);
  EXPECT_EQ(light_with("'_light_channel_mask' '2' '_shadow_channel_mask' '1'"), 0);
  EXPECT_EQ(light_with("'_light_channel_mask' '2' '_shadow_channel_mask' '3'"), 0);
}

TEST(LightChannels, BrushesOfOtherChannelsCastShadowsUnasked) {
  const auto floor_light = [](std::string_view lamp_keys, std::string_view brush_keys) {
    return light_at(
        *lit_map(key_room(lamp(lamp_keys) + box_entity(brush_keys, {-32, -32, 100}, {32, 32, 108}))), kFloor);
  };
  const double open = find_lamp_light(kFloor);
  EXPECT_NEAR(floor_light("", ""), open, 1);
  EXPECT_EQ(floor_light("", "'_object_channel_mask' '3'"), 0);
  EXPECT_NEAR(floor_light("", "'_object_channel_mask' '3' '_shadow' '-1'"), open, 1);
  EXPECT_NEAR(floor_light("", "'_object_channel_mask' '2'"), open, 1);
  EXPECT_EQ(floor_light("'_shadow_channel_mask' '2'", "'_object_channel_mask' '2'"), 0);
}

// Sun, bounces, and surface lights are on channel 1.
TEST(LightChannels, OtherChannelsNeitherGetNorSendBouncedLight) {
  const auto bounced = [](std::string_view keys) {
    const std::string text =
        key_room(lamp("'mangle' '0 -90 0' 'angle' '40'") + box_entity(keys, {64, -16, 100}, {96, 16, 132}),
                 "'_bounce' '2'");
    const auto level = lit_map(text);
    return shown_light(*level, face_under(*level, {80, 0, 100}, -kFaceUp), {80, 0, 100}).x;
  };
  EXPECT_GT(bounced(""), 2);
  EXPECT_EQ(bounced("'_object_channel_mask' '2'"), 0);
}

}  // namespace
}  // namespace temblor::test
