#include "render/surfaces/block_pool.h"

// Memory outside allocations is poisoned, so that the address sanitizer reports reads of it. In other builds
// the macros do nothing.
#include <sanitizer/asan_interface.h>

#include <algorithm>

#include "base/check.h"

namespace temblor::render {

void BlockPool::set_capacity(std::size_t bytes) {
  capacity_bytes_ = bytes;
  for (Slab& slab : slabs_) {
    if (bytes_reserved_ <= capacity_bytes_) return;
    if (slab.memory == nullptr || slab.largest_free < slab.bytes) continue;
    bytes_reserved_ -= slab.bytes;
    slab = Slab{};
  }
}

BlockPool::Allocation BlockPool::allocate(std::size_t bytes) {
  bytes = rounded_up(bytes);
  if (bytes_in_use_ + bytes > capacity_bytes_) return {};
  for (std::size_t slab = 0; slab < slabs_.size(); ++slab)
    if (slabs_[slab].largest_free >= bytes) return take(slab, bytes);
  return add_slab(bytes, base::FirstTouch::kInSmallPages) != nullptr ? allocate(bytes) : Allocation{};
}

// Whole large pages if the capacity leaves one, since a part of a page would cost as much memory. A slot of
// slabs_ that was given back is reused, so that Allocation::slab stays valid for the others.
BlockPool::Slab* BlockPool::add_slab(std::size_t min_bytes, base::FirstTouch first_touch) {
  if (bytes_reserved_ >= capacity_bytes_) return nullptr;
  std::size_t bytes = std::min(kSlabBytes, capacity_bytes_ - bytes_reserved_);
  bytes -= bytes % (bytes >= base::kLargePageBytes ? base::kLargePageBytes : kUnitBytes);
  if (bytes < min_bytes) return nullptr;
  Slab slab{base::allocate_large<std::byte>(bytes, first_touch), bytes, bytes, {{0, bytes}}};
  if (slab.memory == nullptr) return nullptr;
  constexpr std::size_t kTypicalFreeRanges = 256;
  slab.free_ranges.reserve(kTypicalFreeRanges);
  ASAN_POISON_MEMORY_REGION(slab.memory.get(), bytes);
  bytes_reserved_ += bytes;
  const auto given_back =
      std::find_if(slabs_.begin(), slabs_.end(), [](const Slab& other) { return other.memory == nullptr; });
  if (given_back == slabs_.end()) return &slabs_.emplace_back(std::move(slab));
  return &(*given_back = std::move(slab));
}

void BlockPool::prepare(std::size_t bytes) {
  constexpr std::size_t kMinPageBytes = 4096;
  while (bytes_reserved_ < bytes) {
    const Slab* slab = add_slab(kUnitBytes, base::FirstTouch::kInLargePages);
    if (slab == nullptr) return;
    ASAN_UNPOISON_MEMORY_REGION(slab->memory.get(), slab->bytes);
    for (std::size_t at = 0; at < slab->bytes; at += kMinPageBytes) slab->memory[at] = std::byte{0};
    ASAN_POISON_MEMORY_REGION(slab->memory.get(), slab->bytes);
  }
}

// Takes the first free range of slab `number` that is large enough; there must be one.
BlockPool::Allocation BlockPool::take(std::size_t number, std::size_t bytes) {
  Slab& slab = slabs_[number];
  const auto free_range = std::find_if(slab.free_ranges.begin(), slab.free_ranges.end(),
                                       [&](const FreeRange& candidate) { return candidate.bytes >= bytes; });
  const Allocation allocation{slab.memory.get() + free_range->begin, bytes, number};
  const bool was_largest = free_range->bytes == slab.largest_free;
  free_range->begin += bytes;
  free_range->bytes -= bytes;
  if (free_range->bytes == 0) slab.free_ranges.erase(free_range);
  if (was_largest) {
    slab.largest_free = 0;
    for (const FreeRange& other : slab.free_ranges)
      slab.largest_free = std::max(slab.largest_free, other.bytes);
  }
  bytes_in_use_ += bytes;
  ASAN_UNPOISON_MEMORY_REGION(allocation.begin, bytes);
  return allocation;
}

// Merges the freed range with the free range after it and the one before it, if they touch.
void BlockPool::free(const Allocation& allocation) {
  Slab& slab = slabs_[allocation.slab];
  FreeRange freed{static_cast<std::size_t>(allocation.begin - slab.memory.get()), allocation.bytes};
  auto next = std::lower_bound(
      slab.free_ranges.begin(), slab.free_ranges.end(), freed.begin,
      [](const FreeRange& free_range, std::size_t begin) { return free_range.begin < begin; });
  DCHECK(next == slab.free_ranges.end() || freed.begin + freed.bytes <= next->begin);
  if (next != slab.free_ranges.end() && next->begin == freed.begin + freed.bytes) {
    freed.bytes += next->bytes;
    next = slab.free_ranges.erase(next);
  }
  if (next != slab.free_ranges.begin() && std::prev(next)->begin + std::prev(next)->bytes == freed.begin) {
    freed = {std::prev(next)->begin, std::prev(next)->bytes + freed.bytes};
    *std::prev(next) = freed;
  } else {
    slab.free_ranges.insert(next, freed);
  }
  slab.largest_free = std::max(slab.largest_free, freed.bytes);
  bytes_in_use_ -= allocation.bytes;
  ASAN_POISON_MEMORY_REGION(allocation.begin, allocation.bytes);
}

void BlockPool::clear() {
  for (Slab& slab : slabs_) {
    slab.free_ranges.clear();
    if (slab.bytes > 0) slab.free_ranges.push_back({0, slab.bytes});
    slab.largest_free = slab.bytes;
    ASAN_POISON_MEMORY_REGION(slab.memory.get(), slab.bytes);
  }
  bytes_in_use_ = 0;
}

}  // namespace temblor::render
