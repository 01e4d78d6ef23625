// What a ray sees: the nearest face over the world and the brush models of a scene.
#pragma once

#include <bitset>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "oracle/camera_rays.h"
#include "oracle/face_tree.h"
#include "render/scene.h"
#include "world/level.h"

namespace temblor::oracle {

// A rigid motion: where a brush model's own space lies in the world.
struct Placement {
  math::Vec3d origin{0.0}, x_axis{1, 0, 0}, y_axis{0, 1, 0}, z_axis{0, 0, 1};

  math::Vec3d to_model(const math::Vec3d& point_world) const;
  math::Vec3d direction_to_model(const math::Vec3d& direction_world) const;
};
Placement placement_of(const render::BrushModelInstance& instance);

struct Hit {
  std::uint32_t instance = 0;  // 0: the world, i + 1: brush model i of the scene
  world::FaceIndex face{};
  double distance = 0;  // in multiples of the ray's direction: the depth z
};

// What the oracle works out once for a level, good for any scene of it. The level must outlive it.
class PreparedLevel {
 public:
  explicit PreparedLevel(const world::Level& level);

  const world::Level& level() const { return *level_; }
  const FaceTree& faces_of(world::ModelIndex model) const { return trees_[base::to_size(model)]; }
  // Which palette indices occur in a texture.
  const std::bitset<256>& colors_of(world::TextureIndex texture) const {
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

  // Only faces at `min_distance` (the near plane) or beyond.
  using Accept = base::FunctionRef<bool(const Hit&)>;
  std::optional<Hit> nearest(const Ray& ray, double min_distance, Accept accept) const;
  std::optional<Hit> nearest(const Ray& ray, double min_distance) const;

  // Where the ray meets one face, if it does.
  std::optional<double> distance_to(const Ray& ray, std::uint32_t instance, world::FaceIndex face) const;

  // Where the ray meets the whole plane of a face; infinite or negative where it runs along it or away from
  // it.
  double distance_to_plane(const Ray& ray, std::uint32_t instance, world::FaceIndex face) const;

  // How far a point lies from the plane of a face, units.
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
