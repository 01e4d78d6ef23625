// Memory for large arrays with random access, such as frame buffers and the surface cache. Allocations of 2
// MiB and more are aligned to 2 MiB and request large pages from Linux (madvise), which save most TLB misses,
// and 511 of 512 page faults at the first touch.
#pragma once

#include <cstddef>
#include <memory>
#include <new>

namespace temblor::base {

constexpr std::size_t kLargePageBytes = std::size_t{2} << 20;
constexpr std::size_t kCacheLineBytes = 64;

// Deleter; remembers the alignment, which operator delete needs.
struct FreeLargeMemory {
  std::align_val_t alignment{};
  void operator()(void* memory) const { ::operator delete(memory, alignment); }
};
template <typename T>
using LargeMemory = std::unique_ptr<T[], FreeLargeMemory>;

// A page fault of a large page may take milliseconds, because the system clears 2 MiB and may have to compact
// memory first. So memory that is first touched inside of a frame should use small pages.
enum class FirstTouch { kInLargePages, kInSmallPages };

// Allocates at least `bytes`, uninitialized, aligned to a cache line. Returns null if memory is exhausted.
LargeMemory<std::byte> allocate_large_bytes(std::size_t bytes,
                                            FirstTouch first_touch = FirstTouch::kInLargePages);

// Like allocate_large_bytes(), for `count` uninitialized elements of a trivial type.
template <typename T>
LargeMemory<T> allocate_large(std::size_t count, FirstTouch first_touch = FirstTouch::kInLargePages) {
  LargeMemory<std::byte> bytes = allocate_large_bytes(count * sizeof(T), first_touch);
  const FreeLargeMemory free = bytes.get_deleter();
  return {reinterpret_cast<T*>(bytes.release()), free};
}

}  // namespace temblor::base
