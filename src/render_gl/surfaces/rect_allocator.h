// Divides layers of a texture among rectangles whose sides are powers of two. A free rectangle is halved
// until it has the wanted size. When both halves are free again, they become the rectangle that they were.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace temblor::render_gl {

// Where a rectangle begins, in texels.
struct AtlasPlace {
  std::uint16_t x = 0, y = 0, layer = 0;
  bool operator==(const AtlasPlace&) const = default;
};

class RectAllocator {
 public:
  // A rectangle's sides as powers: 2^width x 2^height texels.
  struct Size {
    int width = 0, height = 0;
    bool operator==(const Size&) const = default;
  };
  // The smallest size that holds so many texels; sides are at least kMinSide.
  static Size fit(int width, int height);
  static constexpr int kMinSide = 8;
  static constexpr int kMaxPower = 13;

  // Identifies a rectangle until it is given back.
  using Number = std::int32_t;
  struct Rect {
    Number number;
    AtlasPlace place;
  };

  // Layers are squares of 2^layer_power texels.
  RectAllocator(int layer_power, int layers);

  // Nothing if no free rectangle is large enough.
  std::optional<Rect> allocate(Size size);
  void free(Number rect);
  // Makes everything free.
  void clear();

 private:
  static constexpr Number kNone = -1;
  // A node of the trees of halves, whose roots are the layers. Halves are numbered 2n and 2n + 1.
  struct Node {
    AtlasPlace place;
    Size size;
    Number parent = kNone, halves = kNone;
    Number before = kNone, after = kNone;  // in its list
    bool is_free = false;
  };
  Node& node(Number number) { return nodes_[static_cast<std::size_t>(number)]; }
  Number& first_free(Size size) {
    return first_free_[static_cast<std::size_t>(size.width * kMaxPower + size.height)];
  }
  Number other_half(Number number) const { return number ^ 1; }
  std::optional<Size> find_smallest_free(Size size);
  void link(Number number);
  void unlink(Number number);
  Number make_halves(Number number, bool of_width);

  int layer_power_, layers_;
  std::vector<Node> nodes_;
  std::vector<Number> unused_;  // the first numbers of pairs
  std::array<Number, kMaxPower * kMaxPower> first_free_{};
};

}  // namespace temblor::render_gl
