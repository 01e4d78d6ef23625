// Compares the heap with a sorted multiset.
#include "scripted_player/navigation/route_heap.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "support/random.h"

namespace temblor::test {
namespace {

TEST(RouteHeap, PopsTheLowestCostAndThenTheLowestPlace) {
  Random random(41);
  player::RouteHeap heap;
  std::multiset<std::pair<float, std::uint32_t>> expected;
  for (int i = 0; i < 20000; ++i) {
    // Half of the costs are whole numbers, so that many are equal. The heap grows and empties several times.
    if (expected.empty() || random.chance(i / 2000 % 2 == 0 ? 0.7 : 0.3)) {
      const double cost = random.chance(0.5) ? static_cast<double>(random.below(8)) : random.uniform(0, 1e9);
      const auto place = static_cast<std::uint32_t>(random.below(1u << 31));
      heap.push(static_cast<float>(cost), place);
      expected.insert({static_cast<float>(cost), place});
    } else {
      const player::RouteHeap::Entry entry = heap.pop();
      EXPECT_EQ(std::pair(entry.cost, entry.place), *expected.begin()) << i;
      expected.erase(expected.begin());
    }
    ASSERT_EQ(heap.is_empty(), expected.empty());
  }
}

}  // namespace
}  // namespace temblor::test
