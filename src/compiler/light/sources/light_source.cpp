#include "compiler/light/sources/light_source.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace temblor::compiler {
namespace {

constexpr float kUnit = 128;  // the distance at which lights with delay 1 and 2 have their value
constexpr float kNearest = 0.1f;

// Fades to 0 and never changes its sign.
float compute_linear_value(const LightSource& light, float distance) {
  if (light.falloff > 0) return light.value * std::max(0.0f, 1 - distance / light.falloff);
  const float lost = light.wait * distance;
  return light.value >= 0 ? std::max(0.0f, light.value - lost) : std::min(0.0f, light.value + lost);
}

}  // namespace

float value_at(const LightSource& light, float distance) {
  distance = std::max(distance, kNearest);
  const float way = light.wait * distance;
  switch (light.attenuation) {
    case Attenuation::kLinear:
      return compute_linear_value(light, distance);
    case Attenuation::kInverse:
      return light.value * kUnit / way;
    case Attenuation::kInverseSquare:
      return light.value * (kUnit * kUnit) / (way * way);
    case Attenuation::kNone:
    case Attenuation::kLocalMinlight:
      return light.value;
    case Attenuation::kInverseSquare2:
      return light.value * (kUnit * kUnit) / ((way + kUnit) * (way + kUnit));
  }
  return 0;
}

// The formulas of value_at(), solved for the distance at which the value is kLightGate (0 for kLinear).
float light_reach(const LightSource& light) {
  const float value = std::abs(light.value);
  switch (light.attenuation) {
    case Attenuation::kLinear:
      return light.falloff > 0 ? light.falloff : value / light.wait;
    case Attenuation::kInverse:
      return value * kUnit / (kLightGate * light.wait);
    case Attenuation::kInverseSquare:
      return std::sqrt(value / kLightGate) * kUnit / light.wait;
    case Attenuation::kInverseSquare2:
      return std::max(0.0f, std::sqrt(value / kLightGate) - 1) * kUnit / light.wait;
    case Attenuation::kNone:
    case Attenuation::kLocalMinlight:
      break;
  }
  return value > 0 ? std::numeric_limits<float>::infinity() : 0;
}

float cone_factor(const Cone& cone, const math::Vec3& toward_light) {
  const float cosine = -glm::dot(cone.direction, toward_light);
  if (cosine < cone.cos_outer) return 0;
  if (cosine >= cone.cos_inner) return 1;
  return (cosine - cone.cos_outer) / (cone.cos_inner - cone.cos_outer);
}

}  // namespace temblor::compiler
