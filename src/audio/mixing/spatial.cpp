#include "audio/mixing/spatial.h"

namespace temblor::audio {
namespace {

constexpr float kReach = 1000;  // units, at attenuation 1

// Also 0 for NaN.
float not_below_zero(float gain) {
  return gain > 0 ? gain : 0;
}

}  // namespace

// Loudness falls linearly with distance. `side` is the sine of the angle to the listener's view: -1 is left,
// 1 is right. One ear gets up to twice the loudness, the other gets the rest.
EarGains compute_ear_gains(const Listener& listener, const math::Vec3& origin_world, float volume,
                           float attenuation) {
  const math::Vec3 away = origin_world - listener.origin_world;
  const float distance = glm::length(away);
  const float loudness = volume * (1 - distance * attenuation / kReach);
  const float side = distance > 0 ? glm::dot(listener.right, away) / distance : 0;
  return {not_below_zero(loudness * (1 - side)), not_below_zero(loudness * (1 + side))};
}

// Levels below 8 are silent, as in stock Quake.
float compute_ambient_level(std::uint8_t leaf_level, float share) {
  const float level = share * static_cast<float>(leaf_level);
  return level < 8 ? 0 : level;
}

}  // namespace temblor::audio
