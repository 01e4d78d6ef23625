// Smooth three-dimensional noise, for the skins of models and for pictures. Unlike scripts/noise.h, it does
// not repeat.
#pragma once

#include <cstdint>

#include "math/vec.h"

namespace temblor::artgen {

// A pseudorandom number in [0, 1) for a grid point.
double hash_at(std::int32_t x, std::int32_t y, std::int32_t z, std::uint64_t seed);

// Value noise with three octaves: lumps that are one unit wide and two finer sizes. In [0, 1), mostly near
// 0.5.
double lump_noise(const math::Vec3d& position, std::uint64_t seed);

}  // namespace temblor::artgen
