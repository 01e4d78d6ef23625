// How loud a sound is in each ear.
#pragma once

#include "audio/scene.h"

namespace temblor::audio {

struct EarGains {
  float left = 0, right = 0;
  bool operator==(const EarGains&) const = default;
};

// The original's law: with 1 - distance * attenuation / 1000, and 1 -+ the cosine of the angle to the right,
// so a sound at one side is twice as loud there and silent in the other ear. Never below 0, and 0 for a place
// that is no number.
EarGains gains_at(const Listener& listener, const math::Vec3& origin_world, float volume, float attenuation);

// What a leaf's level comes to, as the original has it: that share of it, and nothing below 8; 0 to 255.
float ambient_target(std::uint8_t leaf_level, float share);

}  // namespace temblor::audio
