#include "host/menus/make_thumbnail.h"

#include <algorithm>

namespace temblor::host {

formats::Picture make_thumbnail(std::span<const std::uint32_t> rgb, int width, int height,
                                const formats::NearestColor& colors, int factor) {
  const int small_width = factor * kThumbnailWidth, small_height = factor * kThumbnailHeight;
  formats::Picture picture{
      static_cast<std::uint32_t>(small_width), static_cast<std::uint32_t>(small_height), {}};
  picture.pixels.reserve(static_cast<std::size_t>(small_width) * static_cast<std::size_t>(small_height));
  for (int y = 0; y < small_height; ++y) {
    const int top = y * height / small_height, bottom = std::max((y + 1) * height / small_height, top + 1);
    for (int x = 0; x < small_width; ++x) {
      const int left = x * width / small_width, right = std::max((x + 1) * width / small_width, left + 1);
      std::uint64_t red = 0, green = 0, blue = 0;
      for (int row = top; row < bottom; ++row)
        for (int column = left; column < right; ++column) {
          const std::uint32_t pixel = rgb[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                                          static_cast<std::size_t>(column)];
          red += pixel >> 16 & 255;
          green += pixel >> 8 & 255;
          blue += pixel & 255;
        }
      const auto count = static_cast<std::uint64_t>(bottom - top) * static_cast<std::uint64_t>(right - left);
      picture.pixels.push_back(
          colors.find({static_cast<std::uint8_t>(red / count), static_cast<std::uint8_t>(green / count),
                       static_cast<std::uint8_t>(blue / count)}));
    }
  }
  return picture;
}

}  // namespace temblor::host
