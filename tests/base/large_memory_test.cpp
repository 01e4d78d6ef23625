#include "base/large_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace temblor::base {
namespace {

template <typename T>
std::uintptr_t address(const LargeMemory<T>& memory) {
  return reinterpret_cast<std::uintptr_t>(memory.get());
}

TEST(LargeMemory, StartsAtACacheLineAndCanBeWritten) {
  for (const std::size_t count : {1u, 63u, 64u, 65u, 1000u, 100'000u}) {
    const LargeMemory<std::uint32_t> memory = allocate_large<std::uint32_t>(count);
    ASSERT_NE(memory, nullptr);
    EXPECT_EQ(address(memory) % 64, 0u);
    std::fill_n(memory.get(), count, 7u);
  }
}

TEST(LargeMemory, StartsAtALargePageFromItsSizeOn) {
  for (const std::size_t bytes : {kLargePageBytes, kLargePageBytes + 1, 3 * kLargePageBytes}) {
    const LargeMemory<std::byte> memory = allocate_large<std::byte>(bytes);
    ASSERT_NE(memory, nullptr);
    EXPECT_EQ(address(memory) % kLargePageBytes, 0u);
    std::fill_n(memory.get(), bytes, std::byte{7});
  }
}

}  // namespace
}  // namespace temblor::base
