#include "client/fog_fade.h"

#include <gtest/gtest.h>

namespace temblor::client {
namespace {

TEST(FogFade, TheLevelsFogStandsUntilTheServerSaysOtherwise) {
  FogFade fade(render::Fog{0.5f, {0.1f, 0.2f, 0.3f}});
  EXPECT_EQ(fade.at(-5).density, 0.5f);
  EXPECT_EQ(fade.at(1000).density, 0.5f);
  EXPECT_EQ(fade.at(1000).colour, math::Vec3(0.1f, 0.2f, 0.3f));
}

TEST(FogFade, ChangesEvenlyOverItsTime) {
  FogFade fade(render::Fog{0.0f, {0, 0, 0}});
  fade.follow({1.0f, {1, 0.5f, 0}, 4.0f}, 10);
  EXPECT_FLOAT_EQ(fade.at(10).density, 0);
  EXPECT_FLOAT_EQ(fade.at(11).density, 0.25f);
  EXPECT_FLOAT_EQ(fade.at(12).colour.y, 0.25f);
  EXPECT_FLOAT_EQ(fade.at(14).density, 1);
  EXPECT_FLOAT_EQ(fade.at(99).density, 1);
}

TEST(FogFade, ANewFadeBeginsWhereTheLastOneWas) {
  FogFade fade(render::Fog{0.0f, {0, 0, 0}});
  fade.follow({1.0f, {1, 1, 1}, 4.0f}, 10);
  fade.follow({0.0f, {1, 1, 1}, 2.0f}, 12);
  EXPECT_FLOAT_EQ(fade.at(12).density, 0.5f);
  EXPECT_FLOAT_EQ(fade.at(13).density, 0.25f);
}

TEST(FogFade, WithoutAFadeItIsThereAtOnceAndHearingItAgainChangesNothing) {
  FogFade fade;
  fade.follow({0.3f, {1, 1, 1}, 0.0f}, 10);
  EXPECT_FLOAT_EQ(fade.at(10).density, 0.3f);
  fade.follow({0.3f, {1, 1, 1}, 0.0f}, 10);
  EXPECT_FLOAT_EQ(fade.at(10).density, 0.3f);
}

}  // namespace
}  // namespace temblor::client
