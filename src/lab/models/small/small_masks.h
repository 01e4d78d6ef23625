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

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace temblor::lab {

// Corners of a small triangle in pixels from the top left corner of its box, clockwise; 0 to
// SmallMasks::kMaxSide each.
struct SmallCorners {
  struct Corner {
    std::int32_t x, y;
  };
  Corner a, b, c;
};

class SmallMasks {
 public:
  static constexpr std::int32_t kMaxSide = 5;

  SmallMasks();
  // `number`: from number(), for a triangle in clockwise order. 0: the triangle has no pixel.
  std::uint32_t find(std::size_t number) const { return masks_[number]; }
  std::size_t size_bytes() const { return masks_.size() * sizeof(masks_[0]); }

  // Below kTriangles.
  static constexpr std::size_t number(const SmallCorners& corners) {
    return (number(corners.a) * kCorners + number(corners.b)) * kCorners + number(corners.c);
  }
  // The inverse of number().
  static SmallCorners find_corners(std::size_t number);
  static constexpr std::size_t kCorners = (kMaxSide + 1) * (kMaxSide + 1);
  static constexpr std::size_t kTriangles = kCorners * kCorners * kCorners;

 private:
  static constexpr std::size_t number(const SmallCorners::Corner& corner) {
    return static_cast<std::size_t>(corner.y * (kMaxSide + 1) + corner.x);
  }

  std::vector<std::uint32_t> masks_;  // by number()
};

}  // namespace temblor::lab
