#include "audio/mixing/spatial.h"

namespace temblor::audio {
namespace {

constexpr float kMaxDistance = 1000;  // units, at attenuation 1

// Returns 0 for negative gains and for NaN, because the comparison is then false.
float clamp_gain(float gain) {
  return gain > 0 ? gain : 0;
}

}  // namespace

EarGains compute_ear_gains(const Listener& listener, const math::Vec3& origin_world, float volume,
                           float attenuation) {
  const math::Vec3 away = origin_world - listener.origin_world;
  const float distance = glm::length(away);
  const float loudness = volume * (1 - distance * attenuation / kMaxDistance);
  const float side = distance > 0 ? glm::dot(listener.right, away) / distance : 0;
  return {clamp_gain(loudness * (1 - side)), clamp_gain(loudness * (1 + side))};
}

float compute_closeness(const Listener& listener, const math::Vec3& origin_world) {
  return clamp_gain(1 - glm::distance(origin_world, listener.origin_world) / kMaxDistance);
}

float compute_ambient_level(std::uint8_t leaf_level, float share) {
  const float level = share * static_cast<float>(leaf_level);
  return level < 8 ? 0 : level;
}

}  // namespace temblor::audio
