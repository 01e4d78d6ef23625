#include "render/spans/skybox.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/check.h"
#include "render/spans/sky_spans.h"

namespace temblor::render {

namespace {

using Sides = std::array<formats::Image, 6>;

// The direction of each side's center, right edge, and upper edge, in the order of Skybox and SkyboxSpans.
struct SideAxes {
  math::Vec3d forward, right, up;
};
const std::array<SideAxes, 6>& side_axes() {
  static const std::array<SideAxes, 6> axes = {{{{1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
                                                {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
                                                {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                                {{0, -1, 0}, {-1, 0, 0}, {0, 0, 1}},
                                                {{0, 0, 1}, {0, -1, 0}, {-1, 0, 0}},
                                                {{0, 0, -1}, {0, -1, 0}, {1, 0, 0}}}};
  return axes;
}

std::uint32_t mean_of_two(std::uint32_t a, std::uint32_t b, double share_of_b) {
  return blend_rgb(b, a, static_cast<int>(std::lround(share_of_b * kOpaque256)));
}

// The picture at (u, v), 0 to 1 across it from the upper left corner, interpolated.
std::uint32_t sample(const formats::Image& image, double u, double v) {
  const auto along = [](double place, std::uint32_t size) {
    return std::clamp(place * size - 0.5, 0.0, static_cast<double>(size - 1));
  };
  const double x = along(u, image.width), y = along(v, image.height);
  const auto left = static_cast<std::uint32_t>(x), top = static_cast<std::uint32_t>(y);
  const std::uint32_t right = std::min(left + 1, image.width - 1);
  const std::uint32_t bottom = std::min(top + 1, image.height - 1);
  const auto texel = [&](std::uint32_t column, std::uint32_t row) {
    return image.pixels[std::size_t{row} * image.width + column];
  };
  return mean_of_two(mean_of_two(texel(left, top), texel(right, top), x - left),
                     mean_of_two(texel(left, bottom), texel(right, bottom), x - left), y - top);
}

// The color along a ray just beyond a side's edge: it belongs to the side whose axis is nearest to the ray.
std::uint32_t sample_beyond(const Sides& sides, const math::Vec3d& ray, std::uint32_t empty_rgb) {
  std::size_t nearest = 0;
  for (std::size_t side = 1; side < sides.size(); ++side)
    if (glm::dot(ray, side_axes()[side].forward) > glm::dot(ray, side_axes()[nearest].forward))
      nearest = side;
  if (sides[nearest].pixels.empty()) return empty_rgb;
  const SideAxes& axes = side_axes()[nearest];
  const double along = glm::dot(ray, axes.forward);
  return sample(sides[nearest], (1 + glm::dot(ray, axes.right) / along) / 2,
                (1 - glm::dot(ray, axes.up) / along) / 2);
}

std::int32_t common_size(const Sides& sides) {
  std::uint32_t size = 1;
  for (const formats::Image& image : sides) size = std::max({size, image.width, image.height});
  return static_cast<std::int32_t>(std::min<std::uint32_t>(size, kMaxSkyboxTexels));
}

std::uint32_t mean_of_three(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  std::uint32_t out = 0xff000000u;
  for (int shift = 0; shift < 24; shift += 8)
    out |= ((a >> shift & 255) + (b >> shift & 255) + (c >> shift & 255) + 1) / 3 << shift;
  return out;
}

// Three sides meet at a corner of the cube. Each gets the mean of the three, so that they agree.
void fill_corners(std::int32_t size, std::uint32_t* io_side) {
  const std::int32_t row = size + 2;
  for (const std::int32_t y : {0, size + 1})
    for (const std::int32_t x : {0, size + 1}) {
      const std::int32_t inner_x = std::clamp(x, 1, size), inner_y = std::clamp(y, 1, size);
      io_side[y * row + x] = mean_of_three(io_side[inner_y * row + inner_x], io_side[inner_y * row + x],
                                           io_side[y * row + inner_x]);
    }
}

// Makes one side with its border, row by row. The border has the neighbor's texels across the edge: from
// either side, the color exactly on the edge is the mean of the same two texels.
void make_side(const Sides& sides, std::size_t side, std::int32_t size, std::uint32_t empty_rgb,
               std::uint32_t* out_side) {
  constexpr double kJustBeyond = 1 + 1e-9;
  const SideAxes& axes = side_axes()[side];
  const formats::Image& image = sides[side];
  std::uint32_t* out = out_side;
  for (std::int32_t row = 0; row < size + 2; ++row)
    for (std::int32_t column = 0; column < size + 2; ++column) {
      const double u = (column - 0.5) / size, v = (row - 0.5) / size;
      if (column >= 1 && row >= 1 && column <= size && row <= size) {
        *out++ = image.pixels.empty() ? empty_rgb : sample(image, u, v);
        continue;
      }
      const double s = std::clamp(2 * u - 1, -kJustBeyond, kJustBeyond);
      const double t = std::clamp(1 - 2 * v, -kJustBeyond, kJustBeyond);
      *out++ = sample_beyond(sides, axes.forward + axes.right * s + axes.up * t, empty_rgb);
    }
  fill_corners(size, out_side);
}

}  // namespace

void PreparedSkybox::update(const Skybox& skybox, const Fog& fog, const ColorTables& tables,
                            PixelFormat format) {
  CHECK(skybox.identity != nullptr, "a skybox without an identity");
  const Made made{skybox.identity, format, fog.density > 0 ? to_rgb(to_bytes(fog.color)) : 0xff000000u};
  if (made == made_) return;
  made_ = made;
  ++version_;
  size_ = common_size(skybox.sides);
  const std::size_t side_texels =
      (static_cast<std::size_t>(size_) + 2) * (static_cast<std::size_t>(size_) + 2);
  rgb_.resize(side_texels * skybox.sides.size());
  for (std::size_t side = 0; side < skybox.sides.size(); ++side)
    make_side(skybox.sides, side, size_, made.empty_rgb, rgb_.data() + side * side_texels);
  indexed_.clear();
  if (format == PixelFormat::kRgb) return;
  indexed_.resize(rgb_.size() + kTexelPadding);
  // Sky is not lit, so full-bright palette entries are allowed.
  for (std::size_t i = 0; i < rgb_.size(); ++i)
    indexed_[i] = tables.match({static_cast<std::uint8_t>(rgb_[i] >> 16),
                                static_cast<std::uint8_t>(rgb_[i] >> 8), static_cast<std::uint8_t>(rgb_[i])},
                               true);
  rgb_.clear();
}

SkyboxSpans PreparedSkybox::spans(const ViewFrame& view) const {
  SkyboxSpans spans{};
  set_rays(sky_rays(view), spans);
  spans.texels = indexed_.empty() ? static_cast<const void*>(rgb_.data()) : indexed_.data();
  spans.size = size_;
  return spans;
}

}  // namespace temblor::render
