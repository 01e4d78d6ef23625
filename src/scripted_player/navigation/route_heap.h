// The priority queue of a route search: a heap with four children per entry (Johnson, "Priority queues with
// update and finding minimum spanning trees", 1975), which needs half as many levels as a binary one.
//
// An entry is one number: the bits of its cost above the place. Costs are not negative, so their bits are in
// the order of their values, and one comparison orders entries by cost and then by place.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

namespace temblor::player {

class RouteHeap {
 public:
  struct Entry {
    float cost;
    std::uint32_t place;
  };

  bool is_empty() const { return keys_.empty(); }
  void clear() { keys_.clear(); }
  // `cost` is at least 0.
  void push(float cost, std::uint32_t place) {
    const std::uint64_t key = std::uint64_t{std::bit_cast<std::uint32_t>(cost)} << 32 | place;
    std::size_t at = keys_.size();
    keys_.push_back(key);
    for (; at > 0 && keys_[(at - 1) / 4] > key; at = (at - 1) / 4) keys_[at] = keys_[(at - 1) / 4];
    keys_[at] = key;
  }
  // Removes the entry with the lowest cost, and among those the lowest place. The heap must not be empty.
  Entry pop() {
    const std::uint64_t lowest = keys_.front(), moved = keys_.back();
    keys_.pop_back();
    const std::size_t size = keys_.size();
    std::size_t at = 0;
    for (std::size_t child = 1; child < size; child = 4 * at + 1) {
      const std::size_t end = std::min(child + 4, size);
      for (std::size_t other = child + 1; other < end; ++other)
        if (keys_[other] < keys_[child]) child = other;
      if (keys_[child] >= moved) break;
      keys_[at] = keys_[child];
      at = child;
    }
    if (size > 0) keys_[at] = moved;
    return {std::bit_cast<float>(static_cast<std::uint32_t>(lowest >> 32)),
            static_cast<std::uint32_t>(lowest)};
  }

 private:
  std::vector<std::uint64_t> keys_;
};

}  // namespace temblor::player
