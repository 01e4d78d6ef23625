#include "artgen/scripts/noise.h"

#include <cmath>

namespace temblor::artgen {
namespace {

constexpr int kOctaves = 3;

// The smoothstep polynomial: its slope is 0 at both ends, so cells join without a crease.
double smooth(double fraction) {
  return fraction * fraction * (3 - 2 * fraction);
}

double mix(double from, double to, double fraction) {
  return from + (to - from) * fraction;
}

// One octave: random values at the corners of a grid of `columns` x `rows` cells that repeats, interpolated
// between them.
double value_noise(double x, double y, std::int32_t columns, std::int32_t rows, std::uint64_t seed) {
  const auto x0 = static_cast<std::int32_t>(std::floor(x));
  const auto y0 = static_cast<std::int32_t>(std::floor(y));
  const auto corner = [&](std::int32_t dx, std::int32_t dy) {
    const auto wrap = [](std::int32_t value, std::int32_t count) { return (value % count + count) % count; };
    return hash_noise(wrap(x0 + dx, columns), wrap(y0 + dy, rows), seed);
  };
  const double along_x = smooth(x - x0);
  return mix(mix(corner(0, 0), corner(1, 0), along_x), mix(corner(0, 1), corner(1, 1), along_x),
             smooth(y - y0));
}

}  // namespace

double hash_noise(std::int32_t x, std::int32_t y, std::uint64_t seed) {
  // Integer arithmetic that wraps around, and the upper 53 bits as a double: exact on every machine.
  std::uint64_t mixed = seed * 0x9e3779b97f4a7c15u + static_cast<std::uint32_t>(x) * 0xd6e8feb86659fd93u +
                        static_cast<std::uint32_t>(y) * 0xa0761d6478bd642fu;
  mixed = (mixed ^ (mixed >> 32)) * 0xd6e8feb86659fd93u;
  mixed = (mixed ^ (mixed >> 32)) * 0xd6e8feb86659fd93u;
  return static_cast<double>((mixed ^ (mixed >> 32)) >> 11) * 0x1p-53;
}

double tiling_noise(double x, double y, std::int32_t period, std::int32_t lump, std::uint64_t seed) {
  const std::int32_t cells = period / lump;
  return tiling_noise(x / period, y / period, {cells, cells, kOctaves}, seed);
}

double tiling_noise(double across, double down, const NoiseLumps& lumps, std::uint64_t seed) {
  double sum = 0;
  double weight = 0.5;
  double weights = 0;
  std::int32_t columns = lumps.across, rows = lumps.down;
  for (std::int32_t octave = 0; octave < lumps.octaves; ++octave) {
    sum += weight * value_noise(across * columns, down * rows, columns, rows,
                                seed + static_cast<std::uint64_t>(octave));
    weights += weight;
    weight /= 2;
    columns *= 2;
    rows *= 2;
  }
  // Normalized, so that the range does not depend on the number of octaves.
  return sum / weights;
}

}  // namespace temblor::artgen
