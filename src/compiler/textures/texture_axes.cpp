// The three alignments of a .map:
//
//   standard          offset, rotation, scale   along the world axis nearest to the normal
//   Valve 220         two axes, offset, scale   at any angle (the rotation is only for the editor)
//   brush primitives  a 2 x 3 matrix            in the side's own plane, in whole textures
#include "compiler/textures/texture_axes.h"

#include <cmath>
#include <numbers>

namespace temblor::compiler {
namespace {

using math::Vec3d;

// The standard alignment projects the texture along the world axis nearest to the side's normal. `s` and `t`
// are the world axes along which the texture runs; t always goes down.
struct Projection {
  Vec3d toward;
  int s, t;
};

// In the order of preference if several are equally near.
constexpr std::array<Projection, 6> kProjections{{
    {{0, 0, 1}, 0, 1},
    {{0, 0, -1}, 0, 1},
    {{1, 0, 0}, 1, 2},
    {{-1, 0, 0}, 1, 2},
    {{0, 1, 0}, 0, 2},
    {{0, -1, 0}, 0, 2},
}};

const Projection& find_nearest_projection(const Vec3d& normal) {
  // A slope of 45 degrees takes the earlier axis, however its normal is rounded.
  constexpr double kTie = 1e-6;
  const Projection* nearest = &kProjections.front();
  for (const Projection& projection : kProjections)
    if (glm::dot(normal, projection.toward) > glm::dot(normal, nearest->toward) + kTie) nearest = &projection;
  return *nearest;
}

TextureAxes make_standard_axes(const formats::MapTexturing& texturing, const Vec3d& normal) {
  const Projection& projection = find_nearest_projection(normal);
  const double angle = texturing.rotation_deg * std::numbers::pi / 180;
  // Quarter turns are exact, so that turned walls have whole texels.
  const double quarters = texturing.rotation_deg / 90;
  const bool is_quarter = quarters == std::floor(quarters);
  const double cosine = is_quarter ? std::round(std::cos(angle)) : std::cos(angle);
  const double sine = is_quarter ? std::round(std::sin(angle)) : std::sin(angle);
  TextureAxes axes;
  axes.s_axis[projection.s] = cosine / texturing.scale.x;
  axes.s_axis[projection.t] = sine / texturing.scale.x;
  axes.t_axis[projection.s] = sine / texturing.scale.y;
  axes.t_axis[projection.t] = -cosine / texturing.scale.y;
  axes.s_offset = texturing.offset.x;
  axes.t_offset = texturing.offset.y;
  return axes;
}

TextureAxes make_valve_axes(const formats::MapTexturing& texturing) {
  return {texturing.s_axis / texturing.scale.x, texturing.offset.x, texturing.t_axis / texturing.scale.y,
          texturing.offset.y};
}

// The matrix measures in whole textures, so its rows are multiplied by the texture's size.
TextureAxes make_primitive_axes(const formats::MapTexturing& texturing, const Vec3d& normal,
                                const math::Vec2d& size_texels) {
  const auto [x, y] = brush_primitive_axes(normal);
  const auto& [s, t] = texturing.matrix;
  return {(s[0] * x + s[1] * y) * size_texels.x, s[2] * size_texels.x, (t[0] * x + t[1] * y) * size_texels.y,
          t[2] * size_texels.y};
}

// Comparisons are written so that NaN fails them.
bool is_usable(const TextureAxes& axes, const Vec3d& normal) {
  const auto in_range = [](double texels_per_unit) {
    return texels_per_unit >= kMinTexelsPerUnit && texels_per_unit <= kMaxTexelsPerUnit;
  };
  const double s_length = glm::length(axes.s_axis), t_length = glm::length(axes.t_axis);
  if (!in_range(s_length) || !in_range(t_length)) return false;
  // The area, in texels, of a square unit of the side, compared with that of a side facing the projection.
  constexpr double kMinShare = 1e-4;
  const double area = std::abs(glm::dot(glm::cross(axes.s_axis, axes.t_axis), normal));
  return area >= kMinShare * s_length * t_length && std::isfinite(axes.s_offset) &&
         std::isfinite(axes.t_offset);
}

// Large offsets would lose the fraction of a texel when they become floats. 16 repetitions at a time, because
// that is a multiple of 16 texels for any texture.
double remove_repetitions(double offset, double size_texels) {
  constexpr double kMaxOffset = 1 << 20;
  return std::abs(offset) <= kMaxOffset ? offset : std::fmod(offset, 16 * size_texels);
}

}  // namespace

std::array<Vec3d, 2> brush_primitive_axes(const Vec3d& normal) {
  const double across = std::hypot(normal.x, normal.y);
  // A floor has yaw 0, even if rounding tilts its normal a little.
  constexpr double kFloor = 1e-6;
  const double cos_yaw = across < kFloor ? 1 : normal.x / across;
  const double sin_yaw = across < kFloor ? 0 : normal.y / across;
  return {Vec3d(-sin_yaw, cos_yaw, 0), Vec3d(normal.z * cos_yaw, normal.z * sin_yaw, -across)};
}

TextureAxes make_text_axes(const formats::MapTexturing& texturing, const Vec3d& normal,
                           const math::Vec2d& texture_size_texels) {
  switch (texturing.alignment) {
    case formats::MapAlignment::kValve:
      return make_valve_axes(texturing);
    case formats::MapAlignment::kBrushPrimitive:
      return make_primitive_axes(texturing, normal, texture_size_texels);
    case formats::MapAlignment::kStandard:
      break;
  }
  return make_standard_axes(texturing, normal);
}

SideAxes make_side_axes(const formats::MapTexturing& texturing, const Vec3d& normal,
                        const math::Vec2d& texture_size_texels) {
  SideAxes result{make_text_axes(texturing, normal, texture_size_texels)};
  if (!is_usable(result.axes, normal)) return {make_standard_axes({}, normal), true};
  result.axes.s_offset = remove_repetitions(result.axes.s_offset, texture_size_texels.x);
  result.axes.t_offset = remove_repetitions(result.axes.t_offset, texture_size_texels.y);
  return result;
}

formats::BspTexinfo to_texinfo(const TextureAxes& axes, std::int32_t miptex, std::int32_t flags) {
  return {math::Vec3(axes.s_axis),
          static_cast<float>(axes.s_offset),
          math::Vec3(axes.t_axis),
          static_cast<float>(axes.t_offset),
          miptex,
          flags};
}

}  // namespace temblor::compiler
