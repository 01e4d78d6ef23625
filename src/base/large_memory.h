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

// At least `bytes`, not initialized, aligned to a cache line; null when there is no memory.
LargeMemory<std::byte> allocate_large_bytes(std::size_t bytes);

template <typename T>
LargeMemory<T> allocate_large(std::size_t count) {
  LargeMemory<std::byte> bytes = allocate_large_bytes(count * sizeof(T));
  const FreeLargeMemory free = bytes.get_deleter();
  return {reinterpret_cast<T*>(bytes.release()), free};
}

}  // namespace temblor::base
