// The memory of the surface cache: slabs of large pages, added one after another up to a capacity, from which
// blocks are allocated in units of a cache line. Free ranges that touch are merged.
//
// Allocation is first fit at the lowest address. That keeps used memory together, so few pages are touched;
// and a large allocation can be made from the space of several small neighbors, which size classes could not
// do. Stock Quake uses one ring buffer instead, which evicts whatever lies in the way.
//
//   slab 0  |AAAA|BB|....|CCC|..|      used blocks and free ranges
//   slab 1  |DD|..................|
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/large_memory.h"

namespace temblor::render {

class BlockPool {
 public:
  static constexpr std::size_t kUnitBytes = base::kCacheLineBytes;
  static constexpr std::size_t kSlabBytes = 4 * base::kLargePageBytes;
  static std::size_t rounded_up(std::size_t bytes) {
    return (bytes + kUnitBytes - 1) / kUnitBytes * kUnitBytes;
  }

  // The limit for the sum of all slabs from now on. Slabs beyond it are given back at once if they are empty.
  // Other slabs remain until they are empty and the capacity is set again.
  void set_capacity(std::size_t bytes);

  // Adds slabs until they hold `bytes`, or as much as the capacity allows, and touches their memory now, in
  // large pages: the first touch of a page costs far more than later writes. Slabs that are added later are
  // touched in small pages, as they fill.
  void prepare(std::size_t bytes);

  struct Allocation {
    std::byte* begin = nullptr;  // null: the allocation failed
    std::size_t bytes = 0;       // a multiple of kUnitBytes
    std::size_t slab = 0;
  };
  // Allocates `bytes` (1 to kSlabBytes) of uninitialized memory. Fails if no free range is large enough or
  // the capacity would be exceeded; the caller then evicts blocks and tries again.
  Allocation allocate(std::size_t bytes);
  // `allocation` must come from this pool and not have been freed.
  void free(const Allocation& allocation);
  // Frees all allocations and keeps the slabs.
  void clear();

  std::size_t bytes_in_use() const { return bytes_in_use_; }      // by allocations
  std::size_t bytes_reserved() const { return bytes_reserved_; }  // by slabs

 private:
  // Offsets from the slab's start.
  struct FreeRange {
    std::size_t begin, bytes;
  };
  struct Slab {
    base::LargeMemory<std::byte> memory;  // null: given back
    std::size_t bytes = 0;
    std::size_t largest_free = 0;        // lets allocate() skip slabs without a search
    std::vector<FreeRange> free_ranges;  // sorted by begin; no two touch
  };

  Allocation take(std::size_t slab, std::size_t bytes);
  // Null if the capacity leaves less than `min_bytes`, or the system has no memory.
  Slab* add_slab(std::size_t min_bytes, base::FirstTouch first_touch);

  std::vector<Slab> slabs_;
  std::size_t capacity_bytes_ = 0;
  std::size_t bytes_in_use_ = 0;
  std::size_t bytes_reserved_ = 0;
};

}  // namespace temblor::render
