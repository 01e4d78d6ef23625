// A point light or spotlight, and how bright it is at a distance and an angle.
#pragma once

#include <cstdint>
#include <optional>

#include "math/vec.h"

namespace temblor::compiler {

// The formulas of the "delay" key. L: the light's value, v: distance * wait.
enum class Attenuation : std::uint8_t {
  kLinear = 0,          // L - v, or L * (1 - distance / falloff)
  kInverse = 1,         // L * 128 / v
  kInverseSquare = 2,   // L * 128^2 / v^2
  kNone = 3,            // L
  kLocalMinlight = 4,   // L, as a minimum where the light is visible, not added
  kInverseSquare2 = 5,  // L * 128^2 / (v + 128)^2
};

// The cone of a spotlight.
struct Cone {
  math::Vec3 direction{0.0f};  // of length 1, the way it shines
  float cos_outer = 0;         // no light outside
  float cos_inner = 0;         // full light inside; in between, linear in the cosine
};

// Defaults are those of a light entity without keys.
struct LightSource {
  math::Vec3 origin_world{0.0f};
  float value = 300;
  math::Vec3 color{1.0f};
  Attenuation attenuation = Attenuation::kLinear;
  float wait = 1;            // includes the level's distance scale; above 0
  float falloff = 0;         // the distance at which kLinear ends; 0: not given
  float angle_scale = 0.5f;  // 0: the angle does not matter, 1: light falls with its cosine
  std::uint8_t style = 0;
  bool takes_dirt = true;
  std::optional<float> dirt_scale, dirt_gain;  // instead of the level's
  float bounce_scale = 1;                      // of the light that surfaces send back
  // Bits: the light reaches faces that have one of `channels`, and is stopped by those that have one of
  // `shadow_channels`.
  std::uint32_t channels = 1, shadow_channels = 1;
  std::optional<Cone> cone;
  std::optional<std::uint32_t> projection;  // in the level's list of projections (projection.h)
};

// Values below this count as no light.
constexpr float kLightGate = 0.001f;

// The light's value at a distance, without the angle. Negative for negative lights. Distances below 0.1 count
// as 0.1.
float value_at(const LightSource& light, float distance);

// The distance beyond which the value is within kLightGate of 0; may be infinite.
float light_reach(const LightSource& light);

// The factor for light that meets a surface at an angle: 1 - angle_scale + angle_scale * cosine; 0 from
// behind.
inline float angle_factor(float angle_scale, float cosine) {
  return cosine <= 0 ? 0 : 1 - angle_scale + angle_scale * cosine;
}

// The factor for a spotlight's cone. `toward_light`: unit vector from the lit point to the light.
float cone_factor(const Cone& cone, const math::Vec3& toward_light);

}  // namespace temblor::compiler
