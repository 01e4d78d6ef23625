// The pixels of every triangle whose corners lie at whole pixels, at most kMaxSide pixels apart, as bits:
// precalculated once.
//
//   corner numbers         bits of a mask
//    0  1  2  3  4  5       0  1  2  3  4
//    6  7  8  9 10 11       5  6  7  8  9
//   ...                    ...
//
// A pixel on a left or top edge is inside, one on a right or bottom edge is outside.
#pragma once

#include <cstdint>
#include <vector>

namespace temblor::lab {

class SmallMasks {
 public:
  static constexpr std::int32_t kMaxSide = 5;

  SmallMasks();
  // Corners in pixels from the top left corner of the triangle's box, clockwise; 0 to kMaxSide each.
  struct Corner {
    std::int32_t x, y;
  };
  std::uint32_t find(const Corner& a, const Corner& b, const Corner& c) const {
    return masks_[static_cast<std::size_t>((number(a) * kCorners + number(b)) * kCorners + number(c))];
  }
  std::size_t size_bytes() const { return masks_.size() * sizeof(masks_[0]); }

 private:
  static constexpr std::int32_t kCorners = (kMaxSide + 1) * (kMaxSide + 1);
  static std::int32_t number(const Corner& corner) { return corner.y * (kMaxSide + 1) + corner.x; }

  std::vector<std::uint32_t> masks_;  // by the numbers of three corners
};

}  // namespace temblor::lab
