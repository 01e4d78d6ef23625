// Dynamic lights relative to a face: where they are on its plane, and how far they reach there.
//
// Like stock Quake, it assumes that the distance on the face is the larger of the two offsets along the
// texture axes plus half the smaller one, and the light at a sample is
//
//   radius - distance from the plane - distance on the face
//
// Stock Quake measures along the face in texels, which is wrong where a texture is not one texel per unit,
// and ignores that a brush model has moved. Here distances are in units, and faces are placed in the world
// first.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "render/scene.h"
#include "render/view/model_view.h"

namespace temblor::render {

// One light on one face.
struct FaceLight {
  float s = 0, t = 0;  // the nearest point of the face's plane, in texels from the face's first texel
  // Units on the face per texel along each axis.
  float units_per_s = 0, units_per_t = 0;
  // Light at the nearest point, up to kMaxLight; it falls by 1 per unit.
  float at_nearest = 0;
  // Distance on the face, in units, beyond which the light is omitted.
  float reach = 0;
  std::array<float, 3> color{};  // red, green, blue; factors from 0 to kMaxColor
};

inline bool has_color(const FaceLight& light) {
  return light.color[0] != light.color[1] || light.color[0] != light.color[2];
}

// Bounds that keep sums of light within 32 bits.
constexpr float kMaxLight = 65536, kMaxColor = 16;

constexpr std::int32_t kTexelsASample = 16;  // at mip 0
// A rectangle of the points of a face where light is computed. They are `texels` of mip 0 apart: the samples
// of a stock light map are every 16 texels.
struct SampleGrid {
  std::int32_t first_column = 0, first_row = 0, columns = 0, rows = 0;
  std::int32_t texels = kTexelsASample;
};

// The distance, in units, from the light's nearest point on the face to texel (s, t) of mip 0.
inline float distance_on_face(const FaceLight& light, float s, float t) {
  const float along_s = (s > light.s ? s - light.s : light.s - s) * light.units_per_s;
  const float along_t = (t > light.t ? t - light.t : light.t - t) * light.units_per_t;
  return along_s > along_t ? along_s + along_t * 0.5f : along_t + along_s * 0.5f;
}

// `light` on a placed face; nothing if it does not reach the face's plane. Its color counts only if
// `colored`. Lights with numbers that are not finite are ignored.
std::optional<FaceLight> light_on_face(const DynamicLight& light, const FacePlacement& placed, bool colored);

// Whether the light reaches at least one of the samples.
bool reaches(const FaceLight& light, const SampleGrid& grid);

// Equal lights have equal hashes; different lights have different hashes except with a chance of 2^-64. 0
// only for no lights.
std::uint64_t hash_lights(std::span<const FaceLight> lights);

}  // namespace temblor::render
