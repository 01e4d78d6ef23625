// The direction of the light at each luxel, for engines that draw bumps (formats/bspx/light_directions.h).
//
// It is the mean of the directions toward all lights, weighted by their brightness. Light without a
// direction, such as minimum light, counts as coming along the normal. So does a luxel without any light.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "compiler/light/faces/face_light.h"
#include "compiler/light/lit_level.h"
#include "math/vec.h"

namespace temblor::compiler {

// Returns three bytes for each luxel. `sums`: brightness * unit vector toward the light, in the world's
// space; `undirected`: the brightness of light without a direction. Both by luxel.
std::vector<std::uint8_t> pack_light_directions(const LitLevel& lit, std::size_t face,
                                                std::span<const math::Vec3> sums,
                                                std::span<const float> undirected);

}  // namespace temblor::compiler
