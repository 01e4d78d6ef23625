#include "lab/models/small_masks.h"

namespace temblor::lab {

namespace {

using Corner = SmallMasks::Corner;

// Whether the middle of a pixel is right of the side from `a` to `b`, seen along it, or on a left or top
// side.
bool is_inside(const Corner& a, const Corner& b, std::int32_t x, std::int32_t y) {
  const std::int32_t dx = b.x - a.x, dy = b.y - a.y;
  const std::int32_t side = dx * (y - a.y) - dy * (x - a.x);
  const bool is_left_or_top = dy < 0 || (dy == 0 && dx > 0);
  return side > 0 || (side == 0 && is_left_or_top);
}

std::uint32_t make_mask(const Corner& a, const Corner& b, const Corner& c) {
  if ((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y) <= 0) return 0;
  std::uint32_t mask = 0;
  for (std::int32_t y = 0; y < SmallMasks::kMaxSide; ++y)
    for (std::int32_t x = 0; x < SmallMasks::kMaxSide; ++x)
      if (is_inside(a, b, x, y) && is_inside(b, c, x, y) && is_inside(c, a, x, y))
        mask |= std::uint32_t{1} << (y * SmallMasks::kMaxSide + x);
  return mask;
}

}  // namespace

SmallMasks::SmallMasks() {
  masks_.reserve(static_cast<std::size_t>(kCorners) * kCorners * kCorners);
  const auto corner = [](std::int32_t number) {
    return Corner{number % (kMaxSide + 1), number / (kMaxSide + 1)};
  };
  for (std::int32_t a = 0; a < kCorners; ++a)
    for (std::int32_t b = 0; b < kCorners; ++b)
      for (std::int32_t c = 0; c < kCorners; ++c)
        masks_.push_back(make_mask(corner(a), corner(b), corner(c)));
}

}  // namespace temblor::lab
