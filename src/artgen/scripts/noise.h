// Smooth noise that repeats, for what tiles; the same for the same arguments, on every machine.
#pragma once

#include <cstdint>

namespace temblor::artgen {

// A number in [0, 1) that looks random, the same for the same arguments.
double hash_noise(std::int32_t x, std::int32_t y, std::uint64_t seed);

// Noise at a texel of a texture with sides of `period` texels: lumps of `lump` texels (a divisor of the
// period) and finer ones on top. In [0, 1).
double tiling_noise(double x, double y, std::int32_t period, std::int32_t lump, std::uint64_t seed);

// The coarsest lumps of a noise: so many along each side of what repeats; each octave has twice as many.
struct NoiseLumps {
  std::int32_t across = 4, down = 4;
  std::int32_t octaves = 3;
};

// Noise at a place of a tile, from 0 to 1 across and down it (and repeating outside). In [0, 1).
double tiling_noise(double across, double down, const NoiseLumps& lumps, std::uint64_t seed);

}  // namespace temblor::artgen
