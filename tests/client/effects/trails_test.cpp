#include "client/effects/trails.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "formats/models/mdl.h"
#include "support/random.h"

namespace temblor::client {
namespace {

constexpr std::uint32_t kRocket = 12;

struct Left {
  Left() { pool.set_capacity(100000); }
  void leave(TrailKind kind, const math::Vec3& from, const math::Vec3& to, double from_s, double to_s) {
    trails.emit({kRocket, kind, from, to, from_s, to_s}, pool);
  }
  Trails trails{1};
  ParticlePool pool;
};

TEST(Trails, KindsByModelFlags) {
  using enum formats::MdlFlags;
  EXPECT_EQ(find_trail_kind(0), std::nullopt);
  EXPECT_EQ(find_trail_kind(kMdlRotate), std::nullopt);
  EXPECT_EQ(find_trail_kind(kMdlRocketTrail), TrailKind::kRocket);
  EXPECT_EQ(find_trail_kind(kMdlGrenadeSmoke), TrailKind::kGrenade);
  EXPECT_EQ(find_trail_kind(kMdlGibBlood), TrailKind::kBlood);
  EXPECT_EQ(find_trail_kind(kMdlZombieBlood), TrailKind::kThinBlood);
  EXPECT_EQ(find_trail_kind(kMdlTracer), TrailKind::kTracer);
  EXPECT_EQ(find_trail_kind(kMdlTracer2), TrailKind::kTracer2);
  EXPECT_EQ(find_trail_kind(kMdlTracer3 | kMdlRotate), TrailKind::kVoor);
}

// One particle per 3 units of path, however the path is divided.
TEST(Trails, CoverThePathHoweverItIsDivided) {
  const math::Vec3 start(10, 20, 30), direction(0.6f, 0, 0.8f);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    test::Random random(seed);
    Left left;
    const double longest = random.log_uniform(0.1, 200);
    double passed = 0;
    while (passed < 3000) {
      const double next = std::min(3000.0, passed + random.uniform(0.01, longest));
      // The vore's scatter hides where along the path particles are; tracers have no scatter.
      left.leave(TrailKind::kTracer, start + direction * static_cast<float>(passed),
                 start + direction * static_cast<float>(next), 0, 0);
      passed = next;
    }
    left.pool.advance(0);
    const render::ParticleCloud cloud = left.pool.cloud();
    ASSERT_NEAR(static_cast<double>(cloud.size()), 1000, 1) << seed;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const math::Vec3 place(cloud.x[i], cloud.y[i], cloud.z[i]);
      const math::Vec3 expected = start + direction * (3 * static_cast<float>(i));
      ASSERT_LT(glm::distance(place, expected), 0.1f) << seed << ": " << i;
    }
  }
}

// An entity's trail does not depend on other entities.
TEST(Trails, HaveTheirOwnRandomNumbers) {
  Left alone, beside_another;
  for (int i = 0; i < 10; ++i) {
    const math::Vec3 from(10 * i, 0, 0), to(10 * i + 10, 0, 0);
    alone.leave(TrailKind::kRocket, from, to, 0, 0);
    beside_another.trails.emit({kRocket - 1, TrailKind::kRocket, {0, 50, 0}, {7, 50, 0}, 0, 0},
                               beside_another.pool);
    beside_another.leave(TrailKind::kRocket, from, to, 0, 0);
  }
  const auto places = [](Left& io_left) {
    io_left.pool.advance(0);
    const render::ParticleCloud cloud = io_left.pool.cloud();
    std::vector<std::array<float, 3>> near_the_x_axis;
    for (std::size_t i = 0; i < cloud.size(); ++i)
      if (cloud.y[i] < 25) near_the_x_axis.push_back({cloud.x[i], cloud.y[i], cloud.z[i]});
    return near_the_x_axis;
  };
  EXPECT_GT(places(alone).size(), 30u);
  EXPECT_EQ(places(alone), places(beside_another));
}

TEST(Trails, ZombiesBleedHalfAsMuch) {
  Left blood, thin;
  blood.leave(TrailKind::kBlood, {0, 0, 0}, {600, 0, 0}, 0, 0);
  thin.leave(TrailKind::kThinBlood, {0, 0, 0}, {600, 0, 0}, 0, 0);
  EXPECT_EQ(blood.pool.size(), 200u);
  EXPECT_EQ(thin.pool.size(), 100u);
}

TEST(Trails, ParticlesAgeFromWhenTheirPlaceWasPassed) {
  // 2000 units in 1 s: a spark rises by 20 t^2.
  Left left;
  left.leave(TrailKind::kRocket, {0, 0, 0}, {2000, 0, 0}, 10, 11);
  left.pool.advance(11);
  const render::ParticleCloud cloud = left.pool.cloud();
  ASSERT_GT(cloud.size(), 300u);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const double age_s = 1 - double{cloud.x[i]} / 2000;
    EXPECT_NEAR(double{cloud.z[i]}, 20 * age_s * age_s, 3.2);
  }
  // Fire lives 0.6 to 1.2 s, so all of it is on the last 1200 units.
  const auto near = std::count_if(cloud.x.begin(), cloud.x.end(), [](float x) { return x > 804; });
  EXPECT_NEAR(static_cast<double>(near), 1196.0 / 3, 3);
}

TEST(Trails, TracersSpreadToBothSides) {
  Left left;
  left.leave(TrailKind::kTracer2, {0, 0, 0}, {0, 120, 0}, 0, 0);
  left.pool.advance(0.25);
  const render::ParticleCloud cloud = left.pool.cloud();
  ASSERT_EQ(cloud.size(), 40u);
  std::set<int> colors;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    EXPECT_NEAR(cloud.x[i], i % 2 == 0 ? -7.5f : 7.5f, 0.001f);
    EXPECT_NEAR(cloud.y[i], 3 * static_cast<float>(i), 0.001f);
    EXPECT_EQ(int{cloud.color[i]}, (i / 4) % 2 == 0 ? 230 : 238);
  }
  left.pool.advance(0.501);
  EXPECT_EQ(left.pool.size(), 0u);
}

TEST(Trails, HaveTheirColors) {
  const auto colors = [](TrailKind kind) {
    Left left;
    left.leave(kind, {0, 0, 0}, {900, 0, 0}, 0, 0);
    left.pool.advance(0);
    const auto color = left.pool.cloud().color;
    return std::set<int>(color.begin(), color.end());
  };
  EXPECT_THAT(colors(TrailKind::kRocket), testing::ElementsAre(0x05, 0x06, 0x6b, 0x6d));
  EXPECT_THAT(colors(TrailKind::kGrenade), testing::ElementsAre(0x03, 0x04, 0x05, 0x06));
  EXPECT_THAT(colors(TrailKind::kBlood), testing::ElementsAre(67, 68, 69, 70));
  EXPECT_THAT(colors(TrailKind::kThinBlood), testing::ElementsAre(67, 68, 69, 70));
  EXPECT_THAT(colors(TrailKind::kTracer), testing::ElementsAre(52, 60));
  EXPECT_THAT(colors(TrailKind::kVoor), testing::ElementsAre(152, 153, 154, 155));
}

TEST(Trails, StandingStillLeavesNoTrail) {
  Left left;
  for (int i = 0; i < 100; ++i) left.leave(TrailKind::kRocket, {5, 5, 5}, {5, 5, 5}, i, i + 1);
  EXPECT_EQ(left.pool.size(), 0u);
  EXPECT_EQ(left.pool.dropped(), 0u);
}

TEST(Trails, LongPathsAreLimitedByRoom) {
  Left left;
  left.pool.set_capacity(50);
  // The largest coordinates of messages.
  left.leave(TrailKind::kRocket, {0, 0, 0}, {0x1p27f, 0, 0}, 0, 1);
  EXPECT_EQ(left.pool.size(), 50u);
  EXPECT_EQ(left.pool.dropped(), (std::size_t{1} << 27) / 3 + 1 - 50);
}

// An earlier entity in the same slot has no influence.
TEST(Trails, StartFreshInAReusedSlot) {
  const auto find_last = [](bool something_before) {
    Left left;
    if (something_before) left.leave(TrailKind::kRocket, {0, 0, 0}, {500, 0, 1}, 1, 1);
    const std::size_t before = left.pool.size();
    left.trails.begin(kRocket, {7, 8, 9});
    left.leave(TrailKind::kRocket, {7, 8, 9}, {207, 8, 9}, 1, 1);
    left.pool.advance(1);
    const render::ParticleCloud cloud = left.pool.cloud();
    std::vector<float> places(cloud.x.begin() + static_cast<std::ptrdiff_t>(before), cloud.x.end());
    places.insert(places.end(), cloud.z.begin() + static_cast<std::ptrdiff_t>(before), cloud.z.end());
    return places;
  };
  EXPECT_GT(find_last(false).size(), 100u);
  EXPECT_EQ(find_last(true), find_last(false));
}

}  // namespace
}  // namespace temblor::client
