#include "formats/models/group_time.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "support/random.h"

namespace temblor::formats {
namespace {

TEST(GroupTime, MembersFollowOneAnotherAndRepeat) {
  const std::array ends_s = {0.5f, 0.75f, 2.0f};
  for (const double repeats : {-3.0, -1.0, 0.0, 1.0, 1000.0}) {
    const double start_s = 2 * repeats;
    EXPECT_EQ(find_group_member(ends_s, start_s), 0u) << repeats;
    EXPECT_EQ(find_group_member(ends_s, start_s + 0.499), 0u) << repeats;
    EXPECT_EQ(find_group_member(ends_s, start_s + 0.5), 1u) << repeats;
    EXPECT_EQ(find_group_member(ends_s, start_s + 0.75), 2u) << repeats;
    EXPECT_EQ(find_group_member(ends_s, start_s + 1.999), 2u) << repeats;
  }
}

TEST(GroupTime, NoGroupAndAGroupOfOne) {
  for (const double time_s : {-1e9, 0.0, 0.3, 1e300}) {
    EXPECT_EQ(find_group_member({}, time_s), 0u);
    EXPECT_EQ(find_group_member(std::array{0.1f}, time_s), 0u);
  }
}

TEST(GroupTime, AnyTimeHasAMember) {
  const double denormal_s = std::numeric_limits<double>::denorm_min();
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    test::Random random(seed);
    std::vector<float> ends_s;
    float end_s = 0;
    for (std::size_t i = 1 + random.below(20); i > 0; --i)
      ends_s.push_back(end_s += static_cast<float>(random.log_uniform(1e-3, 10)));
    const double time_s = random.uniform(-1, 1) * random.log_uniform(1e-9, 1e12);
    const std::size_t member = find_group_member(ends_s, time_s);
    ASSERT_LT(member, ends_s.size()) << "seed " << seed;
    // By definition: the member whose interval contains the time, minus a whole number of periods.
    double within_s = std::remainder(time_s, double{ends_s.back()});
    if (within_s < 0) within_s += ends_s.back();
    EXPECT_LE(within_s, ends_s[member]) << "seed " << seed;
    EXPECT_GE(within_s, member > 0 ? ends_s[member - 1] : 0.0f) << "seed " << seed;
    EXPECT_EQ(find_group_member(ends_s, -denormal_s), ends_s.size() - 1) << "seed " << seed;
  }
}

TEST(GroupTime, TimesRiseFromZero) {
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_TRUE(are_group_times({}));
  EXPECT_TRUE(are_group_times(std::array{0.1f, 0.2f}));
  EXPECT_FALSE(are_group_times(std::array{0.0f, 0.2f}));
  EXPECT_FALSE(are_group_times(std::array{-0.1f}));
  EXPECT_FALSE(are_group_times(std::array{0.2f, 0.2f}));
  EXPECT_FALSE(are_group_times(std::array{0.2f, 0.1f}));
  EXPECT_FALSE(are_group_times(std::array{0.2f, infinity}));
  EXPECT_FALSE(are_group_times(std::array{std::numeric_limits<float>::quiet_NaN()}));
}

}  // namespace
}  // namespace temblor::formats
