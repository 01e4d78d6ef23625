#include "lab/models/small/small_shapes.h"

#include <map>

namespace temblor::lab {

namespace {

constexpr std::uint32_t kTopRow = 0b11111, kLeftColumn = 0b00001'00001'00001'00001'00001;

// Moves the pixels of `io_mask` to the top left. Returns where they were, without a number.
PlacedShape move_to_corner(std::uint32_t& io_mask) {
  PlacedShape placed{kNoShape, 0, 0};
  if (io_mask == 0) return placed;
  for (; (io_mask & kTopRow) == 0; ++placed.row) io_mask >>= SmallMasks::kMaxSide;
  for (; (io_mask & kLeftColumn) == 0; ++placed.column) io_mask >>= 1;
  return placed;
}

}  // namespace

SmallShapes::SmallShapes(const SmallMasks& masks) {
  std::map<std::uint32_t, std::uint16_t> numbers;
  placed_.reserve(SmallMasks::kTriangles);
  for (std::size_t i = 0; i < SmallMasks::kTriangles; ++i) {
    std::uint32_t mask = masks.find(i);
    PlacedShape placed = move_to_corner(mask);
    if (mask != 0) {
      const auto [found, is_new] = numbers.emplace(mask, static_cast<std::uint16_t>(masks_.size()));
      if (is_new) masks_.push_back(mask);
      placed.number = found->second;
    }
    placed_.push_back(placed);
  }
}

}  // namespace temblor::lab
