// The distinct shapes of small triangles: masks that only differ in their place are one shape.
//
//   two triangles    . # .    . . .         their shape    #
//                    # # .    . # .                      # #
//                    . . .    # # .
//
// All triangles up to 5x5 pixels have 346 shapes.
#pragma once

#include <cstdint>
#include <vector>

#include "lab/models/small/small_masks.h"

namespace temblor::lab {

// The shape of a triangle, and the place of the shape's top left pixel in the triangle's box.
struct PlacedShape {
  std::uint16_t number;  // kNoShape: the triangle has no pixel
  std::uint8_t column, row;
};
constexpr std::uint16_t kNoShape = 0xffff;

class SmallShapes {
 public:
  explicit SmallShapes(const SmallMasks& masks);
  // By SmallMasks::number().
  PlacedShape find(std::size_t number) const { return placed_[number]; }
  // By number. The leftmost column and the topmost row of each have a pixel.
  const std::vector<std::uint32_t>& masks() const { return masks_; }
  std::size_t size_bytes() const { return placed_.size() * sizeof(placed_[0]); }

 private:
  std::vector<PlacedShape> placed_;  // by SmallMasks::number()
  std::vector<std::uint32_t> masks_;
};

}  // namespace temblor::lab
