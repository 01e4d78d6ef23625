#include "client/view/view_tint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "client/session/powerups.h"
#include "support/random.h"

namespace temblor::client {
namespace {

using render::Tint;
using world::Contents;

math::Vec3 laid(const math::Vec3& picture, const Tint& tint) {
  return picture * (1 - tint.opacity) + tint.color * tint.opacity;
}

TEST(ViewTint, OneTintEqualsAllTintsInOrder) {
  test::Random random(1);
  for (int i = 0; i < 1000; ++i) {
    std::vector<Tint> tints;
    for (std::size_t n = random.below(5); n > 0; --n) {
      // Sometimes fully clear or fully opaque.
      const auto opacity = static_cast<float>(std::clamp(random.uniform(-0.2, 1.2), 0.0, 1.0));
      tints.push_back({random.in_cube(127) + 127.0f, opacity});
    }
    const math::Vec3 picture = random.in_cube(127) + 127.0f;
    math::Vec3 expected = picture;
    Tint all;
    for (const Tint& tint : tints) {
      expected = laid(expected, tint);
      all = blend_tints(all, tint);
    }
    EXPECT_LT(glm::distance(laid(picture, all), expected), 0.01f);
    EXPECT_GE(all.opacity, 0);
    EXPECT_LE(all.opacity, 1);
  }
}

void expect_tint(const Tint& tint, const math::Vec3& color, float of_256) {
  EXPECT_EQ(tint.color, color);
  EXPECT_FLOAT_EQ(tint.opacity, of_256 / 256);
}

// Water keeps the most blue of a white picture, and slime the most green.
TEST(ViewTint, NaturalLiquids) {
  const math::Vec3 water = laid(math::Vec3(255.0f), contents_tint(Contents::kWater, true));
  EXPECT_GT(water.z, water.y);
  EXPECT_GT(water.y, water.x);
  const math::Vec3 slime = laid(math::Vec3(255.0f), contents_tint(Contents::kSlime, true));
  EXPECT_GT(slime.y, slime.x);
  EXPECT_GT(slime.x, slime.z);
  EXPECT_EQ(contents_tint(Contents::kLava, true).color, contents_tint(Contents::kLava).color);
  EXPECT_EQ(contents_tint(Contents::kEmpty, true).opacity, 0);
}

TEST(ViewTint, Contents) {
  for (const Contents clear : {Contents::kEmpty, Contents::kSolid, Contents::kSky})
    EXPECT_EQ(contents_tint(clear).opacity, 0);
  expect_tint(contents_tint(Contents::kWater), {130, 80, 50}, 128);
  expect_tint(contents_tint(Contents::kCurrentUp), {130, 80, 50}, 128);
  expect_tint(contents_tint(Contents::kSlime), {0, 25, 5}, 150);
  expect_tint(contents_tint(Contents::kLava), {255, 80, 0}, 150);
}

TEST(ViewTint, Powerups) {
  EXPECT_EQ(powerup_tint(0).opacity, 0);
  EXPECT_EQ(powerup_tint(0xff80ffffu).opacity, 0);  // every item except the four power-ups
  const std::uint32_t ring = kItemInvisibility | kItemInvulnerability;
  expect_tint(powerup_tint(kItemInvulnerability), {255, 255, 0}, 30);
  expect_tint(powerup_tint(ring), {100, 100, 100}, 100);
  expect_tint(powerup_tint(ring | kItemSuit), {0, 255, 0}, 20);
  expect_tint(powerup_tint(ring | kItemSuit | kItemQuad), {0, 0, 255}, 30);
}

std::vector<net::Damage> damage(std::uint8_t armor, std::uint8_t blood) {
  return {{armor, blood, {0, 0, 0}}};
}

TEST(ViewTint, Damage) {
  FadingTints tints;
  tints.advance(0, damage(0, 40), 0);
  expect_tint(tints.damage(), {255, 0, 0}, 60);  // 3 x 20
  tints.advance(0.2, {}, 0);
  expect_tint(tints.damage(), {255, 0, 0}, 30);  // 150 per second
  tints.advance(0, damage(1, 2), 0);
  expect_tint(tints.damage(), {220, 50, 50}, 60);  // counts as 10
  tints.advance(0, damage(20, 10), 0);
  expect_tint(tints.damage(), {200, 100, 100}, 105);
  tints.advance(0, damage(0, 200), 0);
  expect_tint(tints.damage(), {255, 0, 0}, 150);  // the maximum
  tints.advance(1.01, {}, 0);
  EXPECT_EQ(tints.damage().opacity, 0);
}

TEST(ViewTint, Bonus) {
  FadingTints tints;
  tints.advance(0, {}, 3);
  expect_tint(tints.bonus(), {215, 186, 69}, 50);
  tints.advance(0.25, {}, 0);
  expect_tint(tints.bonus(), {215, 186, 69}, 25);
  tints.advance(0.25, {}, 1);
  expect_tint(tints.bonus(), {215, 186, 69}, 50);
  tints.advance(0.51, {}, 0);
  EXPECT_EQ(tints.bonus().opacity, 0);
}

TEST(ViewTint, FadesAlikeAtAnyFrameRate) {
  for (const int frames_per_second : {10, 70, 1000}) {
    FadingTints tints;
    tints.advance(0, damage(0, 100), 1);
    for (int frame = 0; frame < frames_per_second * 4 / 10; ++frame)
      tints.advance(1.0 / frames_per_second, {}, 0);
    EXPECT_NEAR(tints.damage().opacity, 90.0 / 256, 1e-4) << frames_per_second;
    EXPECT_NEAR(tints.bonus().opacity, 10.0 / 256, 1e-4) << frames_per_second;
  }
}

}  // namespace
}  // namespace temblor::client
