// The block pool against a list of its allocations: inside its memory, aligned, without overlap, and never
// more than its capacity.
#include "render/surfaces/block_pool.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "support/effort.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using render::BlockPool;

constexpr std::size_t kPlenty = std::size_t{64} << 20;
constexpr std::size_t kSlab = BlockPool::kSlabBytes;

// An allocation, filled with a pattern of its own.
struct Held {
  BlockPool::Allocation allocation;
  std::byte mark;
};
void fill(const Held& held) {
  std::fill_n(held.allocation.begin, held.allocation.bytes, held.mark);
}
bool is_whole(const Held& held) {
  return std::count(held.allocation.begin, held.allocation.begin + held.allocation.bytes, held.mark) ==
         static_cast<std::ptrdiff_t>(held.allocation.bytes);
}

// Sizes like those of blocks: mostly small, sometimes large.
std::size_t random_size(Random& random) {
  return 1 + random.below(random.chance(0.8) ? 5000 : 300000);
}

TEST(BlockPool, KeepsAllocationsApartAlignedAndWithinItsCapacity) {
  for (int seed = 0; seed < effort(30, 3); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    BlockPool pool;
    std::size_t capacity = 0;
    std::vector<Held> held;
    std::size_t held_bytes = 0;
    for (int step = 0; step < 2000; ++step) {
      SCOPED_TRACE(fmt::format("seed {}, step {}", seed, step));
      if (step % 500 == 0) {
        capacity = held_bytes + random.below(3 * kSlab);
        pool.set_capacity(capacity);
      }
      if (!held.empty() && random.chance(0.45)) {
        std::swap(held[random.below(held.size())], held.back());
        ASSERT_TRUE(is_whole(held.back()));
        held_bytes -= held.back().allocation.bytes;
        pool.free(held.back().allocation);
        held.pop_back();
      } else {
        const std::size_t bytes = random_size(random);
        const BlockPool::Allocation allocation = pool.allocate(bytes);
        if (allocation.begin != nullptr) {
          ASSERT_GE(allocation.bytes, bytes);
          ASSERT_LT(allocation.bytes, bytes + BlockPool::kUnitBytes);
          ASSERT_EQ(reinterpret_cast<std::uintptr_t>(allocation.begin) % 64, 0u);
          held.push_back({allocation, static_cast<std::byte>(random.bits())});
          held_bytes += allocation.bytes;
          fill(held.back());
        }
      }
      ASSERT_EQ(pool.bytes_in_use(), held_bytes);
      ASSERT_LE(held_bytes, capacity);
      ASSERT_LE(held_bytes, pool.bytes_reserved());
    }
    // Written at different times and still intact: no two overlap.
    EXPECT_TRUE(std::all_of(held.begin(), held.end(), is_whole)) << "seed " << seed;
  }
}

// Allocates until nothing fits, from a capacity that never changed.
TEST(BlockPool, TakesNoMoreMemoryThanItsCapacity) {
  for (int seed = 0; seed < effort(20, 3); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    BlockPool pool;
    const std::size_t capacity = random.below(3 * kSlab);
    pool.set_capacity(capacity);
    std::vector<BlockPool::Allocation> allocations;
    for (int step = 0; step < 3000; ++step) {
      const BlockPool::Allocation allocation = pool.allocate(random_size(random));
      if (allocation.begin != nullptr) allocations.push_back(allocation);
      if (allocations.size() > 1 && random.chance(0.1)) {
        pool.free(allocations.back());
        allocations.pop_back();
      }
      ASSERT_LE(pool.bytes_reserved(), capacity) << "seed " << seed;
    }
  }
}

TEST(BlockPool, MergesAllFreedRangesInAnyOrder) {
  for (int seed = 0; seed < effort(50, 5); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    BlockPool pool;
    pool.set_capacity(kSlab);
    std::vector<BlockPool::Allocation> allocations;
    for (;;) {
      allocations.push_back(pool.allocate(random_size(random)));
      if (allocations.back().begin == nullptr) break;
    }
    allocations.pop_back();
    while (!allocations.empty()) {
      std::swap(allocations[random.below(allocations.size())], allocations.back());
      pool.free(allocations.back());
      allocations.pop_back();
    }
    EXPECT_EQ(pool.bytes_in_use(), 0u);
    EXPECT_NE(pool.allocate(kSlab).begin, nullptr) << "seed " << seed;
    EXPECT_EQ(pool.bytes_reserved(), kSlab);
  }
}

TEST(BlockPool, GivesFreedMemoryOutAgain) {
  BlockPool pool;
  pool.set_capacity(kPlenty);
  const BlockPool::Allocation first = pool.allocate(1000), second = pool.allocate(1000);
  pool.free(first);
  EXPECT_EQ(pool.allocate(1000).begin, first.begin);
  pool.free(second);
  EXPECT_EQ(pool.allocate(1000).begin, second.begin);
}

TEST(BlockPool, FillsASlabBeforeItTakesAnother) {
  BlockPool pool;
  pool.set_capacity(kPlenty);
  for (std::size_t taken = 0; taken < kSlab; taken += kSlab / 8) {
    EXPECT_NE(pool.allocate(kSlab / 8).begin, nullptr);
    EXPECT_EQ(pool.bytes_reserved(), kSlab);
  }
  pool.allocate(1);
  EXPECT_EQ(pool.bytes_reserved(), 2 * kSlab);
}

TEST(BlockPool, GivesOutWhatItPrepared) {
  BlockPool pool;
  pool.set_capacity(kPlenty);
  pool.prepare(kSlab + 1);
  EXPECT_EQ(pool.bytes_reserved(), 2 * kSlab);
  pool.prepare(2 * kSlab);
  EXPECT_EQ(pool.bytes_in_use(), 0u);
  for (int i = 0; i < 2; ++i) EXPECT_NE(pool.allocate(kSlab).begin, nullptr);
  EXPECT_EQ(pool.bytes_reserved(), 2 * kSlab);
}

TEST(BlockPool, PreparesNoMoreThanItsCapacity) {
  for (const std::size_t capacity : {std::size_t{0}, std::size_t{63}, std::size_t{1000}, kSlab + 1000}) {
    BlockPool pool;
    pool.set_capacity(capacity);
    pool.prepare(kPlenty);
    EXPECT_EQ(pool.bytes_reserved(), capacity / 64 * 64);
  }
}

TEST(BlockPool, UsesAllOfASmallCapacity) {
  BlockPool pool;
  pool.set_capacity(3 * BlockPool::kUnitBytes);
  for (int i = 0; i < 3; ++i) EXPECT_NE(pool.allocate(1).begin, nullptr);
  EXPECT_EQ(pool.allocate(1).begin, nullptr);
}

TEST(BlockPool, GivesEmptySlabsBackWhenTheCapacityShrinks) {
  BlockPool pool;
  pool.set_capacity(kPlenty);
  const BlockPool::Allocation first = pool.allocate(kSlab), second = pool.allocate(kSlab);
  pool.set_capacity(kSlab);
  EXPECT_EQ(pool.bytes_reserved(), 2 * kSlab);
  pool.free(first);
  pool.set_capacity(kSlab);
  EXPECT_EQ(pool.bytes_reserved(), kSlab);
  EXPECT_EQ(pool.allocate(1).begin, nullptr);
  pool.free(second);
  EXPECT_NE(pool.allocate(kSlab).begin, nullptr);
  // Another slab can take the place of one that was given back.
  pool.set_capacity(kPlenty);
  EXPECT_NE(pool.allocate(kSlab).begin, nullptr);
  EXPECT_EQ(pool.bytes_reserved(), 2 * kSlab);
}

TEST(BlockPool, KeepsItsSlabsWhenCleared) {
  BlockPool pool;
  pool.set_capacity(2 * kSlab);
  for (int round = 0; round < 3; ++round) {
    for (int i = 0; i < 2; ++i) EXPECT_NE(pool.allocate(kSlab).begin, nullptr);
    EXPECT_EQ(pool.allocate(1).begin, nullptr);
    pool.clear();
    EXPECT_EQ(pool.bytes_in_use(), 0u);
    EXPECT_EQ(pool.bytes_reserved(), 2 * kSlab);
  }
}

}  // namespace
}  // namespace temblor::test
