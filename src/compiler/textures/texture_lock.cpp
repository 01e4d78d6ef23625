// Method: s and t are linear functions of position, p -> dot(gradient, p) + offset. Under a placement M the
// gradient becomes the inverse transpose of M times the gradient, which is written with cross products here,
// and the offset follows from the placement's own.
#include "compiler/textures/texture_lock.h"

#include <utility>

#include "compiler/textures/texture_axes.h"

namespace temblor::compiler {
namespace {

using math::Vec3d;

// A linear function of position: gradient * position + offset.
struct Field {
  Vec3d gradient;
  double offset;
};

// The function that has, at each moved position, the value that `field` has at the original one.
Field move_field(const Field& field, const Placement& placement) {
  const auto& [x, y, z] = placement.columns;
  const Vec3d gradient = (glm::cross(y, z) * field.gradient.x + glm::cross(z, x) * field.gradient.y +
                          glm::cross(x, y) * field.gradient.z) /
                         placement.determinant();
  return {gradient, field.offset - glm::dot(gradient, placement.offset)};
}

// The normal of a side, times the area that its three points span; zero if they are on one line.
Vec3d compute_scaled_normal(const std::array<Vec3d, 3>& points) {
  return glm::cross(points[0] - points[1], points[2] - points[1]);
}

formats::MapTexturing make_valve_texturing(const TextureAxes& axes, const Placement& placement) {
  const Field s = move_field({axes.s_axis, axes.s_offset}, placement);
  const Field t = move_field({axes.t_axis, axes.t_offset}, placement);
  formats::MapTexturing texturing;
  texturing.alignment = formats::MapAlignment::kValve;
  texturing.s_axis = s.gradient;
  texturing.t_axis = t.gradient;
  texturing.offset = {s.offset, t.offset};
  return texturing;
}

// Brush primitives measure only within the plane, so changes across it go into the constant.
formats::MapTexturing make_primitive_texturing(const formats::MapTexturing& before,
                                               const Vec3d& normal_before, const Vec3d& normal,
                                               const Vec3d& point, const Placement& placement) {
  const auto [x_before, y_before] = brush_primitive_axes(normal_before);
  const auto [x, y] = brush_primitive_axes(normal);
  formats::MapTexturing texturing = before;
  for (std::array<double, 3>& row : texturing.matrix) {
    const Field field = move_field({row[0] * x_before + row[1] * y_before, row[2]}, placement);
    row = {glm::dot(field.gradient, x), glm::dot(field.gradient, y),
           field.offset + glm::dot(field.gradient, normal) * glm::dot(normal, point)};
  }
  return texturing;
}

}  // namespace

Placement combine(const Placement& outer, const Placement& inner) {
  Placement result;
  result.offset = outer.apply(inner.offset);
  for (std::size_t i = 0; i < result.columns.size(); ++i)
    result.columns[i] = outer.apply(inner.columns[i]) - outer.offset;
  return result;
}

formats::MapSide place_side(const formats::MapSide& side, const Placement& placement) {
  formats::MapSide result = side;
  for (Vec3d& point : result.points_world) point = placement.apply(point);
  // Mirroring reverses the order of the points, which would turn the brush inside out.
  if (placement.determinant() < 0) std::swap(result.points_world[0], result.points_world[2]);

  const Vec3d across_before = compute_scaled_normal(side.points_world),
              across = compute_scaled_normal(result.points_world);
  if (across_before == Vec3d(0.0) || across == Vec3d(0.0)) return result;
  const Vec3d normal_before = glm::normalize(across_before), normal = glm::normalize(across);
  result.texturing =
      side.texturing.alignment == formats::MapAlignment::kBrushPrimitive
          ? make_primitive_texturing(side.texturing, normal_before, normal, result.points_world[1], placement)
          : make_valve_texturing(make_text_axes(side.texturing, normal_before, math::Vec2d(1, 1)), placement);
  return result;
}

}  // namespace temblor::compiler
