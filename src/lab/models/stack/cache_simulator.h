// A first-level data cache that is simulated: it counts the lines that are missing when memory is read or
// written. In each set, the line that was not used for the longest time is replaced.
#pragma once

#include <cstdint>
#include <vector>

namespace temblor::lab {

struct CacheShape {
  std::size_t bytes, ways, line_bytes;
};

// The first Pentium's cache, and that of processors of 2023.
constexpr CacheShape kPentiumCache{8 << 10, 2, 32}, kTodaysCache{32 << 10, 8, 64};

class CacheSimulator {
 public:
  // Sizes must be multiples of each other: bytes of a set, a set of a line.
  explicit CacheSimulator(const CacheShape& shape);

  // Reads or writes `bytes` bytes: a write fetches the line too.
  void touch(std::uint64_t address, std::size_t bytes);
  std::uint64_t misses() const { return misses_; }

 private:
  struct Line {
    std::uint64_t number;
    std::uint64_t last_use = 0;  // 0: empty
  };
  void touch_line(std::uint64_t number);

  const CacheShape shape_;
  const std::size_t sets_;
  std::vector<Line> lines_;  // set by set
  std::uint64_t time_ = 0, misses_ = 0;
};

}  // namespace temblor::lab
