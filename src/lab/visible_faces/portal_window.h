// The part of the screen through which a leaf can be seen: an octagon around the pixels that a chain of
// portals leaves open, or a rectangle.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace temblor::lab {

// Whole numbers `first` to `last`; empty if first > last.
struct Interval {
  std::int32_t first, last;

  bool is_empty() const { return first > last; }
  bool contains(const Interval& other) const { return first <= other.first && other.last <= last; }
  void intersect(const Interval& other) {
    first = std::max(first, other.first);
    last = std::min(last, other.last);
  }
  void join(const Interval& other) {
    first = std::min(first, other.first);
    last = std::max(last, other.last);
  }
};

// The pixels whose x, y, x + y, and x - y lie in the four intervals.
struct PortalWindow {
  Interval x, y, sum, difference;

  static PortalWindow empty() {
    // Beyond any pixel, and small enough that tighten() can add four of them.
    constexpr Interval kEmpty{1 << 28, -(1 << 28)};
    return {kEmpty, kEmpty, kEmpty, kEmpty};
  }
  static PortalWindow whole(int width, int height) {
    return {{0, width - 1}, {0, height - 1}, {0, width + height - 2}, {1 - height, width - 1}};
  }

  // After tighten().
  bool is_empty() const { return x.is_empty() || y.is_empty() || sum.is_empty() || difference.is_empty(); }
  bool contains(const PortalWindow& other) const {
    return x.contains(other.x) && y.contains(other.y) && sum.contains(other.sum) &&
           difference.contains(other.difference);
  }
  void intersect(const PortalWindow& other) {
    x.intersect(other.x);
    y.intersect(other.y);
    sum.intersect(other.sum);
    difference.intersect(other.difference);
  }
  // The smallest window of this kind around both.
  void join(const PortalWindow& other) {
    x.join(other.x);
    y.join(other.y);
    sum.join(other.sum);
    difference.join(other.difference);
  }
  // Shrinks each interval to what the others leave possible.
  void tighten() {
    sum.intersect({x.first + y.first, x.last + y.last});
    difference.intersect({x.first - y.last, x.last - y.first});
    // Halves are rounded inward, because pixels are whole.
    x.intersect({(sum.first + difference.first + 1) >> 1, (sum.last + difference.last) >> 1});
    y.intersect({(sum.first - difference.last + 1) >> 1, (sum.last - difference.first) >> 1});
  }
};

}  // namespace temblor::lab
