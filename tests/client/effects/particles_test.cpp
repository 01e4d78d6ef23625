// Compares particles with their laws of motion, integrated in small steps.
#include "client/effects/particles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/random.h"

namespace temblor::client {
namespace {

using math::Vec3d;

constexpr double kGravity = 40;

// Changes of velocity per second, from a table of the original's behavior.
Vec3d change(ParticleMotion motion, const Vec3d& v) {
  switch (motion) {
    case ParticleMotion::kStill:
      return Vec3d(0.0);
    case ParticleMotion::kFalling:
      return {0, 0, -kGravity};
    case ParticleMotion::kFire:
      return {0, 0, kGravity};
    case ParticleMotion::kExplode:
    case ParticleMotion::kBlob:
      return v * 4.0 + Vec3d(0, 0, -kGravity);
    case ParticleMotion::kExplode2:
      return -v + Vec3d(0, 0, -kGravity);
    case ParticleMotion::kBlob2:
      return {-4 * v.x, -4 * v.y, -kGravity};
    case ParticleMotion::kSpark:
      return v * -3.0 + Vec3d(0, 0, -20 * kGravity);
    case ParticleMotion::kDrop:
      return {0, 0, -20 * kGravity};
  }
  return Vec3d(0.0);
}

Vec3d walked(ParticleMotion motion, Vec3d place, Vec3d velocity, double age_s) {
  const int steps = 20000;
  const double step_s = age_s / steps;
  for (int i = 0; i < steps; ++i) {
    const Vec3d middle = velocity + change(motion, velocity) * (step_s / 2);
    place += middle * step_s;
    velocity += change(motion, middle) * step_s;
  }
  return place;
}

math::Vec3 at(const render::ParticleCloud& cloud, std::size_t i) {
  return {cloud.x[i], cloud.y[i], cloud.z[i]};
}

ParticlePool make_pool(std::size_t capacity) {
  ParticlePool pool;
  pool.set_capacity(capacity);
  return pool;
}

TEST(Particles, FollowTheirLaws) {
  test::Random random(1);
  for (std::size_t m = 0; m < kParticleMotions; ++m) {
    const auto motion = static_cast<ParticleMotion>(m);
    for (int i = 0; i < 8; ++i) {
      const math::Vec3 origin = random.in_cube(2000), velocity = random.in_cube(256);
      const double born_s = random.uniform(0, 100), age_s = random.uniform(0.01, 0.5);
      ParticlePool pool = make_pool(1);
      ASSERT_TRUE(pool.add({origin, velocity, born_s, 1, motion}));
      pool.advance(born_s + age_s);
      ASSERT_EQ(pool.cloud().size(), 1u);
      const Vec3d expected = walked(motion, Vec3d(origin), Vec3d(velocity), age_s);
      EXPECT_LT(glm::distance(Vec3d(at(pool.cloud(), 0)), expected), 0.002) << "motion " << m;
    }
  }
}

TEST(Particles, LiveForTheirLifetime) {
  ParticlePool pool = make_pool(10);
  pool.add({.born_s = 5, .life_s = 0.5f});
  pool.add({.born_s = 5, .life_s = 0});
  pool.advance(5);
  EXPECT_EQ(pool.size(), 2u);
  pool.advance(5.001);
  EXPECT_EQ(pool.size(), 1u);
  pool.advance(5.5);
  EXPECT_EQ(pool.size(), 1u);
  pool.advance(5.5001);
  EXPECT_EQ(pool.size(), 0u);
}

TEST(Particles, RunThroughTheirRampAndDieAtItsEnd) {
  struct Case {
    ParticleMotion motion;
    double steps_per_second;
    std::vector<int> ramp;
  };
  const std::vector<Case> cases = {
      {ParticleMotion::kFire, 5, {0x6d, 0x6b, 0x06, 0x05, 0x04, 0x03}},
      {ParticleMotion::kExplode, 10, {0x6f, 0x6d, 0x6b, 0x69, 0x67, 0x65, 0x63, 0x61}},
      {ParticleMotion::kExplode2, 15, {0x6f, 0x6e, 0x6d, 0x6c, 0x6b, 0x6a, 0x68, 0x66}}};
  for (const Case& c : cases)
    for (int start = 0; start < 4; ++start) {
      ParticlePool pool = make_pool(1);
      pool.add({.life_s = 5, .motion = c.motion, .ramp = static_cast<float>(start)});
      for (std::size_t step = static_cast<std::size_t>(start); step < c.ramp.size(); ++step) {
        pool.advance((static_cast<double>(step) - start + 0.5) / c.steps_per_second);
        ASSERT_EQ(pool.cloud().size(), 1u);
        EXPECT_EQ(int{pool.cloud().color[0]}, c.ramp[step]);
      }
      pool.advance((static_cast<double>(c.ramp.size()) - start + 0.01) / c.steps_per_second);
      EXPECT_EQ(pool.cloud().size(), 0u);
    }
}

TEST(Particles, DoNotDependOnHowOftenTheyAdvance) {
  std::vector<std::vector<math::Vec3>> ends;
  for (const int frames_per_second : {10, 72, 1000}) {
    ParticlePool pool = make_pool(1000);
    test::Random random(3);
    for (int i = 0; i < 700; ++i)
      pool.add({random.in_cube(100), random.in_cube(256), 0, static_cast<float>(random.uniform(0.5, 1.5)),
                static_cast<ParticleMotion>(i % 7)});
    for (int frame = 1; frame <= frames_per_second; ++frame)
      pool.advance(static_cast<double>(frame) / frames_per_second);
    std::vector<math::Vec3>& places = ends.emplace_back();
    for (std::size_t i = 0; i < pool.cloud().size(); ++i) places.push_back(at(pool.cloud(), i));
  }
  EXPECT_GT(ends[0].size(), 100u);
  EXPECT_EQ(ends[0], ends[1]);
  EXPECT_EQ(ends[0], ends[2]);
}

TEST(Particles, ThoseWithoutRoomAreDroppedAndCounted) {
  ParticlePool pool = make_pool(5);
  for (int i = 0; i < 8; ++i)
    EXPECT_EQ(pool.add({.life_s = 1, .color = static_cast<std::uint8_t>(i)}), i < 5);
  pool.advance(0);
  EXPECT_EQ(pool.cloud().size(), 5u);
  EXPECT_EQ(pool.dropped(), 3u);
  for (std::uint8_t i = 0; i < 5; ++i) EXPECT_EQ(pool.cloud().color[i], i);
  pool.set_capacity(2);
  EXPECT_EQ(pool.cloud().size(), 5u);
  EXPECT_EQ(pool.room(), 0u);
  pool.advance(2);
  EXPECT_EQ(pool.room(), 2u);
}

TEST(Particles, NewOnesJoinTheCloudWhenPlaced) {
  ParticlePool pool = make_pool(5);
  pool.add({.life_s = 1});
  pool.advance(0);
  pool.add({.velocity = {8, 0, 0}, .born_s = -0.5, .life_s = 1});
  pool.add({.born_s = -0.5, .life_s = 0.25f});  // dead before it is ever visible
  EXPECT_EQ(pool.cloud().size(), 1u);
  pool.place_new(0);
  ASSERT_EQ(pool.cloud().size(), 2u);
  EXPECT_EQ(pool.cloud().x[1], 4);
}

}  // namespace
}  // namespace temblor::client
