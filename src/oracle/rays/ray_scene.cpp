#include "oracle/rays/ray_scene.h"

#include <cmath>

#include "math/angles.h"

namespace temblor::oracle {

math::Vec3d Placement::to_model(const math::Vec3d& point_world) const {
  return direction_to_model(point_world - origin);
}

math::Vec3d Placement::direction_to_model(const math::Vec3d& direction_world) const {
  return {glm::dot(direction_world, x_axis), glm::dot(direction_world, y_axis),
          glm::dot(direction_world, z_axis)};
}

Placement make_placement(const render::BrushModelInstance& instance) {
  const math::Basis basis = math::basis_from_angles(instance.angles_deg);
  return {instance.origin_world, basis.forward, -basis.right, basis.up};
}

PreparedLevel::PreparedLevel(const world::Level& level) : level_(&level) {
  trees_.reserve(level.models.size());
  for (const world::Model& model : level.models) trees_.emplace_back(level, model);
  colors_.resize(level.textures.size());
  for (std::size_t i = 0; i < level.textures.size(); ++i)
    for (const std::uint8_t texel : level.textures[i].mips[0]) colors_[i].set(texel);
}

RayScene::RayScene(const PreparedLevel& level, std::span<const render::BrushModelInstance> brush_models)
    : level_(&level), brush_models_(brush_models), placements_(1) {
  for (const render::BrushModelInstance& instance : brush_models)
    placements_.push_back(make_placement(instance));
}

const FaceTree& RayScene::tree(std::uint32_t instance) const {
  return level_->model_faces(instance == 0 ? world::ModelIndex{0} : brush_models_[instance - 1].model);
}

Ray RayScene::ray_in_model(std::uint32_t instance, const Ray& ray_world) const {
  const Placement& placement = placements_[instance];
  return {placement.to_model(ray_world.origin), placement.direction_to_model(ray_world.direction)};
}

std::optional<Hit> RayScene::nearest(const Ray& ray, double min_distance, Accept accept) const {
  std::optional<Hit> best;
  for (std::uint32_t instance = 0; instance < placements_.size(); ++instance) {
    const auto accept_here = [&](const FaceHit& hit) {
      return (!best || hit.distance < best->distance) && accept(Hit{instance, hit.face, hit.distance});
    };
    const auto hit = tree(instance).nearest(ray_in_model(instance, ray), min_distance, accept_here);
    if (hit) best = Hit{instance, hit->face, hit->distance};
  }
  return best;
}

std::optional<Hit> RayScene::nearest(const Ray& ray, double min_distance) const {
  return nearest(ray, min_distance, [](const Hit&) { return true; });
}

std::optional<double> RayScene::distance_to(const Ray& ray, std::uint32_t instance,
                                            world::FaceIndex face) const {
  return tree(instance).distance_to(ray_in_model(instance, ray), face);
}

double RayScene::distance_to_plane(const Ray& ray_world, std::uint32_t instance,
                                   world::FaceIndex face) const {
  const world::Plane& plane = level_->level().planes[level_->level().face(face).plane];
  const math::Vec3d normal(plane.normal);
  const Ray ray = ray_in_model(instance, ray_world);
  return (static_cast<double>(plane.distance) - glm::dot(normal, ray.origin)) /
         glm::dot(normal, ray.direction);
}

double RayScene::distance_from_plane(const math::Vec3d& point_world, std::uint32_t instance,
                                     world::FaceIndex face) const {
  const world::Plane& plane = level_->level().planes[level_->level().face(face).plane];
  return std::abs(glm::dot(math::Vec3d(plane.normal), to_model(instance, point_world)) -
                  static_cast<double>(plane.distance));
}

}  // namespace temblor::oracle
