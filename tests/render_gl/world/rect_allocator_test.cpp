#include "render_gl/surfaces/rect_allocator.h"

#include <gtest/gtest.h>

#include "support/random.h"

namespace temblor::render_gl {
namespace {

struct Rect {
  RectAllocator::Number number;
  AtlasPlace place;
  RectAllocator::Size size;
};

bool overlap(const Rect& a, const Rect& b) {
  const auto apart = [](int a_first, int a_power, int b_first, int b_power) {
    return a_first + (1 << a_power) <= b_first || b_first + (1 << b_power) <= a_first;
  };
  return a.place.layer == b.place.layer && !apart(a.place.x, a.size.width, b.place.x, b.size.width) &&
         !apart(a.place.y, a.size.height, b.place.y, b.size.height);
}

TEST(RectAllocator, FindsTheSmallestPowersOfTwo) {
  const auto fit = [](int width, int height) {
    const RectAllocator::Size size = RectAllocator::fit(width, height);
    return std::pair(1 << size.width, 1 << size.height);
  };
  EXPECT_EQ(fit(1, 8), std::pair(8, 8));
  EXPECT_EQ(fit(9, 16), std::pair(16, 16));
  EXPECT_EQ(fit(256, 257), std::pair(256, 512));
}

TEST(RectAllocator, NeverGivesAwayAPlaceTwice) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    test::Random random(seed);
    RectAllocator allocator(8, 3);
    std::vector<Rect> used;
    for (int step = 0; step < 400; ++step) {
      if (!used.empty() && random.chance(0.3)) {
        const std::size_t i = random.below(used.size());
        allocator.free(used[i].number);
        used.erase(used.begin() + static_cast<std::ptrdiff_t>(i));
        continue;
      }
      const int width = static_cast<int>(random.log_uniform(1, 256));
      const int height = static_cast<int>(random.log_uniform(1, 256));
      const RectAllocator::Size size = RectAllocator::fit(width, height);
      const std::optional<RectAllocator::Rect> given = allocator.allocate(size);
      if (!given) continue;
      const Rect rect{given->number, given->place, size};
      ASSERT_LE(rect.place.x + (1 << size.width), 256);
      ASSERT_LE(rect.place.y + (1 << size.height), 256);
      ASSERT_LT(rect.place.layer, 3);
      for (const Rect& other : used)
        ASSERT_FALSE(overlap(rect, other)) << "seed " << seed << ", step " << step;
      used.push_back(rect);
    }
    // Halves have become whole layers again.
    for (const Rect& rect : used) allocator.free(rect.number);
    for (int layer = 0; layer < 3; ++layer) EXPECT_TRUE(allocator.allocate({8, 8})) << "seed " << seed;
  }
}

TEST(RectAllocator, FillsALayerAndStartsAgain) {
  RectAllocator allocator(6, 2);
  for (int round = 0; round < 2; ++round) {
    for (int i = 0; i < 2 * 64; ++i) EXPECT_TRUE(allocator.allocate({3, 3}));
    EXPECT_FALSE(allocator.allocate({3, 3}));
    allocator.clear();
  }
  EXPECT_FALSE(allocator.allocate({7, 3}));
}

}  // namespace
}  // namespace temblor::render_gl
