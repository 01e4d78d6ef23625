#include "render/mark_picture.h"

#include <algorithm>
#include <bit>

#include "base/check.h"
#include "base/hash.h"

namespace temblor::render {

namespace {

std::uint64_t hash_image(const formats::Image& image) {
  std::uint64_t hash = std::uint64_t{image.width} << 32 | image.height;
  for (const std::uint32_t pixel : image.pixels) hash = base::hash_with(hash, pixel);
  return hash;
}

std::uint8_t multiplied(std::uint32_t channel, std::uint32_t opacity) {
  return static_cast<std::uint8_t>((channel * opacity + 127) / 255);
}

// The empty texels before an image of `size` texels in the square.
int compute_margin(int side, int size) {
  return (side - size) / 2;
}

float compute_middle(int side, std::uint32_t size) {
  const auto texels = static_cast<int>(size);
  const float middle = static_cast<float>(compute_margin(side, texels)) + static_cast<float>(texels) / 2;
  return middle / static_cast<float>(side);
}

}  // namespace

MarkPicture::Level::Level(int texels_of_side)
    : side(texels_of_side), texels(static_cast<std::size_t>((side + 2) * (side + 2))) {}

MarkPicture::MarkPicture(const formats::Image& image)
    : longer_side_(static_cast<int>(std::max(image.width, image.height))), hash_(hash_image(image)) {
  CHECK(image.width >= 1 && image.height >= 1 && image.width <= kMaxSide && image.height <= kMaxSide);
  levels_.push_back(make_first(image));
  middle_x_ = compute_middle(levels_[0].side, image.width);
  middle_y_ = compute_middle(levels_[0].side, image.height);
  while (levels_.back().side > 1) levels_.push_back(make_smaller(levels_.back()));
}

MarkPicture::Level MarkPicture::make_first(const formats::Image& image) {
  const auto width = static_cast<int>(image.width), height = static_cast<int>(image.height);
  Level level(static_cast<int>(std::bit_ceil(std::max(image.width, image.height))));
  const int left = compute_margin(level.side, width), top = compute_margin(level.side, height);
  const std::uint32_t* pixel = image.pixels.data();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x, ++pixel) {
      const std::uint32_t opacity = *pixel >> 24;
      level.texels[level.index(left + x, top + y)] = {
          multiplied(*pixel >> 16 & 255, opacity), multiplied(*pixel >> 8 & 255, opacity),
          multiplied(*pixel & 255, opacity), static_cast<std::uint8_t>(opacity)};
    }
  return level;
}

MarkPicture::Level MarkPicture::make_smaller(const Level& level) {
  Level smaller(level.side / 2);
  for (int y = 0; y < smaller.side; ++y)
    for (int x = 0; x < smaller.side; ++x) {
      const Texel* const above = &level.texels[level.index(2 * x, 2 * y)];
      const Texel* const below = &level.texels[level.index(2 * x, 2 * y + 1)];
      const auto mean = [&](std::uint8_t Texel::*part) {
        return static_cast<std::uint8_t>(
            (above[0].*part + above[1].*part + below[0].*part + below[1].*part + 2) / 4);
      };
      smaller.texels[smaller.index(x, y)] = {mean(&Texel::r), mean(&Texel::g), mean(&Texel::b),
                                             mean(&Texel::opacity)};
    }
  return smaller;
}

PictureTexel MarkPicture::at(int number, float u, float v) const {
  const Level& level = levels_[static_cast<std::size_t>(number)];
  // In texels, from the center of the border texel before the first one. The longer side of the image is a
  // part of the square's side.
  const auto side = static_cast<float>(level.side);
  const float scale = side * static_cast<float>(longer_side_) / static_cast<float>(2 * levels_[0].side);
  const float x = u * scale + side * middle_x_ + 0.5f, y = v * scale + side * middle_y_ + 0.5f;
  if (!(x >= 0 && y >= 0 && x < side + 1 && y < side + 1)) return {};
  const int column = static_cast<int>(x), row = static_cast<int>(y);
  const float s = x - static_cast<float>(column), t = y - static_cast<float>(row);
  const Texel* const above = &level.texels[level.index(column - 1, row - 1)];
  const Texel* const below = &level.texels[level.index(column - 1, row)];
  const auto mean = [&](std::uint8_t Texel::*part) {
    const auto value = [&](const Texel& texel) { return static_cast<float>(texel.*part); };
    const float top = value(above[0]) + (value(above[1]) - value(above[0])) * s;
    const float bottom = value(below[0]) + (value(below[1]) - value(below[0])) * s;
    return top + (bottom - top) * t;
  };
  const float opacity = mean(&Texel::opacity);
  if (!(opacity > 0)) return {};
  const auto channel = [&](std::uint8_t Texel::*part) {
    return static_cast<std::uint8_t>(std::min(mean(part) / opacity, 1.0f) * 255.0f + 0.5f);
  };
  return {{channel(&Texel::r), channel(&Texel::g), channel(&Texel::b)},
          static_cast<int>(opacity / 255.0f * 256.0f + 0.5f)};
}

}  // namespace temblor::render
