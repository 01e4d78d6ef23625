#include "compiler/light/faces/light_bytes.h"

#include <algorithm>
#include <cmath>

namespace temblor::compiler {
namespace {

constexpr float kMaxStored = 255;

}  // namespace

float max_channel(const math::Vec3& color) {
  return std::max({color.x, color.y, color.z});
}

math::Vec3 scale_to_steps(const LightSettings& settings, math::Vec3 light) {
  light = glm::max(light, math::Vec3(0.0f));
  light *= settings.range;
  const float brightest = max_channel(light);
  if (settings.max_light > 0 && brightest > settings.max_light) light *= settings.max_light / brightest;
  if (settings.gamma != 1)
    for (int channel = 0; channel < 3; ++channel)
      light[channel] = std::pow(light[channel] / kMaxStored, 1 / settings.gamma) * kMaxStored;
  return light;
}

math::Vec3 scale_to_bytes(const LightSettings& settings, math::Vec3 light) {
  light = scale_to_steps(settings, light);
  const float too_bright = max_channel(light);
  return too_bright > kMaxStored ? light * (kMaxStored / too_bright) : light;
}

std::uint8_t round_to_byte(float value) {
  return static_cast<std::uint8_t>(std::clamp(value + 0.5f, 0.0f, kMaxStored));
}

}  // namespace temblor::compiler
