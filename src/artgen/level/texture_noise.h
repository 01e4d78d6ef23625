// Smooth noise that repeats, for textures that tile.
#pragma once

#include <cstdint>

namespace temblor::artgen {

// A number in [0, 1) that looks random, the same for the same arguments.
double hash_noise(std::int32_t x, std::int32_t y, std::uint64_t seed);

// Noise at a texel of a texture with sides of `period` texels: lumps of `lump` texels (a divisor of the
// period) and finer ones on top. In [0, 1).
double tiling_noise(double x, double y, std::int32_t period, std::int32_t lump, std::uint64_t seed);

}  // namespace temblor::artgen
