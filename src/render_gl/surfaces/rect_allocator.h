// Divides layers of a texture among rectangles whose sides are powers of two. A free rectangle is halved
// until it has the wanted size. Rectangles that are given back serve later ones of the same size only; when
// none is left, the owner starts again with clear().
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
  };
  // The smallest size that holds so many texels; sides are at least kMinSide.
  static Size fit(int width, int height);
  static constexpr int kMinSide = 8;
  static constexpr int kMaxPower = 13;

  // Layers are squares of 2^layer_power texels.
  RectAllocator(int layer_power, int layers);

  // Nothing if no free rectangle is large enough.
  std::optional<AtlasPlace> allocate(Size size);
  void free(Size size, AtlasPlace place) { free_list(size).push_back(place); }
  // Makes everything free.
  void clear();

 private:
  std::vector<AtlasPlace>& free_list(Size size) {
    return free_[static_cast<std::size_t>(size.width * kMaxPower + size.height)];
  }
  std::optional<Size> find_smallest_free(Size size);

  int layer_power_, layers_;
  std::array<std::vector<AtlasPlace>, kMaxPower * kMaxPower> free_;
};

}  // namespace temblor::render_gl
