#include "render/surfaces/light/face_lights.h"

#include <algorithm>
#include <cmath>

#include "base/hash.h"

namespace temblor::render {

namespace {

// The length on the face's plane of one texel along `axis`. Zero for an axis perpendicular to the plane: it
// does not change along the plane.
float units_per_texel(const math::Vec3d& axis, const math::Vec3d& normal) {
  constexpr double kShortest = 1e-6;  // texels per unit
  const double texels_per_unit = glm::length(axis - normal * glm::dot(axis, normal));
  return texels_per_unit > kShortest ? static_cast<float>(1 / texels_per_unit) : 0.0f;
}

}  // namespace

std::optional<FaceLight> light_on_face(const DynamicLight& light, const FacePlacement& placed, bool colored) {
  const math::Vec3d origin(light.origin_world);
  const double height = glm::dot(placed.normal, origin) - placed.distance;
  const double at_nearest = std::min(static_cast<double>(light.radius), double{kMaxLight}) - std::abs(height);
  const double reach = at_nearest - std::max(0.0, static_cast<double>(light.least));
  if (!(reach > 0)) return std::nullopt;
  const math::Vec3d nearest = origin - placed.normal * height;
  FaceLight out;
  out.s = static_cast<float>(glm::dot(placed.s_axis, nearest) + placed.s_offset);
  out.t = static_cast<float>(glm::dot(placed.t_axis, nearest) + placed.t_offset);
  out.units_per_s = units_per_texel(placed.s_axis, placed.normal);
  out.units_per_t = units_per_texel(placed.t_axis, placed.normal);
  out.at_nearest = static_cast<float>(at_nearest);
  out.reach = static_cast<float>(reach);
  for (int channel = 0; channel < 3; ++channel) {
    const float factor = colored ? light.color[channel] : 1.0f;
    out.color[static_cast<std::size_t>(channel)] = factor > 0 ? std::min(factor, kMaxColor) : 0.0f;
  }
  return out;
}

// The light decreases along both axes, so the sample that is nearest along both axes decides.
bool reaches(const FaceLight& light, const SampleGrid& grid) {
  const auto nearest = [&](float at, std::int32_t first, std::int32_t count) {
    const auto begin = static_cast<float>(first * grid.texels);
    const auto end = static_cast<float>((first + count - 1) * grid.texels);
    return std::clamp(at, begin, end);
  };
  const float s = nearest(light.s, grid.first_column, grid.columns);
  const float t = nearest(light.t, grid.first_row, grid.rows);
  return distance_on_face(light, s, t) < light.reach;
}

std::uint64_t hash_lights(std::span<const FaceLight> lights) {
  if (lights.empty()) return 0;
  std::uint64_t hash = lights.size();
  const auto add = [&](float a, float b) {
    hash = base::hash_with(hash, base::float_bits(a) << 32 | base::float_bits(b));
  };
  for (const FaceLight& light : lights) {
    add(light.s, light.t);
    add(light.units_per_s, light.units_per_t);
    add(light.at_nearest, light.reach);
    add(light.color[0], light.color[1]);
    add(light.color[2], 0);
  }
  return hash == 0 ? 1 : hash;
}

}  // namespace temblor::render
