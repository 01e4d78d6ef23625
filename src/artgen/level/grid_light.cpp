#include "artgen/level/grid_light.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace temblor::artgen {
namespace {

constexpr float kSampleTexels = 16;
constexpr float kOffSurfaceUnits = 1;
constexpr float kShadowStepUnits = 8;
constexpr float kAmbient = 14;

// The sample positions of a face in texels, multiples of 16 from below its first texel to above its last.
struct SampleGrid {
  float first_s, first_t;
  std::size_t width, height;
};

struct TexelRange {
  float first, count;
};
TexelRange sample_range(float min_texel, float max_texel) {
  const float first = std::floor(min_texel / kSampleTexels);
  const float last = std::ceil(max_texel / kSampleTexels);
  return {first * kSampleTexels, last - first + 1};
}

SampleGrid samples_of(const math::Bounds& bounds, const TextureLayout& layout) {
  const auto s_axis = static_cast<int>(layout.s_axis);
  const auto t_axis = static_cast<int>(layout.t_axis);
  const float scale = layout.texels_per_unit;
  const TexelRange s = sample_range(bounds.mins[s_axis] * scale, bounds.maxs[s_axis] * scale);
  const TexelRange t = sample_range(-bounds.maxs[t_axis] * scale, -bounds.mins[t_axis] * scale);
  return {s.first, t.first, static_cast<std::size_t>(s.count), static_cast<std::size_t>(t.count)};
}

std::uint8_t to_sample(float value) {
  return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0l, 255l));
}

}  // namespace

TextureLayout layout_of(const GridFace& face, float texels_per_unit) {
  if (face.axis == 2) return {0, 1, texels_per_unit};
  return {face.axis == 0 ? std::size_t{1} : std::size_t{0}, 2, texels_per_unit};
}

GridLighter::GridLighter(const SmallLevelPlan& plan, const CellGrid& grid) : plan_(plan), grid_(grid) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::vector<float>& lines = grid.lines[axis];
    const auto units = static_cast<std::size_t>(lines.back() - lines.front());
    std::uint16_t cell = 0;
    for (std::size_t unit = 0; unit < units; ++unit) {
      while (lines.front() + static_cast<float>(unit) >= lines[cell + 1u]) ++cell;
      cell_of_unit_[axis].push_back(cell);
    }
  }
}

bool GridLighter::blocked(const math::Vec3& from, const math::Vec3& to) const {
  const math::Vec3 path = to - from;
  const int steps = static_cast<int>(glm::length(path) / kShadowStepUnits) + 1;
  for (int step = 0; step < steps; ++step) {
    const math::Vec3 at = from + path * (static_cast<float>(step) / static_cast<float>(steps));
    CellPosition cell{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float unit = at[static_cast<int>(axis)] - grid_.lines[axis].front();
      cell[axis] = cell_of_unit_[axis][static_cast<std::size_t>(unit)];
    }
    if (grid_.at(cell).contents == kContentsSolid) return true;
  }
  return false;
}

math::Vec3 GridLighter::light_at(const PlanLight& light, const math::Vec3& position,
                                 const math::Vec3& normal) const {
  const math::Vec3 towards = light.origin - position;
  const float distance = glm::length(towards);
  const float facing = glm::dot(towards, normal);
  if (distance >= light.reach || facing <= 0 || blocked(position, light.origin)) return math::Vec3(0.0f);
  const float slant = facing / std::max(distance, 1.0f);
  return light.color * ((light.reach - distance) * (0.5f + 0.5f * slant));
}

FaceLight GridLighter::light(const CellGrid& face_grid, const GridFace& face,
                             const TextureLayout& layout) const {
  const math::Bounds bounds = face_grid.bounds({face.front_cells().first, face.front_cells().last});
  const auto axis = static_cast<int>(face.axis);
  math::Vec3 normal(0.0f);
  normal[axis] = face.looks_up ? 1.0f : -1.0f;
  const SampleGrid samples = samples_of(bounds, layout);
  // A sample beyond the face's rim would lie inside a wall and be dark.
  const auto inside = [&](std::size_t along, float position) {
    const auto i = static_cast<int>(along);
    return std::clamp(position, bounds.mins[i] + kOffSurfaceUnits, bounds.maxs[i] - kOffSurfaceUnits);
  };
  std::set<std::uint8_t> styles;
  for (const PlanLight& light : plan_.lights) styles.insert(light.style);
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
        position[static_cast<int>(layout.s_axis)] = inside(layout.s_axis, s / layout.texels_per_unit);
        position[static_cast<int>(layout.t_axis)] = inside(layout.t_axis, -t / layout.texels_per_unit);
        math::Vec3 sum(style == 0 ? kAmbient : 0.0f);
        for (const PlanLight& light : plan_.lights)
          if (light.style == style) sum += light_at(light, position, normal);
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
