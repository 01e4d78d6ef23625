#include "render_gl/surfaces/rect_allocator.h"

#include <algorithm>
#include <bit>

#include "base/check.h"

namespace temblor::render_gl {

RectAllocator::Size RectAllocator::fit(int width, int height) {
  const auto power = [](int texels) {
    return static_cast<int>(std::bit_width(static_cast<unsigned>(std::max(texels, kMinSide)) - 1));
  };
  return {power(width), power(height)};
}

RectAllocator::RectAllocator(int layer_power, int layers) : layer_power_(layer_power), layers_(layers) {
  CHECK(layer_power < kMaxPower, "layers of 2^{} texels", layer_power);
  clear();
}

void RectAllocator::clear() {
  for (std::vector<AtlasPlace>& places : free_) places.clear();
  for (int layer = layers_ - 1; layer >= 0; --layer)
    free({layer_power_, layer_power_}, {0, 0, static_cast<std::uint16_t>(layer)});
}

std::optional<RectAllocator::Size> RectAllocator::find_smallest_free(Size size) {
  std::optional<Size> best;
  for (int width = size.width; width <= layer_power_; ++width)
    for (int height = size.height; height <= layer_power_; ++height)
      if (!free_list({width, height}).empty() && (!best || width + height < best->width + best->height))
        best = Size{width, height};
  return best;
}

// Halves the longer of the two sides that are still too long, so that the rest stays close to a square.
std::optional<AtlasPlace> RectAllocator::allocate(Size size) {
  const std::optional<Size> found = find_smallest_free(size);
  if (!found) return std::nullopt;
  Size left = *found;
  const AtlasPlace place = free_list(left).back();
  free_list(left).pop_back();
  while (left.width > size.width || left.height > size.height) {
    AtlasPlace other = place;
    if (left.width > size.width && (left.width >= left.height || left.height == size.height)) {
      --left.width;
      other.x = static_cast<std::uint16_t>(place.x + (1 << left.width));
    } else {
      --left.height;
      other.y = static_cast<std::uint16_t>(place.y + (1 << left.height));
    }
    free(left, other);
  }
  return place;
}

}  // namespace temblor::render_gl
