#include "render/view/model_view.h"

namespace temblor::render {

ModelView make_model_view(const BrushModelInstance& instance) {
  const math::Basis basis = math::basis_from_angles(instance.angles_deg);
  return {math::Vec3d(instance.origin_world), basis.forward, -basis.right, basis.up};
}

FacePlacement place_face(const world::Level& level, const world::Face& face, const ModelView& model_view) {
  const world::Plane& plane = level.planes[face.plane];
  const world::TextureAxes& axes = level.texture_axes[face.axes];
  const double sign = face.back_side ? -1.0 : 1.0;
  FacePlacement placed;
  placed.normal = model_view.direction_to_world(math::Vec3d(plane.normal) * sign);
  placed.distance =
      static_cast<double>(plane.distance) * sign + glm::dot(placed.normal, model_view.origin_world);
  placed.s_axis = model_view.direction_to_world(math::Vec3d(axes.s_axis));
  placed.t_axis = model_view.direction_to_world(math::Vec3d(axes.t_axis));
  placed.s_offset = static_cast<double>(axes.s_offset) - glm::dot(placed.s_axis, model_view.origin_world) -
                    face.texture_mins[0];
  placed.t_offset = static_cast<double>(axes.t_offset) - glm::dot(placed.t_axis, model_view.origin_world) -
                    face.texture_mins[1];
  return placed;
}

double facing(const ViewFrame& view, const math::Vec3d& normal, double distance) {
  return view.perspective ? glm::dot(normal, view.eye_world) - distance
                          : -glm::dot(normal, view.axes.forward);
}

}  // namespace temblor::render
