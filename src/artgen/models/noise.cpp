#include "artgen/models/noise.h"

#include <cmath>

#include "base/hash.h"

namespace temblor::artgen {
namespace {

double faded(double t) {
  return t * t * (3 - 2 * t);
}

double one_octave(const math::Vec3d& place, std::uint64_t seed) {
  const math::Vec3d corner(std::floor(place.x), std::floor(place.y), std::floor(place.z));
  const math::Vec3d in(faded(place.x - corner.x), faded(place.y - corner.y), faded(place.z - corner.z));
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

double lump_noise(const math::Vec3d& place, std::uint64_t seed) {
  return (one_octave(place, seed) * 4 + one_octave(place * 2.03, seed + 1) * 2 +
          one_octave(place * 4.07, seed + 2)) /
         7;
}

}  // namespace temblor::artgen
