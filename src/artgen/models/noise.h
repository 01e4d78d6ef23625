// Smooth noise in space, for the skins of models.
#pragma once

#include <cstdint>

#include "math/vec.h"

namespace temblor::artgen {

// In [0, 1), the same for the same arguments.
double hash_at(std::int32_t x, std::int32_t y, std::int32_t z, std::uint64_t seed);

// Lumps one unit wide and two kinds of finer ones on top. In [0, 1), mostly around 0.5.
double lump_noise(const math::Vec3d& place, std::uint64_t seed);

}  // namespace temblor::artgen
