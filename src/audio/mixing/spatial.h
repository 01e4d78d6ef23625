// The loudness of a sound in each ear, by the original's rules. Only the distance and the angle to the right
// ear count: walls do not matter, and front and back sound alike.
#pragma once

#include "audio/scene.h"

namespace temblor::audio {

// Factors for the samples, at least 0. They can exceed 1: up to twice the volume.
struct EarGains {
  float left = 0, right = 0;
  bool operator==(const EarGains&) const = default;
};

// gain = volume * (1 - distance * attenuation / 1000) * (1 -+ cos(angle to the right)), so a sound exactly at
// one side is twice as loud in that ear and silent in the other. Never negative; 0 if the position is NaN.
EarGains compute_ear_gains(const Listener& listener, const math::Vec3& origin_world, float volume,
                           float attenuation);

// 1 at the listener; falls linearly to 0 at 1000 units, also beyond and if the position is NaN.
float compute_closeness(const Listener& listener, const math::Vec3& origin_world);

// The target level of an ambient sound, 0 to 255: `share` of the leaf's level, and 0 below 8.
float compute_ambient_level(std::uint8_t leaf_level, float share);

}  // namespace temblor::audio
