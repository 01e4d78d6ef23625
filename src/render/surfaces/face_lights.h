// Dynamic lights as a face sees them: where on its plane, and how far they reach there.
//
// The original's way: distance on the face is the longer way along a texture axis plus half the shorter one,
// and the light there is radius - distance from the plane - distance on the face. It measures along the face
// in texels, which is too near or too far where a texture is not one texel a unit; here it is in units, and
// the light stands where the face does, also when its model has moved.
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
  float s = 0, t = 0;  // its nearest point of the face's plane, in texels from the face's first
  float units_a_s = 0, units_a_t = 0;  // lengths of a texel on the face
  float at_nearest = 0;                // light at that point, up to kMaxLight; it falls by 1 a unit
  float reach = 0;                     // units along the face from there, to where it is left out
  std::array<float, 3> color{};        // red, green, blue; factors from 0 to kMaxColor
};

constexpr float kMaxLight = 65536, kMaxColor = 16;

// Samples of a face's light map, one every 16 texels: part of a row of part of its columns.
struct SampleGrid {
  std::int32_t first_column = 0, first_row = 0, columns = 0, rows = 0;
};
constexpr std::int32_t kTexelsASample = 16;  // at mip 0

// How much further than its nearest point a light is from a texel (s, t) of the face, in units.
inline float distance_on_face(const FaceLight& light, float s, float t) {
  const float along_s = (s > light.s ? s - light.s : light.s - s) * light.units_a_s;
  const float along_t = (t > light.t ? t - light.t : light.t - t) * light.units_a_t;
  return along_s > along_t ? along_s + along_t * 0.5f : along_t + along_s * 0.5f;
}

// `light` on the face placed in the world, or nothing where it does not reach the face's plane. Colors count
// only when `colored`. Numbers of a light that are none (not finite) make it none.
std::optional<FaceLight> light_on_face(const DynamicLight& light, const FacePlacement& placed, bool colored);

// Whether the light reaches one of the samples.
bool reaches(const FaceLight& light, const SampleGrid& grid);

// Equal lights have equal hashes, and different ones different hashes but for a chance of 2^-64. 0 only for
// none.
std::uint64_t hash_of(std::span<const FaceLight> lights);

}  // namespace temblor::render
