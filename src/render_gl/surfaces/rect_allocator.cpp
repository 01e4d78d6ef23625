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

// The number of roots is even, so that the halves begin with an even number.
void RectAllocator::clear() {
  nodes_.assign(static_cast<std::size_t>(layers_ + layers_ % 2), Node{});
  unused_.clear();
  first_free_.fill(kNone);
  for (Number layer = layers_ - 1; layer >= 0; --layer) {
    node(layer).place.layer = static_cast<std::uint16_t>(layer);
    node(layer).size = {layer_power_, layer_power_};
    link(layer);
  }
}

void RectAllocator::link(Number number) {
  Node& linked = node(number);
  Number& first = first_free(linked.size);
  linked.is_free = true;
  linked.before = kNone;
  linked.after = first;
  if (first != kNone) node(first).before = number;
  first = number;
}

void RectAllocator::unlink(Number number) {
  Node& linked = node(number);
  linked.is_free = false;
  if (linked.after != kNone) node(linked.after).before = linked.before;
  (linked.before != kNone ? node(linked.before).after : first_free(linked.size)) = linked.after;
}

RectAllocator::Number RectAllocator::make_halves(Number number, bool of_width) {
  Number first;
  if (unused_.empty()) {
    first = static_cast<Number>(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
  } else {
    first = unused_.back();
    unused_.pop_back();
  }
  Node half{.place = node(number).place, .size = node(number).size, .parent = number};
  --(of_width ? half.size.width : half.size.height);
  node(first) = half;
  std::uint16_t& moved = of_width ? half.place.x : half.place.y;
  moved = static_cast<std::uint16_t>(moved + (1 << (of_width ? half.size.width : half.size.height)));
  node(other_half(first)) = half;
  node(number).halves = first;
  return first;
}

std::optional<RectAllocator::Size> RectAllocator::find_smallest_free(Size size) {
  std::optional<Size> best;
  for (int width = size.width; width <= layer_power_; ++width)
    for (int height = size.height; height <= layer_power_; ++height)
      if (first_free({width, height}) != kNone && (!best || width + height < best->width + best->height))
        best = Size{width, height};
  return best;
}

// Halves the longer of the two sides that are still too long, so that the rest stays close to a square.
std::optional<RectAllocator::Rect> RectAllocator::allocate(Size size) {
  const std::optional<Size> found = find_smallest_free(size);
  if (!found) return std::nullopt;
  Number number = first_free(*found);
  unlink(number);
  Size left = *found;
  while (left != size) {
    const bool of_width =
        left.width > size.width && (left.width >= left.height || left.height == size.height);
    number = make_halves(number, of_width);
    left = node(number).size;
    link(other_half(number));
  }
  return Rect{number, node(number).place};
}

void RectAllocator::free(Number number) {
  while (node(number).parent != kNone && node(other_half(number)).is_free) {
    unlink(other_half(number));
    const Number parent = node(number).parent;
    unused_.push_back(node(parent).halves);
    node(parent).halves = kNone;
    number = parent;
  }
  link(number);
}

}  // namespace temblor::render_gl
