// Compares bursts with the original's numbers: count, place, speed, colors, lifetime.
#include "client/effects/particle_bursts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace temblor::client {
namespace {

const math::Vec3 kOrigin(100, -200, 300);

struct Burst {
  explicit Burst(const std::function<void(const BurstContext&)>& make, std::uint32_t seed = 1)
      : random(seed) {
    pool.set_capacity(4096);
    make({pool, random, 0});
    pool.advance(0);
  }
  std::size_t alive_at(double time_s) {
    pool.advance(time_s);
    return pool.size();
  }
  std::vector<math::Vec3> places() const {
    std::vector<math::Vec3> places;
    const render::ParticleCloud cloud = pool.cloud();
    for (std::size_t i = 0; i < cloud.size(); ++i)
      places.push_back(math::Vec3(cloud.x[i], cloud.y[i], cloud.z[i]) - kOrigin);
    return places;
  }
  std::set<int> colors() const {
    const auto color = pool.cloud().color;
    return {color.begin(), color.end()};
  }
  ParticlePool pool;
  EffectRandom random;
};

std::set<int> from_to(int first, int last) {
  std::set<int> all;
  for (int i = first; i <= last; ++i) all.insert(i);
  return all;
}

// All are within the box, and reach each of its sides to within `margin`.
void expect_fills(const std::vector<math::Vec3>& places, const math::Bounds& box, float margin) {
  math::Vec3 mins = places.at(0), maxs = mins;
  for (const math::Vec3& place : places) {
    mins = glm::min(mins, place);
    maxs = glm::max(maxs, place);
  }
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_GE(mins[axis], box.mins[axis] - 0.001f);
    EXPECT_LE(mins[axis], box.mins[axis] + margin);
    EXPECT_LE(maxs[axis], box.maxs[axis] + 0.001f);
    EXPECT_GE(maxs[axis], box.maxs[axis] - margin);
  }
}

// Velocities from the places at two close times.
std::vector<math::Vec3> velocities(Burst burst) {
  constexpr float kMoment_s = 1.0f / 1024;
  const std::vector<math::Vec3> before = burst.places();
  burst.pool.advance(double{kMoment_s});
  std::vector<math::Vec3> result = burst.places();
  EXPECT_EQ(before.size(), result.size());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = (result[i] - before[i]) / kMoment_s;
  return result;
}

TEST(ParticleBursts, Explosion) {
  Burst burst([](const BurstContext& context) { spawn_explosion(context, kOrigin); });
  EXPECT_EQ(burst.pool.size(), 1024u);
  expect_fills(burst.places(), {math::Vec3(-16), math::Vec3(16)}, 0.5f);
  expect_fills(velocities(burst), {math::Vec3(-258), math::Vec3(258)}, 8);
  // Both kinds start at steps 0 to 3 of their ramp.
  EXPECT_THAT(burst.colors(), testing::ElementsAre(0x69, 0x6b, 0x6c, 0x6d, 0x6e, 0x6f));
  // A random start at step 0 to 3 of eight; half run at 15 steps a second, half at 10. Five standard
  // deviations of a quarter of 512 are 49.
  EXPECT_EQ(burst.alive_at(0.333), 1024u);
  EXPECT_NEAR(static_cast<double>(burst.alive_at(0.34)), 512 + 384, 49);
  EXPECT_NEAR(static_cast<double>(burst.alive_at(0.49)), 512 + 128, 49);
  EXPECT_NEAR(static_cast<double>(burst.alive_at(0.55)), 384, 49);
  EXPECT_EQ(burst.alive_at(0.801), 0u);
}

TEST(ParticleBursts, BlobExplosion) {
  Burst burst([](const BurstContext& context) { spawn_blob_explosion(context, kOrigin); });
  EXPECT_EQ(burst.pool.size(), 1024u);
  std::set<int> colors = from_to(66, 71);
  colors.merge(from_to(150, 155));
  EXPECT_EQ(burst.colors(), colors);
  expect_fills(burst.places(), {math::Vec3(-16), math::Vec3(16)}, 0.5f);
  expect_fills(velocities(burst), {math::Vec3(-258), math::Vec3(258)}, 8);
  const auto color = burst.pool.cloud().color;
  EXPECT_EQ(std::count_if(color.begin(), color.end(), [](int c) { return c < 100; }), 512);
  EXPECT_EQ(burst.alive_at(1.0), 1024u);
  // A random half: 512 +- 5 standard deviations of 16.
  EXPECT_NEAR(static_cast<double>(burst.alive_at(1.2)), 512, 80);
  EXPECT_EQ(burst.alive_at(1.401), 0u);
}

TEST(ParticleBursts, ColoredExplosion) {
  Burst burst([](const BurstContext& context) { spawn_colored_explosion(context, kOrigin, 250, 8); });
  EXPECT_EQ(burst.pool.size(), 512u);
  EXPECT_THAT(burst.colors(), testing::ElementsAre(0, 1, 250, 251, 252, 253, 254, 255));
  EXPECT_EQ(burst.alive_at(0.3), 512u);
  EXPECT_EQ(burst.alive_at(0.301), 0u);
  Burst of_none([](const BurstContext& context) { spawn_colored_explosion(context, kOrigin, 7, 0); });
  EXPECT_THAT(of_none.colors(), testing::ElementsAre(7));
}

TEST(ParticleBursts, Chips) {
  Burst burst([](const BurstContext& context) { spawn_chips(context, kOrigin, {1, 0, -2}, 77, 500); });
  EXPECT_EQ(burst.pool.size(), 500u);
  EXPECT_EQ(burst.colors(), from_to(72, 79));
  expect_fills(burst.places(), {math::Vec3(-8), math::Vec3(8)}, 0.5f);
  // A fifth of them lives 0, a fifth 0.1, ... 0.4 s: 5 standard deviations are 45.
  double expected = 500;
  for (int tenths = 0; tenths < 4; ++tenths) {
    expected -= 100;
    EXPECT_NEAR(static_cast<double>(burst.alive_at(0.1 * tenths + 0.05)), expected, 55) << tenths;
  }
  EXPECT_EQ(burst.alive_at(0.41), 0u);
}

TEST(ParticleBursts, ChipsFlyFifteenTimesTheDirection) {
  Burst burst([](const BurstContext& context) { spawn_chips(context, kOrigin, {1, 0, -2}, 0, 200); });
  burst.pool.advance(1.0 / 64);
  const std::vector<math::Vec3> before = burst.places();
  burst.pool.advance(2.0 / 64);
  const std::vector<math::Vec3> after = burst.places();
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    const math::Vec3 velocity = (after[i] - before[i]) * 64.0f;
    EXPECT_NEAR(velocity.x, 15, 0.01);
    EXPECT_NEAR(velocity.y, 0, 0.01);
    EXPECT_NEAR(velocity.z, -30 - 40 * 1.5 / 64, 0.01);
  }
}

TEST(ParticleBursts, Teleport) {
  Burst burst([](const BurstContext& context) { spawn_teleport_splash(context, kOrigin); });
  EXPECT_EQ(burst.pool.size(), 8u * 8 * 14);
  EXPECT_EQ(burst.colors(), from_to(7, 14));
  expect_fills(burst.places(), {{-16, -16, -24}, {16, 16, 32}}, 1);
  for (const math::Vec3& velocity : velocities(burst)) {
    const float speed = glm::length(velocity);
    if (speed < 0.1f) continue;  // the center has no direction
    EXPECT_GT(speed, 49);
    EXPECT_LT(speed, 115);
  }
  EXPECT_EQ(burst.alive_at(0.2), 896u);
  EXPECT_EQ(burst.alive_at(0.341), 0u);
}

TEST(ParticleBursts, LavaSplash) {
  Burst burst([](const BurstContext& context) { spawn_lava_splash(context, kOrigin); });
  EXPECT_EQ(burst.pool.size(), 1024u);
  EXPECT_EQ(burst.colors(), from_to(224, 231));
  expect_fills(burst.places(), {{-128, -128, 0}, {128, 128, 64}}, 4);
  for (const math::Vec3& velocity : velocities(burst)) EXPECT_GT(velocity.z, 30);
  EXPECT_EQ(burst.alive_at(2.0), 1024u);
  EXPECT_EQ(burst.alive_at(2.621), 0u);
}

TEST(ParticleBursts, BrightFieldIsAroundABallForOneFrame) {
  Burst burst([](const BurstContext& context) { show_bright_field(context.pool, context.time_s, kOrigin); });
  EXPECT_EQ(burst.pool.size(), 162u);
  EXPECT_THAT(burst.colors(), testing::ElementsAre(0x6f));
  math::Vec3 sum(0.0f);
  for (const math::Vec3& place : burst.places()) {
    EXPECT_GE(glm::length(place), 47.99f);
    EXPECT_LE(glm::length(place), 80.01f);
    sum += place - math::Vec3(16, 0, 0);  // where all of them are shifted at time 0
  }
  EXPECT_LT(glm::length(sum) / 162, 0.5f);
  EXPECT_EQ(burst.alive_at(0.001), 0u);
}

TEST(ParticleBursts, TheSameSeedMakesTheSameBurst) {
  const auto make = [](const BurstContext& context) { spawn_explosion(context, kOrigin); };
  EXPECT_EQ(Burst(make, 7).places(), Burst(make, 7).places());
  EXPECT_NE(Burst(make, 7).places(), Burst(make, 8).places());
}

TEST(ParticleBursts, PointTrailHasAParticleEvery16Units) {
  const std::vector<math::Vec3> corners = {kOrigin, kOrigin + math::Vec3(40, 0, 0),
                                           kOrigin + math::Vec3(40, 0, 0), kOrigin + math::Vec3(40, 30, 0)};
  Burst burst([&](const BurstContext& context) { spawn_point_trail(context.pool, corners, context.time_s); });
  const auto at = [](float x, float y) { return math::Vec3(x, y, 0); };
  EXPECT_THAT(burst.places(),
              testing::ElementsAre(at(0, 0), at(16, 0), at(32, 0), at(40, 8), at(40, 24), at(40, 30)));
  EXPECT_EQ(burst.alive_at(86400), 6u) << "a day later";
  Burst empty([](const BurstContext& context) { spawn_point_trail(context.pool, {}, context.time_s); });
  EXPECT_EQ(empty.pool.size(), 0u);
}

TEST(ParticleBursts, PointTrailEndsWhereThePoolIsFull) {
  const std::vector<math::Vec3> corners = {math::Vec3(0), math::Vec3(3e38f, 0, 0)};
  Burst burst([&](const BurstContext& context) { spawn_point_trail(context.pool, corners, context.time_s); });
  EXPECT_EQ(burst.pool.size(), 4096u);
  EXPECT_EQ(burst.pool.cloud().x.back(), 4095 * 16);
}

}  // namespace
}  // namespace temblor::client
