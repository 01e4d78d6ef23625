// Memory for what is big and read all over the place. From 2 MiB on it is aligned to that and asks for large
// pages, which spare most address translations, and all but one page fault in 512 of a first touch.
#pragma once

#include <cstddef>
#include <memory>
#include <new>

namespace temblor::base {

constexpr std::size_t kLargePageBytes = std::size_t{2} << 20;
constexpr std::size_t kCacheLineBytes = 64;

struct FreeLargeMemory {
  std::align_val_t alignment{};
  void operator()(void* memory) const { ::operator delete(memory, alignment); }
};
template <typename T>
using LargeMemory = std::unique_ptr<T[], FreeLargeMemory>;

// Large pages are few faults, but each may take milliseconds: 2 MiB to be cleared, and perhaps to be gathered
// first. What is touched first within a frame that must not be late asks for none.
enum class FirstTouch { kInLargePages, kInSmallPages };

// At least `bytes`, not initialized, aligned to a cache line; null when there is no memory.
LargeMemory<std::byte> allocate_large_bytes(std::size_t bytes,
                                            FirstTouch first_touch = FirstTouch::kInLargePages);

template <typename T>
LargeMemory<T> allocate_large(std::size_t count, FirstTouch first_touch = FirstTouch::kInLargePages) {
  LargeMemory<std::byte> bytes = allocate_large_bytes(count * sizeof(T), first_touch);
  const FreeLargeMemory free = bytes.get_deleter();
  return {reinterpret_cast<T*>(bytes.release()), free};
}

}  // namespace temblor::base
