#include "artgen/models/noise.h"

#include <cmath>

#include "base/hash.h"

namespace temblor::artgen {
namespace {

// The smoothstep polynomial.
double fade_fraction(double t) {
  return t * t * (3 - 2 * t);
}

// Trilinear interpolation between the random values of a cell's corners.
double one_octave(const math::Vec3d& position, std::uint64_t seed) {
  const math::Vec3d corner(std::floor(position.x), std::floor(position.y), std::floor(position.z));
  const math::Vec3d in(fade_fraction(position.x - corner.x), fade_fraction(position.y - corner.y),
                       fade_fraction(position.z - corner.z));
  double sum = 0;
  for (std::int32_t i = 0; i < 8; ++i) {
    const std::int32_t x = i & 1, y = i >> 1 & 1, z = i >> 2;
    const double share = (x == 1 ? in.x : 1 - in.x) * (y == 1 ? in.y : 1 - in.y) * (z == 1 ? in.z : 1 - in.z);
    sum += share * hash_at(static_cast<std::int32_t>(corner.x) + x, static_cast<std::int32_t>(corner.y) + y,
                           static_cast<std::int32_t>(corner.z) + z, seed);
  }
  return sum;
}

}  // namespace

double hash_at(std::int32_t x, std::int32_t y, std::int32_t z, std::uint64_t seed) {
  std::uint64_t hash = base::hash_with(seed, static_cast<std::uint32_t>(x));
  hash = base::hash_with(hash, static_cast<std::uint32_t>(y));
  hash = base::hash_with(hash, static_cast<std::uint32_t>(z));
  return static_cast<double>(hash >> 11) * 0x1p-53;
}

double lump_noise(const math::Vec3d& position, std::uint64_t seed) {
  // The factors are not exactly 2 and 4, so that the octaves' grids do not coincide.
  return (one_octave(position, seed) * 4 + one_octave(position * 2.03, seed + 1) * 2 +
          one_octave(position * 4.07, seed + 2)) /
         7;
}

}  // namespace temblor::artgen
