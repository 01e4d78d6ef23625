#include "artgen/level/grid_light.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace temblor::artgen {
namespace {

// Light samples are 16 texels apart, as in the BSP format.
constexpr float kSampleTexels = 16;
constexpr float kOffSurfaceUnits = 1;
constexpr float kShadowStepUnits = 8;
constexpr float kAmbient = 14;

// The position of a face's samples in texels: multiples of 16, from at or below its first texel to at or
// above its last.
struct SampleGrid {
  float first_s, first_t;
  std::size_t width, height;
};

// The first sample position and the number of samples on one texture axis.
struct TexelRange {
  float first, count;
};
TexelRange find_sample_range(float min_texel, float max_texel) {
  const float first = std::floor(min_texel / kSampleTexels);
  const float last = std::ceil(max_texel / kSampleTexels);
  return {first * kSampleTexels, last - first + 1};
}

SampleGrid find_sample_grid(const math::Bounds& bounds, const TextureProjection& projection) {
  const auto s_axis = static_cast<int>(projection.s_axis);
  const auto t_axis = static_cast<int>(projection.t_axis);
  const float scale = projection.texels_per_unit;
  const TexelRange s = find_sample_range(bounds.mins[s_axis] * scale, bounds.maxs[s_axis] * scale);
  const TexelRange t = find_sample_range(-bounds.maxs[t_axis] * scale, -bounds.mins[t_axis] * scale);
  return {s.first, t.first, static_cast<std::size_t>(s.count), static_cast<std::size_t>(t.count)};
}

std::uint8_t to_sample(float value) {
  return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0l, 255l));
}

}  // namespace

TextureProjection make_projection(const GridFace& face, float texels_per_unit) {
  if (face.axis == 2) return {0, 1, texels_per_unit};
  return {face.axis == 0 ? std::size_t{1} : std::size_t{0}, 2, texels_per_unit};
}

// All lines lie on whole units, so a cell is found from the integral part of a coordinate.
GridLighter::GridLighter(const SmallLevelLayout& layout, const CellGrid& grid)
    : layout_(layout), grid_(grid) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::vector<float>& lines = grid.lines[axis];
    const auto units = static_cast<std::size_t>(lines.back() - lines.front());
    CellPosition cell{};
    for (std::size_t unit = 0; unit < units; ++unit) {
      while (lines.front() + static_cast<float>(unit) >= lines[cell[axis] + 1]) ++cell[axis];
      index_by_unit_[axis].push_back(grid.index(cell));
    }
  }
  for (const Cell& cell : grid.cells) is_solid_.push_back(cell.contents == kContentsSolid ? 1 : 0);
}

// Samples the line every 8 units. Walls are thicker than that.
bool GridLighter::is_blocked(const math::Vec3& from, const math::Vec3& to) const {
  const math::Vec3 path = to - from;
  const int steps = static_cast<int>(glm::length(path) / kShadowStepUnits) + 1;
  for (int step = 0; step < steps; ++step) {
    const math::Vec3 at = from + path * (static_cast<float>(step) / static_cast<float>(steps));
    std::size_t index = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float unit = at[static_cast<int>(axis)] - grid_.lines[axis].front();
      index += index_by_unit_[axis][static_cast<std::size_t>(unit)];
    }
    if (is_solid_[index] != 0) return true;
  }
  return false;
}

// The light that one source adds at a position. It falls linearly from `reach` to 0, and to half of that on
// surfaces that the light only grazes.
math::Vec3 GridLighter::compute_light(const LayoutLight& light, const math::Vec3& position,
                                      const math::Vec3& normal) const {
  const math::Vec3 towards = light.origin - position;
  const float distance = glm::length(towards);
  const float facing = glm::dot(towards, normal);
  if (distance >= light.reach || facing <= 0 || is_blocked(position, light.origin)) return math::Vec3(0.0f);
  const float slant = facing / std::max(distance, 1.0f);
  return light.color * ((light.reach - distance) * (0.5f + 0.5f * slant));
}

FaceLight GridLighter::light_face(const CellGrid& face_grid, const GridFace& face,
                                  const TextureProjection& projection) const {
  const math::Bounds bounds = face_grid.bounds({face.front_cells().first, face.front_cells().last});
  const auto axis = static_cast<int>(face.axis);
  math::Vec3 normal(0.0f);
  normal[axis] = face.is_positive ? 1.0f : -1.0f;
  const SampleGrid samples = find_sample_grid(bounds, projection);
  // Samples at the rim may lie outside the face, inside a wall, where they would be black. They are moved
  // back onto the face.
  const auto clamp_to_face = [&](std::size_t along, float position) {
    const auto i = static_cast<int>(along);
    return std::clamp(position, bounds.mins[i] + kOffSurfaceUnits, bounds.maxs[i] - kOffSurfaceUnits);
  };
  std::set<std::uint8_t> styles;
  for (const LayoutLight& light : layout_.lights) styles.insert(light.style);
  FaceLight result{{255, 255, 255, 255}, {}};
  std::size_t used = 0;
  for (const std::uint8_t style : styles) {
    std::vector<std::uint8_t> rgb;
    for (std::size_t j = 0; j < samples.height; ++j) {
      for (std::size_t i = 0; i < samples.width; ++i) {
        const float s = samples.first_s + kSampleTexels * static_cast<float>(i);
        const float t = samples.first_t + kSampleTexels * static_cast<float>(j);
        math::Vec3 position(0.0f);
        position[axis] = face_grid.lines[face.axis][face.line] + normal[axis] * kOffSurfaceUnits;
        position[static_cast<int>(projection.s_axis)] =
            clamp_to_face(projection.s_axis, s / projection.texels_per_unit);
        position[static_cast<int>(projection.t_axis)] =
            clamp_to_face(projection.t_axis, -t / projection.texels_per_unit);
        // Ambient light belongs to style 0, which is always on.
        math::Vec3 sum(style == 0 ? kAmbient : 0.0f);
        for (const LayoutLight& light : layout_.lights)
          if (light.style == style) sum += compute_light(light, position, normal);
        for (int channel = 0; channel < 3; ++channel) rgb.push_back(to_sample(sum[channel]));
      }
    }
    const bool reaches = std::any_of(rgb.begin(), rgb.end(), [](std::uint8_t value) { return value != 0; });
    if (!reaches || used == result.styles.size()) continue;
    result.styles[used++] = style;
    result.rgb.insert(result.rgb.end(), rgb.begin(), rgb.end());
  }
  return result;
}

}  // namespace temblor::artgen
