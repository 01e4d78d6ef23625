#include "base/arena.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

namespace temblor::base {
namespace {

std::uintptr_t address(const void* pointer) {
  return reinterpret_cast<std::uintptr_t>(pointer);
}

// The sizes of the allocations of one frame; some are larger than the first block.
std::vector<std::size_t> random_sizes(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::size_t> sizes(200);
  for (std::size_t& size : sizes) size = std::size_t{1} << (random() % 18);
  return sizes;
}

TEST(Arena, AllocationsAreAlignedAndDisjoint) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Arena arena;
    std::vector<std::span<std::uint8_t>> rooms;
    for (const std::size_t size : random_sizes(seed)) {
      rooms.push_back(arena.allocate_filled<std::uint8_t>(size, static_cast<std::uint8_t>(rooms.size())));
      ASSERT_EQ(rooms.back().size(), size);
      ASSERT_EQ(address(rooms.back().data()) % 64, 0u) << "seed " << seed;
    }
    // All were written one after another and are still intact, so they do not overlap.
    for (std::size_t i = 0; i < rooms.size(); ++i)
      for (const std::uint8_t byte : rooms[i])
        ASSERT_EQ(byte, static_cast<std::uint8_t>(i)) << "seed " << seed;
  }
}

TEST(Arena, CountsUsedBytes) {
  Arena arena;
  EXPECT_EQ(arena.used_bytes(), 0u);
  arena.allocate<std::uint8_t>(1);
  arena.allocate<std::uint32_t>(16);
  EXPECT_EQ(arena.used_bytes(), 128u);
  arena.allocate<std::uint8_t>(10'000'000);
  EXPECT_GE(arena.used_bytes(), 10'000'128u);
  arena.reset();
  EXPECT_EQ(arena.used_bytes(), 0u);
}

// After the first frame there is one block: the same requests get the same adjacent places in every later
// frame.
TEST(Arena, WarmFrameReusesOneBlock) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const std::vector<std::size_t> sizes = random_sizes(seed);
    Arena arena;
    const auto frame = [&] {
      std::vector<std::uintptr_t> places;
      for (const std::size_t size : sizes) places.push_back(address(arena.allocate<std::byte>(size).data()));
      arena.reset();
      return places;
    };
    frame();
    const auto warm = frame();
    for (std::size_t i = 1; i < warm.size(); ++i)
      ASSERT_EQ(warm[i] - warm[i - 1], (sizes[i - 1] + 63) / 64 * 64) << "seed " << seed;
    EXPECT_EQ(frame(), warm);
  }
}

TEST(Arena, EmptyRequestReturnsEmptySpan) {
  Arena arena;
  EXPECT_TRUE(arena.allocate<int>(0).empty());
}

TEST(ArenaVector, GrowsLikeVector) {
  Arena arena;
  std::mt19937_64 random(7);
  ArenaVector<std::uint64_t> ours(arena, 1);
  std::vector<std::uint64_t> theirs;
  for (int step = 0; step < 20'000; ++step) {
    if (!theirs.empty() && random() % 4 == 0) {
      ours.pop_back();
      theirs.pop_back();
    } else {
      const std::uint64_t value = random();
      ours.push_back(value);
      theirs.push_back(value);
      ASSERT_EQ(ours.back(), value);
    }
  }
  EXPECT_EQ(std::vector<std::uint64_t>(ours.begin(), ours.end()), theirs);
  EXPECT_EQ(ours.view().size(), theirs.size());
  ours.clear();
  EXPECT_TRUE(ours.empty());
}

}  // namespace
}  // namespace temblor::base
