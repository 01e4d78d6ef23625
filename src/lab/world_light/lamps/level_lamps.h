// The lights that reach each face of a level, and normals at the corners of its faces.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "lab/world_light/lamps/find_lamps.h"
#include "world/level.h"

namespace temblor::lab {

// Computed once for each level.
class LevelLamps {
 public:
  LevelLamps() = default;
  // `per_face`: the brightest lights of each face count, up to this number. Corners share the normals of
  // faces there whose angle is at most `smooth_deg`.
  LevelLamps(const world::Level& level, std::vector<Lamp> lamps, std::size_t per_face, double smooth_deg);

  bool belongs_to(const world::Level& level) const { return level_ == level.identity; }
  std::span<const Lamp> all() const { return lamps_; }
  // Numbers of lamps in front of the face that reach it, brightest first, where the mapper drew its model.
  std::span<const std::uint32_t> lamps_on(world::FaceIndex face) const {
    const std::size_t i = base::to_size(face);
    return std::span(numbers_).subspan(first_[i], first_[i + 1] - first_[i]);
  }
  // In model space, by the face's corners; of any length, never 0.
  std::span<const math::Vec3d> normals(const world::Face& face) const {
    return std::span(normals_).subspan(face.first_surfedge, face.surfedge_count);
  }

 private:
  void choose_lamps(const world::Level& level, std::size_t per_face);
  void average_normals(const world::Level& level, double smooth_deg);

  std::shared_ptr<const world::LevelIdentity> level_;
  std::vector<Lamp> lamps_;
  std::vector<std::uint32_t> numbers_, first_;  // by face, one more
  std::vector<math::Vec3d> normals_;            // by surfedge
};

}  // namespace temblor::lab
