// Memory for the blocks of the surface cache: slabs in large pages, taken one after another up to a capacity,
// and given out in cache lines by first fit. Rooms that are freed join their free neighbors.
//
// First fit at the lowest place keeps what is in use together, so that few pages are touched; and a room of
// any size can be made of what several smaller ones leave, which size classes could not do.
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

  // The most that slabs may take up from now on. Of those that exceed it, the ones without a room are given
  // back now; the others stay until they, too, are empty and the capacity is set again.
  void set_capacity(std::size_t bytes);

  // Takes slabs until there are `bytes` of them, or as many as the capacity allows, and has the system back
  // them with memory now, in large pages: a first touch costs far more than what is written then. Slabs that
  // are added later are touched page by small page.
  void prepare(std::size_t bytes);

  struct Room {
    std::byte* begin = nullptr;  // null: there is none
    std::size_t bytes = 0;       // a multiple of kUnitBytes
    std::size_t slab = 0;
  };
  // Room for `bytes` (1 to kSlabBytes), not initialized. None when no hole is large enough, or when as much
  // as the capacity would be in use.
  Room allocate(std::size_t bytes);
  void free(const Room& room);
  // Frees all rooms and keeps the slabs.
  void clear();

  std::size_t bytes_in_use() const { return bytes_in_use_; }      // by rooms
  std::size_t bytes_reserved() const { return bytes_reserved_; }  // by slabs

 private:
  struct Hole {
    std::size_t begin, bytes;  // from the slab's start
  };
  struct Slab {
    base::LargeMemory<std::byte> memory;  // null: given back
    std::size_t bytes = 0;
    std::size_t largest_hole = 0;
    std::vector<Hole> holes;  // by begin; none touches the next
  };

  Room take(std::size_t slab, std::size_t bytes);
  // Null when the capacity does not leave `least_bytes`.
  Slab* add_slab(std::size_t least_bytes, base::FirstTouch first_touch);

  std::vector<Slab> slabs_;
  std::size_t capacity_bytes_ = 0;
  std::size_t bytes_in_use_ = 0;
  std::size_t bytes_reserved_ = 0;
};

}  // namespace temblor::render
