#include <algorithm>
#include <array>
#include <cmath>

#include "artgen/pictures/canvas.h"

namespace temblor::artgen::pictures {
namespace {

// Ordered, so that flat places stay calm: -0.5 to 0.5.
double dither_at(std::int32_t x, std::int32_t y) {
  constexpr std::array<std::array<int, 4>, 4> kOrder = {
      {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}}};
  return (kOrder[static_cast<std::size_t>(y & 3)][static_cast<std::size_t>(x & 3)] + 0.5) / 16 - 0.5;
}

bool may_use(std::size_t index, std::int32_t ramp, const Quantizing& how) {
  const auto own = static_cast<std::int32_t>(index / kRampColors);
  if (ramp >= 0) return own == ramp;
  return std::none_of(how.without.begin(), how.without.end(),
                      [&](Ramp without) { return static_cast<std::int32_t>(without) == own; });
}

// Green counts most, as for the eye.
std::uint8_t nearest(const formats::Palette& palette, const Color& color, std::int32_t ramp,
                     const Quantizing& how) {
  std::size_t best = 0;
  double least = 1e9;
  for (std::size_t i = 0; i < kTransparent; ++i) {
    if (!may_use(i, ramp, how)) continue;
    const Color out = (Color{palette[i].r / 255.0, palette[i].g / 255.0, palette[i].b / 255.0} - color) *
                      Color{0.55, 0.77, 0.33};
    if (const double distance = glm::dot(out, out); distance < least) {
      least = distance;
      best = i;
    }
  }
  return static_cast<std::uint8_t>(best);
}

std::uint32_t byte_of(double value) {
  return static_cast<std::uint32_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255));
}

}  // namespace

std::vector<std::uint8_t> quantize(const Canvas& canvas, const Quantizing& how) {
  constexpr double kStep = 0.07;  // between two colors of a ramp, about
  const formats::Palette palette = make_palette();
  std::vector<std::uint8_t> pixels;
  for (std::int32_t y = 0; y < canvas.height(); ++y)
    for (std::int32_t x = 0; x < canvas.width(); ++x) {
      const Canvas::Sample sample = canvas.pixel(x, y);
      const Color dithered = sample.color + Color{kStep * how.dither * dither_at(x, y)};
      pixels.push_back(sample.cover < 0.5 ? kTransparent : nearest(palette, dithered, sample.ramp, how));
    }
  return pixels;
}

std::vector<std::uint32_t> true_color(const Canvas& canvas) {
  std::vector<std::uint32_t> pixels;
  for (std::int32_t y = 0; y < canvas.height(); ++y)
    for (std::int32_t x = 0; x < canvas.width(); ++x) {
      const Canvas::Sample sample = canvas.pixel(x, y);
      pixels.push_back(byte_of(sample.cover) << 24 | byte_of(sample.color.r) << 16 |
                       byte_of(sample.color.g) << 8 | byte_of(sample.color.b));
    }
  return pixels;
}

}  // namespace temblor::artgen::pictures
