#include "formats/images/resample.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace temblor::formats {
namespace {

// The pixels that one pixel of the result covers along an axis: those from `first` on, with their shares.
struct Cover {
  std::uint32_t first;
  std::vector<float> shares;
};

// In units of 1/to of a source pixel, so that all borders are whole numbers.
std::vector<Cover> cover_axis(std::uint32_t from, std::uint32_t to) {
  std::vector<Cover> covers;
  covers.reserve(to);
  for (std::uint64_t i = 0; i < to; ++i) {
    const std::uint64_t begin = i * from, end = begin + from;
    Cover cover{static_cast<std::uint32_t>(begin / to), {}};
    for (std::uint64_t pixel = cover.first; pixel * to < end; ++pixel) {
      const std::uint64_t covered = std::min(end, (pixel + 1) * to) - std::max(begin, pixel * to);
      cover.shares.push_back(static_cast<float>(covered) / static_cast<float>(from));
    }
    covers.push_back(std::move(cover));
  }
  return covers;
}

// Alpha, and linear light times alpha.
struct Sum {
  float alpha = 0, red = 0, green = 0, blue = 0;
  void add(const Sum& other, float share) {
    alpha += share * other.alpha;
    red += share * other.red;
    green += share * other.green;
    blue += share * other.blue;
  }
};

Sum to_sum(std::uint32_t pixel) {
  const auto alpha = static_cast<float>(pixel >> 24);
  const auto light = [&](unsigned shift) {
    const auto channel = static_cast<float>(pixel >> shift & 0xff);
    return channel * channel * alpha;
  };
  return {alpha, light(16), light(8), light(0)};
}

std::uint32_t to_pixel(const Sum& sum) {
  if (sum.alpha <= 0) return 0;
  const auto channel = [&](float light) {
    return static_cast<std::uint32_t>(std::min(255.0f, std::sqrt(light / sum.alpha) + 0.5f));
  };
  const auto alpha = static_cast<std::uint32_t>(std::min(255.0f, sum.alpha + 0.5f));
  return alpha << 24 | channel(sum.red) << 16 | channel(sum.green) << 8 | channel(sum.blue);
}

}  // namespace

Image resample(Image image, std::uint32_t width, std::uint32_t height) {
  if (image.width == width && image.height == height) return image;
  const std::vector<Cover> columns = cover_axis(image.width, width), rows = cover_axis(image.height, height);
  Image result{width, height, {}};
  result.pixels.reserve(std::size_t{width} * height);
  std::vector<Sum> row(image.width);  // of the source, its rows already joined
  for (const Cover& cover : rows) {
    std::ranges::fill(row, Sum{});
    for (std::size_t y = 0; y < cover.shares.size(); ++y)
      for (std::size_t x = 0; x < image.width; ++x)
        row[x].add(to_sum(image.pixels[(cover.first + y) * image.width + x]), cover.shares[y]);
    for (const Cover& column : columns) {
      Sum sum;
      for (std::size_t x = 0; x < column.shares.size(); ++x) sum.add(row[column.first + x], column.shares[x]);
      result.pixels.push_back(to_pixel(sum));
    }
  }
  return result;
}

}  // namespace temblor::formats
