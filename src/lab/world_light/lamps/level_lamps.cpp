#include "lab/world_light/lamps/level_lamps.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/view/model_view.h"

namespace temblor::lab {

namespace {

// Less light than this, of 255, does not count.
constexpr double kMinLight = 1;

math::Vec3d find_corner(const world::Level& level, const world::Face& face, std::size_t corner) {
  return math::Vec3d(level.vertices[level.surfedge_start(face.first_surfedge + corner)]);
}

double distance_to_box(const math::Vec3d& point, const math::Vec3d& mins, const math::Vec3d& maxs) {
  return glm::length(point - glm::clamp(point, mins, maxs));
}

}  // namespace

LevelLamps::LevelLamps(const world::Level& level, std::vector<Lamp> lamps, std::size_t per_face,
                       double smooth_deg)
    : level_(level.identity), lamps_(std::move(lamps)) {
  choose_lamps(level, per_face);
  average_normals(level, smooth_deg);
}

void LevelLamps::choose_lamps(const world::Level& level, std::size_t per_face) {
  struct Reaching {
    double light;
    std::uint32_t number;
  };
  std::vector<Reaching> reaching;
  first_.push_back(0);
  for (const world::Face& face : level.faces) {
    reaching.clear();
    const render::FacePlane plane = render::place_plane(level, face, {});
    math::Vec3d mins = find_corner(level, face, 0), maxs = mins;
    for (std::size_t i = 1; i < face.surfedge_count; ++i) {
      mins = glm::min(mins, find_corner(level, face, i));
      maxs = glm::max(maxs, find_corner(level, face, i));
    }
    for (std::uint32_t i = 0; i < lamps_.size(); ++i) {
      const Lamp& lamp = lamps_[i];
      const double light = lamp.light_at(distance_to_box(lamp.origin_world, mins, maxs));
      if (light > kMinLight && glm::dot(plane.normal, lamp.origin_world) > plane.distance)
        reaching.push_back({light, i});
    }
    const auto count = static_cast<std::ptrdiff_t>(std::min(per_face, reaching.size()));
    std::ranges::partial_sort(reaching, reaching.begin() + count, std::greater{}, &Reaching::light);
    for (std::ptrdiff_t i = 0; i < count; ++i)
      numbers_.push_back(reaching[static_cast<std::size_t>(i)].number);
    first_.push_back(static_cast<std::uint32_t>(numbers_.size()));
  }
}

void LevelLamps::average_normals(const world::Level& level, double smooth_deg) {
  std::vector<math::Vec3d> of_faces;
  std::vector<std::vector<std::uint32_t>> users(level.vertices.size());
  for (std::uint32_t i = 0; i < level.faces.size(); ++i) {
    const world::Face& face = level.faces[i];
    of_faces.push_back(render::place_plane(level, face, {}).normal);
    for (std::uint32_t corner = 0; corner < face.surfedge_count; ++corner)
      users[level.surfedge_start(face.first_surfedge + corner)].push_back(i);
  }
  const double least = std::cos(smooth_deg * std::numbers::pi / 180) - 1e-9;
  normals_.resize(level.surfedges.size(), math::Vec3d(0, 0, 1));
  for (std::uint32_t i = 0; i < level.faces.size(); ++i) {
    const world::Face& face = level.faces[i];
    for (std::uint32_t corner = 0; corner < face.surfedge_count; ++corner) {
      math::Vec3d sum = of_faces[i];
      for (const std::uint32_t user : users[level.surfedge_start(face.first_surfedge + corner)])
        if (user != i && glm::dot(of_faces[user], of_faces[i]) >= least) sum += of_faces[user];
      // Opposite normals may cancel.
      normals_[face.first_surfedge + corner] = glm::dot(sum, sum) > 1e-3 ? sum : of_faces[i];
    }
  }
}

}  // namespace temblor::lab
