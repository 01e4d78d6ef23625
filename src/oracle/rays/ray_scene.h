// The nearest face that a ray hits, of the world and the brush models of a scene.
#pragma once

#include <bitset>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "oracle/rays/camera_rays.h"
#include "oracle/rays/face_tree.h"
#include "render/scene.h"
#include "world/level.h"

namespace temblor::oracle {

// A rigid motion: the placement of a brush model in the world.
struct Placement {
  math::Vec3d origin{0.0}, x_axis{1, 0, 0}, y_axis{0, 1, 0}, z_axis{0, 0, 1};

  math::Vec3d to_model(const math::Vec3d& point_world) const;
  math::Vec3d direction_to_model(const math::Vec3d& direction_world) const;
};
Placement find_placement(const render::BrushModelInstance& instance);

struct Hit {
  std::uint32_t instance = 0;  // 0: the world, i + 1: brush model i of the scene
  world::FaceIndex face{};
  double distance = 0;  // in multiples of the ray's direction: the depth z
};

// Data that the oracle computes once for a level, valid for any scene of it. The level must outlive it.
class PreparedLevel {
 public:
  explicit PreparedLevel(const world::Level& level);

  const world::Level& level() const { return *level_; }
  const FaceTree& model_faces(world::ModelIndex model) const { return trees_[base::to_size(model)]; }
  // The palette indices that occur in a texture.
  const std::bitset<256>& texture_colors(world::TextureIndex texture) const {
    return colors_[base::to_size(texture)];
  }

 private:
  const world::Level* level_;
  std::vector<FaceTree> trees_;
  std::vector<std::bitset<256>> colors_;
};

class RayScene {
 public:
  // Both must outlive it.
  RayScene(const PreparedLevel& level, std::span<const render::BrushModelInstance> brush_models);

  // Considers only faces at `min_distance` (the near plane) or beyond.
  using Accept = base::FunctionRef<bool(const Hit&)>;
  std::optional<Hit> nearest(const Ray& ray, double min_distance, Accept accept) const;
  std::optional<Hit> nearest(const Ray& ray, double min_distance) const;

  // Where the ray meets one face, if it does.
  std::optional<double> distance_to(const Ray& ray, std::uint32_t instance, world::FaceIndex face) const;

  // The distance at which the ray meets the plane of a face; infinite or negative if it is parallel to the
  // plane or points away from it.
  double distance_to_plane(const Ray& ray, std::uint32_t instance, world::FaceIndex face) const;

  // The distance of a point from the plane of a face, in units.
  double distance_from_plane(const math::Vec3d& point_world, std::uint32_t instance,
                             world::FaceIndex face) const;

  math::Vec3d to_model(std::uint32_t instance, const math::Vec3d& point_world) const {
    return placements_[instance].to_model(point_world);
  }

 private:
  const FaceTree& tree(std::uint32_t instance) const;
  Ray ray_in_model(std::uint32_t instance, const Ray& ray_world) const;

  const PreparedLevel* level_;
  std::span<const render::BrushModelInstance> brush_models_;
  std::vector<Placement> placements_;  // by instance; 0: the world, which has not moved
};

}  // namespace temblor::oracle
