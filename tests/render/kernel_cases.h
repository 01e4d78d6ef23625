// Inputs of span kernel tests: textures with guarded ends, spans anywhere in a small picture, and planes that
// map the picture to the texture. Also the error bounds of coordinates computed in float.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "render/spans/span_kernels.h"
#include "support/random.h"

namespace temblor::test {

// Odd, so that rows start at any alignment; spans of up to 300 pixels fit.
constexpr int kCanvasWidth = 331, kCanvasRows = 5;

// A picture in a buffer of exactly its size, so that the address sanitizer sees writes past its end.
template <typename Texel>
struct Canvas {
  static constexpr Texel kUntouched = static_cast<Texel>(0xa5a5a5a5u);
  static constexpr float kUntouchedDepth = -12345.0f;
  std::vector<Texel> pixels = std::vector<Texel>(kCanvasWidth * kCanvasRows, kUntouched);
  std::vector<float> depth = std::vector<float>(kCanvasWidth * kCanvasRows, kUntouchedDepth);

  render::KernelTarget target(bool with_depth = true) {
    return {pixels.data(), with_depth ? depth.data() : nullptr, kCanvasWidth};
  }
  static std::size_t position(const render::Span& span, int i) {
    return std::size_t{span.y} * kCanvasWidth + span.x + static_cast<std::size_t>(i);
  }
  // Compares bit for bit.
  bool operator==(const Canvas& other) const {
    return pixels == other.pixels &&
           std::equal(depth.begin(), depth.end(), other.depth.begin(), [](float a, float b) {
             return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
           });
  }
};

// value(column, row) for every texel, followed by the padding that kernels may read.
template <typename Texel, typename Value>
std::vector<Texel> make_texels(int width, int height, Value value) {
  std::vector<Texel> texels;
  texels.reserve(static_cast<std::size_t>(width * height) + render::kTexelPadding / sizeof(Texel));
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) texels.push_back(static_cast<Texel>(value(column, row)));
  texels.insert(texels.end(), render::kTexelPadding / sizeof(Texel), static_cast<Texel>(0xeeeeeeeeu));
  return texels;
}
template <typename Texel>
std::vector<Texel> make_noise(int width, int height, Random& random) {
  return make_texels<Texel>(width, height, [&](int, int) { return random.bits(); });
}
// A texel that encodes its own position.
inline std::uint32_t texel_name(int column, int row) {
  return static_cast<std::uint32_t>(row) << 16 | static_cast<std::uint32_t>(column);
}

// One span in each row, of 1 to 300 pixels.
inline std::vector<render::Span> random_spans(Random& random) {
  std::vector<render::Span> spans;
  for (int row = 0; row < kCanvasRows; ++row) {
    const std::size_t count = 1 + random.below(random.chance(0.5) ? 40 : 300);
    const std::size_t x = random.below(kCanvasWidth - count + 1);
    spans.push_back(
        {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(row), static_cast<std::uint16_t>(count)});
  }
  return spans;
}

// Values at the canvas's upper left, upper right, and lower left corner.
using CornerValues = std::array<double, 3>;

inline render::KernelPlane plane_through(const CornerValues& values) {
  return {values[0], (values[1] - values[0]) / kCanvasWidth, (values[2] - values[0]) / kCanvasRows};
}
inline double value_at(const render::KernelPlane& plane, double x, double y) {
  return plane.at_origin + plane.dx * x + plane.dy * y;
}

// 1/z of a plane between 4 and 4096 units away at the corners, and in front of the eye on the whole canvas.
// If it `may_vanish`, the plane's horizon may cross the canvas.
inline CornerValues random_depth(Random& random, bool may_vanish) {
  const auto nearness = [&] { return random.log_uniform(1.0 / 4096, 1.0 / 4); };
  CornerValues depth{nearness(), nearness(), nearness()};
  if (may_vanish && random.chance(0.2)) return depth;
  if (random.chance(0.2)) depth[1] = depth[0];
  if (depth[1] + depth[2] - depth[0] < 0.1 * std::min(depth[1], depth[2])) depth[2] = depth[0];
  return depth;
}

// Texture coordinates at the corners: near the texture or far from it, changing slowly or fast.
inline CornerValues random_texels(Random& random, int size, double max_spread) {
  const double middle = random.uniform(-0.5 * size, 1.5 * size);
  const double spread = random.log_uniform(0.05, max_spread);
  CornerValues texels{};
  for (double& texel : texels) texel = middle + random.uniform(-spread, spread);
  return texels;
}
// The same whole number at every pixel, so that only rounding decides on which side of a texel's border it
// falls.
inline CornerValues one_whole_texel(Random& random, int size) {
  const double texel = std::floor(random.uniform(0, size + 1));
  return {texel, texel, texel};
}

// The same coordinate everywhere, close to an end of the texture: only rounding decides whether a pixel is
// still inside.
inline CornerValues beside_an_end(Random& random, int size) {
  const double end = random.chance(0.5) ? 0 : size, away = random.log_uniform(1e-5, 0.5);
  const double texel = random.chance(0.8) == (end == 0) ? end + away : end - away;
  return {texel, texel, texel};
}

// The plane that a perspective kernel expects: texels times 1/z.
inline render::KernelPlane plane_over_z(const CornerValues& texels, const CornerValues& depth) {
  return plane_through({texels[0] * depth[0], texels[1] * depth[1], texels[2] * depth[2]});
}

// A texture coordinate computed in double, and the error that a kernel's may have.
struct Coordinate {
  double value, tolerance;

  bool is_clear() const { return std::floor(value - tolerance) == std::floor(value + tolerance); }
};

constexpr double kRounding = 0x1p-24;  // of one float operation, relative

// Kernels compute base + i * step in float: base, step, product, and sum are each rounded.
struct RunValue {
  double value, tolerance;

  RunValue(const render::KernelPlane& plane, const render::Span& span, int i)
      : value(value_at(plane, span.x + i, span.y)),
        tolerance(4 * kRounding * (std::abs(value_at(plane, span.x, span.y)) + i * std::abs(plane.dx))) {}
};

// numerator * (1 / depth): two more roundings, and the errors of both operands.
inline Coordinate quotient(const RunValue& numerator, const RunValue& depth) {
  const double value = numerator.value / depth.value;
  return {value, numerator.tolerance / depth.value +
                     std::abs(value) * (depth.tolerance / depth.value + 4 * kRounding)};
}

}  // namespace temblor::test
