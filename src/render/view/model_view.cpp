#include "render/view/model_view.h"

namespace temblor::render {

ModelView make_model_view(const BrushModelInstance& instance) {
  const math::Basis basis = math::basis_from_angles(instance.angles_deg);
  return {math::Vec3d(instance.origin_world), basis.forward, -basis.right, basis.up};
}

// A rotation keeps lengths, so the distance only changes by the model's origin along the normal.
FacePlane place_plane(const world::Level& level, const world::Face& face, const ModelView& model_view) {
  const world::Plane& plane = level.planes[face.plane];
  const double sign = face.back_side ? -1.0 : 1.0;
  const math::Vec3d normal = model_view.direction_to_world(math::Vec3d(plane.normal) * sign);
  return {normal, static_cast<double>(plane.distance) * sign + glm::dot(normal, model_view.origin_world)};
}

FacePlacement place_face(const world::Level& level, const world::Face& face, const ModelView& model_view) {
  const world::TextureAxes& axes = level.texture_axes[face.axes];
  FacePlacement placed;
  static_cast<FacePlane&>(placed) = place_plane(level, face, model_view);
  placed.s_axis = model_view.direction_to_world(math::Vec3d(axes.s_axis));
  placed.t_axis = model_view.direction_to_world(math::Vec3d(axes.t_axis));
  // Moves the origin of both coordinates to the first texel of the face, in model space.
  placed.s_offset = static_cast<double>(axes.s_offset) - glm::dot(placed.s_axis, model_view.origin_world) -
                    face.texture_mins[0];
  placed.t_offset = static_cast<double>(axes.t_offset) - glm::dot(placed.t_axis, model_view.origin_world) -
                    face.texture_mins[1];
  return placed;
}

std::optional<TexelSteps> find_texel_steps(const FacePlacement& placed) {
  const math::Vec3d s = placed.s_axis - placed.normal * glm::dot(placed.normal, placed.s_axis);
  const math::Vec3d t = placed.t_axis - placed.normal * glm::dot(placed.normal, placed.t_axis);
  const double ss = glm::dot(s, s), st = glm::dot(s, t), tt = glm::dot(t, t);
  const double determinant = ss * tt - st * st;
  constexpr double kAlongOneLine = 1e-9;
  if (!(determinant > kAlongOneLine * ss * tt)) return std::nullopt;
  return TexelSteps{(s * tt - t * st) / determinant, (t * ss - s * st) / determinant};
}

double facing(const ViewFrame& view, const math::Vec3d& normal, double distance) {
  return view.perspective ? glm::dot(normal, view.eye_world) - distance
                          : -glm::dot(normal, view.axes.forward);
}

}  // namespace temblor::render
