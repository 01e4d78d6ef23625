// Conversion of light values to the bytes that a level stores.
#pragma once

#include <cstdint>

#include "compiler/light/sources/settings.h"
#include "math/vec.h"

namespace temblor::compiler {

float max_channel(const math::Vec3& color);

// Scales a light value to steps of 0..255 by the level's maximum, range, and gamma. The result may be larger.
math::Vec3 scale_to_steps(const LightSettings& settings, math::Vec3 light);

// Scales a light value to 0..255: the level's maximum, range, and gamma. Light that is too bright keeps its
// hue.
math::Vec3 scale_to_bytes(const LightSettings& settings, math::Vec3 light);

// Rounds a scaled value to the nearest byte.
std::uint8_t round_to_byte(float value);

}  // namespace temblor::compiler
