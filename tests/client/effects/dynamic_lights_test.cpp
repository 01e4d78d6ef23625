#include "client/effects/dynamic_lights.h"

#include <gtest/gtest.h>

#include <set>

namespace temblor::client {
namespace {

TimedLight explosion(double born_s) {
  return {
      .origin_world = {1, 2, 3}, .radius = 350, .shrinks_per_second = 300, .born_s = born_s, .life_s = 0.5};
}

TEST(DynamicLights, ShrinkByTime) {
  DynamicLights lights;
  lights.add(explosion(10));
  for (const auto& [time_s, radius] : {std::pair{10.0, 350.0f}, {10.1, 320.0f}, {10.5, 200.0f}}) {
    lights.advance(time_s);
    ASSERT_EQ(lights.lights().size(), 1u);
    EXPECT_FLOAT_EQ(lights.lights()[0].radius, radius);
    EXPECT_EQ(lights.lights()[0].origin_world, math::Vec3(1, 2, 3));
  }
  lights.advance(10.51);
  EXPECT_TRUE(lights.lights().empty());
}

TEST(DynamicLights, EndWhenTheirRadiusIsZero) {
  DynamicLights lights;
  lights.add({.radius = 30, .shrinks_per_second = 100, .born_s = 0, .life_s = 5});
  lights.advance(0.29);
  EXPECT_EQ(lights.lights().size(), 1u);
  lights.advance(0.31);
  EXPECT_TRUE(lights.lights().empty());
}

TEST(DynamicLights, AnEntityHasOne) {
  DynamicLights lights;
  lights.add({.entity = 5, .radius = 100, .life_s = 1});
  lights.add({.entity = 6, .radius = 110, .life_s = 1});
  lights.add({.entity = 5, .radius = 120, .life_s = 1});
  lights.add(explosion(0));
  lights.add(explosion(0));
  ASSERT_EQ(lights.lights().size(), 4u);
  EXPECT_EQ(lights.lights()[0].radius, 120);
  EXPECT_EQ(lights.lights()[1].radius, 110);
}

TEST(DynamicLights, TheOneThatEndsFirstIsReplaced) {
  DynamicLights lights;
  for (std::size_t i = 0; i < DynamicLights::kMaxLights; ++i)
    lights.add({.radius = static_cast<float>(i + 1), .life_s = i == 40 ? 0.5 : 1.0});
  lights.add({.radius = 1000, .life_s = 2});
  ASSERT_EQ(lights.lights().size(), DynamicLights::kMaxLights);
  EXPECT_EQ(lights.lights()[40].radius, 1000);
  EXPECT_EQ(lights.lights()[41].radius, 42);
}

TEST(DynamicLights, FlickerTenTimesASecond) {
  std::set<float> values;
  for (int tenth = 0; tenth < 300; ++tenth) {
    const float first = light_flicker(3, tenth * 0.1 + 0.001);
    EXPECT_EQ(light_flicker(3, tenth * 0.1 + 0.05), first);
    EXPECT_EQ(light_flicker(3, tenth * 0.1 + 0.099), first);
    values.insert(first);
  }
  EXPECT_EQ(*values.begin(), 0);
  EXPECT_EQ(*values.rbegin(), 31);
  EXPECT_EQ(values.size(), 32u);
  int same = 0;
  for (int tenth = 0; tenth < 320; ++tenth)
    same += light_flicker(3, tenth * 0.1 + 0.05) == light_flicker(4, tenth * 0.1 + 0.05);
  EXPECT_LT(same, 30);  // 10 would be random
}

}  // namespace
}  // namespace temblor::client
