#include "render/surfaces/block_pool.h"

// What no room covers is poisoned, so that the address sanitizer sees reads of it. In other builds its macros
// do nothing.
#include <sanitizer/asan_interface.h>

#include <algorithm>

#include "base/check.h"

namespace temblor::render {

void BlockPool::set_capacity(std::size_t bytes) {
  capacity_bytes_ = bytes;
  for (Slab& slab : slabs_) {
    if (bytes_reserved_ <= capacity_bytes_) return;
    if (slab.memory == nullptr || slab.largest_hole < slab.bytes) continue;
    bytes_reserved_ -= slab.bytes;
    slab = Slab{};
  }
}

BlockPool::Room BlockPool::allocate(std::size_t bytes) {
  bytes = rounded_up(bytes);
  if (bytes_in_use_ + bytes > capacity_bytes_) return {};
  for (std::size_t slab = 0; slab < slabs_.size(); ++slab)
    if (slabs_[slab].largest_hole >= bytes) return take(slab, bytes);
  return add_slab(bytes, base::FirstTouch::kInSmallPages) != nullptr ? allocate(bytes) : Room{};
}

// Whole large pages where the capacity leaves one, as a part of one would cost as much.
BlockPool::Slab* BlockPool::add_slab(std::size_t least_bytes, base::FirstTouch first_touch) {
  if (bytes_reserved_ >= capacity_bytes_) return nullptr;
  std::size_t bytes = std::min(kSlabBytes, capacity_bytes_ - bytes_reserved_);
  bytes -= bytes % (bytes >= base::kLargePageBytes ? base::kLargePageBytes : kUnitBytes);
  if (bytes < least_bytes) return nullptr;
  Slab slab{base::allocate_large<std::byte>(bytes, first_touch), bytes, bytes, {{0, bytes}}};
  if (slab.memory == nullptr) return nullptr;
  constexpr std::size_t kUsualHoles = 256;
  slab.holes.reserve(kUsualHoles);
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

// From a slab that has a hole for it.
BlockPool::Room BlockPool::take(std::size_t number, std::size_t bytes) {
  Slab& slab = slabs_[number];
  const auto hole = std::find_if(slab.holes.begin(), slab.holes.end(),
                                 [&](const Hole& candidate) { return candidate.bytes >= bytes; });
  const Room room{slab.memory.get() + hole->begin, bytes, number};
  const bool was_largest = hole->bytes == slab.largest_hole;
  hole->begin += bytes;
  hole->bytes -= bytes;
  if (hole->bytes == 0) slab.holes.erase(hole);
  if (was_largest) {
    slab.largest_hole = 0;
    for (const Hole& other : slab.holes) slab.largest_hole = std::max(slab.largest_hole, other.bytes);
  }
  bytes_in_use_ += bytes;
  ASAN_UNPOISON_MEMORY_REGION(room.begin, bytes);
  return room;
}

void BlockPool::free(const Room& room) {
  Slab& slab = slabs_[room.slab];
  Hole freed{static_cast<std::size_t>(room.begin - slab.memory.get()), room.bytes};
  auto next = std::lower_bound(slab.holes.begin(), slab.holes.end(), freed.begin,
                               [](const Hole& hole, std::size_t begin) { return hole.begin < begin; });
  DCHECK(next == slab.holes.end() || freed.begin + freed.bytes <= next->begin);
  if (next != slab.holes.end() && next->begin == freed.begin + freed.bytes) {
    freed.bytes += next->bytes;
    next = slab.holes.erase(next);
  }
  if (next != slab.holes.begin() && std::prev(next)->begin + std::prev(next)->bytes == freed.begin) {
    freed = {std::prev(next)->begin, std::prev(next)->bytes + freed.bytes};
    *std::prev(next) = freed;
  } else {
    slab.holes.insert(next, freed);
  }
  slab.largest_hole = std::max(slab.largest_hole, freed.bytes);
  bytes_in_use_ -= room.bytes;
  ASAN_POISON_MEMORY_REGION(room.begin, room.bytes);
}

void BlockPool::clear() {
  for (Slab& slab : slabs_) {
    slab.holes.clear();
    if (slab.bytes > 0) slab.holes.push_back({0, slab.bytes});
    slab.largest_hole = slab.bytes;
    ASAN_POISON_MEMORY_REGION(slab.memory.get(), slab.bytes);
  }
  bytes_in_use_ = 0;
}

}  // namespace temblor::render
