#include "lab/models/small/small_masks.h"

namespace temblor::lab {

namespace {

using Corner = SmallCorners::Corner;

// Whether the middle of a pixel is right of the side from `a` to `b`, seen along it, or on a left or top
// side.
bool is_inside(const Corner& a, const Corner& b, std::int32_t x, std::int32_t y) {
  const std::int32_t dx = b.x - a.x, dy = b.y - a.y;
  const std::int32_t side = dx * (y - a.y) - dy * (x - a.x);
  const bool is_left_or_top = dy < 0 || (dy == 0 && dx > 0);
  return side > 0 || (side == 0 && is_left_or_top);
}

std::uint32_t make_mask(const SmallCorners& corners) {
  const auto& [a, b, c] = corners;
  if ((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y) <= 0) return 0;
  std::uint32_t mask = 0;
  for (std::int32_t y = 0; y < SmallMasks::kMaxSide; ++y)
    for (std::int32_t x = 0; x < SmallMasks::kMaxSide; ++x)
      if (is_inside(a, b, x, y) && is_inside(b, c, x, y) && is_inside(c, a, x, y))
        mask |= std::uint32_t{1} << (y * SmallMasks::kMaxSide + x);
  return mask;
}

Corner make_corner(std::size_t number) {
  constexpr std::size_t kPlaces = SmallMasks::kMaxSide + 1;
  return {static_cast<std::int32_t>(number % kPlaces), static_cast<std::int32_t>(number / kPlaces)};
}

}  // namespace

SmallMasks::SmallMasks() {
  masks_.reserve(kTriangles);
  for (std::size_t i = 0; i < kTriangles; ++i) masks_.push_back(make_mask(find_corners(i)));
}

SmallCorners SmallMasks::find_corners(std::size_t number) {
  return {make_corner(number / kCorners / kCorners), make_corner(number / kCorners % kCorners),
          make_corner(number % kCorners)};
}

}  // namespace temblor::lab
