#include "base/nearest_name.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

namespace temblor::base {
namespace {

using ::testing::Eq;
using ::testing::Optional;

// By its definition: the cheapest way to edit the first characters.
std::size_t distance_by_recursion(std::string_view a, std::string_view b) {
  if (a.empty()) return b.size();
  if (b.empty()) return a.size();
  const std::string_view short_a = a.substr(1), short_b = b.substr(1);
  const std::size_t least =
      std::min({distance_by_recursion(short_a, b) + 1, distance_by_recursion(a, short_b) + 1,
                distance_by_recursion(short_a, short_b) + (a[0] == b[0] ? 0 : 1)});
  if (a.size() < 2 || b.size() < 2 || a[0] != b[1] || a[1] != b[0]) return least;
  return std::min(least, distance_by_recursion(a.substr(2), b.substr(2)) + 1);
}

TEST(NearestName, DistanceIsAsDefined) {
  std::mt19937 random(7);
  const auto make_word = [&] {
    std::string word(random() % 6, 'a');
    for (char& c : word) c = static_cast<char>('a' + random() % 3);
    return word;
  };
  for (int i = 0; i < 300; ++i) {
    const std::string a = make_word(), b = make_word();
    EXPECT_EQ(edit_distance(a, b), distance_by_recursion(a, b)) << a << " " << b;
  }
}

TEST(NearestName, IsTheFirstOfTheNearest) {
  const std::string_view names[] = {"bounce", "bouncescale", "phong", "phong_angle"};
  EXPECT_THAT(find_nearest_name("pon_angels", names), Eq(std::nullopt));
  EXPECT_THAT(find_nearest_name("phong_angel", names), Optional(Eq("phong_angle")));
  EXPECT_THAT(find_nearest_name("bounec", names), Optional(Eq("bounce")));
  EXPECT_THAT(find_nearest_name("bonce", names), Optional(Eq("bounce")));
  EXPECT_THAT(find_nearest_name("", names), Eq(std::nullopt));
  EXPECT_THAT(find_nearest_name("light", names), Eq(std::nullopt));
}

}  // namespace
}  // namespace temblor::base
