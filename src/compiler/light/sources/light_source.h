// A light among the entities, and how brightly it shines at a distance and an angle.
#pragma once

#include <cstdint>
#include <optional>

#include "math/vec.h"

namespace temblor::compiler {

// The "delay" key. L: the light's value, v: its distance times its wait.
enum class Attenuation : std::uint8_t {
  kLinear = 0,          // L - v, or L * (1 - distance / falloff)
  kInverse = 1,         // L * 128 / v
  kInverseSquare = 2,   // L * 128^2 / v^2
  kNone = 3,            // L
  kLocalMinlight = 4,   // L, as a least light where it is seen, not added
  kInverseSquare2 = 5,  // L * 128^2 / (v + 128)^2
};

struct Cone {
  math::Vec3 direction{0.0f};  // unit, the way it shines
  float cos_outer = 0;         // no light outside
  float cos_inner = 0;         // full light inside; between the two linear in the cosine
};

struct LightSource {
  math::Vec3 origin_world{0.0f};
  float value = 300;
  math::Vec3 color{1.0f};
  Attenuation attenuation = Attenuation::kLinear;
  float wait = 1;     // distance scale included, above 0
  float falloff = 0;  // 0: none
  float angle_scale = 0.5f;
  std::uint8_t style = 0;
  bool takes_dirt = true;
  std::optional<Cone> cone;
};

// Values of less than this are no light.
constexpr float kLightGate = 0.001f;

// Negative for a negative light. A distance below 0.1 counts as that.
float value_at(const LightSource& light, float distance);

// Beyond this distance the value is within kLightGate of 0; infinity where there is no such distance.
float reach_of(const LightSource& light);

// Of the light that a surface could get: 1 - angle_scale + angle_scale * cosine; 0 from behind.
inline float angle_factor(float angle_scale, float cosine) {
  return cosine <= 0 ? 0 : 1 - angle_scale + angle_scale * cosine;
}

// `towards_light`: unit, from the lit point to the light.
float cone_factor(const Cone& cone, const math::Vec3& towards_light);

}  // namespace temblor::compiler
