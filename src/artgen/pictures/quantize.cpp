#include <algorithm>
#include <array>
#include <cmath>

#include "artgen/pictures/canvas.h"

namespace temblor::artgen::pictures {
namespace {

// Ordered dithering with Bayer's 4 x 4 matrix, from -0.5 to 0.5. Unlike error diffusion, it leaves flat areas
// regular.
double dither_at(std::int32_t x, std::int32_t y) {
  constexpr std::array<std::array<int, 4>, 4> kOrder = {
      {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}}};
  return (kOrder[static_cast<std::size_t>(y & 3)][static_cast<std::size_t>(x & 3)] + 0.5) / 16 - 0.5;
}

// `ramp`: the only ramp that is allowed; -1: any that is not excluded.
bool is_allowed(std::size_t index, std::int32_t ramp, const QuantizeOptions& options) {
  const auto own = static_cast<std::int32_t>(index / kRampColors);
  if (ramp >= 0) return own == ramp;
  return std::none_of(options.without.begin(), options.without.end(),
                      [&](Ramp without) { return static_cast<std::int32_t>(without) == own; });
}

// The nearest palette color by weighted squared distance. Green has the largest weight, because the eye is
// most sensitive to it.
std::uint8_t find_nearest_color(const formats::Palette& palette, const Color& color, std::int32_t ramp,
                                const QuantizeOptions& options) {
  std::size_t best = 0;
  double least = 1e9;
  for (std::size_t i = 0; i < kTransparent; ++i) {
    if (!is_allowed(i, ramp, options)) continue;
    const Color out = (Color{palette[i].r / 255.0, palette[i].g / 255.0, palette[i].b / 255.0} - color) *
                      Color{0.55, 0.77, 0.33};
    if (const double distance = glm::dot(out, out); distance < least) {
      least = distance;
      best = i;
    }
  }
  return static_cast<std::uint8_t>(best);
}

std::uint32_t to_byte(double value) {
  return static_cast<std::uint32_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255));
}

}  // namespace

std::vector<std::uint8_t> quantize(const Canvas& canvas, const QuantizeOptions& options) {
  // About the difference between two colors of a ramp.
  constexpr double kStep = 0.07;
  const formats::Palette palette = make_palette();
  std::vector<std::uint8_t> pixels;
  for (std::int32_t y = 0; y < canvas.height(); ++y)
    for (std::int32_t x = 0; x < canvas.width(); ++x) {
      const Canvas::Sample sample = canvas.pixel(x, y);
      const Color dithered = sample.color + Color{kStep * options.dither * dither_at(x, y)};
      pixels.push_back(sample.cover < 0.5 ? kTransparent
                                          : find_nearest_color(palette, dithered, sample.ramp, options));
    }
  return pixels;
}

std::vector<std::uint32_t> to_true_color(const Canvas& canvas) {
  std::vector<std::uint32_t> pixels;
  for (std::int32_t y = 0; y < canvas.height(); ++y)
    for (std::int32_t x = 0; x < canvas.width(); ++x) {
      const Canvas::Sample sample = canvas.pixel(x, y);
      pixels.push_back(to_byte(sample.cover) << 24 | to_byte(sample.color.r) << 16 |
                       to_byte(sample.color.g) << 8 | to_byte(sample.color.b));
    }
  return pixels;
}

}  // namespace temblor::artgen::pictures
