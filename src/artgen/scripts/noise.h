// Value noise that repeats, for textures that tile. It depends only on its arguments, on every machine: the
// same script makes the same bytes everywhere.
#pragma once

#include <cstdint>

namespace temblor::artgen {

// A pseudorandom number in [0, 1) for a grid point.
double hash_noise(std::int32_t x, std::int32_t y, std::uint64_t seed);

// Noise for a texture whose sides are `period` texels long, at a position in texels. The coarsest lumps are
// `lump` texels wide (a divisor of the period); two finer octaves are added. In [0, 1).
double tiling_noise(double x, double y, std::int32_t period, std::int32_t lump, std::uint64_t seed);

// The frequencies of a noise: the number of lumps along each side of the tile in the first octave. Each
// further octave has twice as many lumps and half the weight.
struct NoiseLumps {
  std::int32_t across = 4, down = 4;
  std::int32_t octaves = 3;
};

// Noise at a position of a tile, which is 1 wide and 1 high and repeats outside. In [0, 1).
double tiling_noise(double across, double down, const NoiseLumps& lumps, std::uint64_t seed);

}  // namespace temblor::artgen
