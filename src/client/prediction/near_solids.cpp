#include "client/prediction/near_solids.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace temblor::client {
namespace {

// The distance from a point to the model's box, 0 inside; infinity if the origin is not a number.
float compute_distance(const SolidModel& solid, const world::Level& level, const math::Vec3& place_world) {
  const math::Bounds& bounds = level.models[base::to_size(solid.model)].bounds;
  const math::Vec3 place = place_world - solid.origin;
  const float distance = glm::distance(place, glm::clamp(place, bounds.mins, bounds.maxs));
  return distance >= 0 ? distance : std::numeric_limits<float>::infinity();
}

}  // namespace

// Ties are broken by entity number, so that the choice does not depend on the sort.
void keep_nearest(std::vector<SolidModel>& io_solids, const world::Level& level,
                  const math::Vec3& place_world, std::size_t max_count) {
  if (io_solids.size() <= max_count) return;
  struct Ranked {
    float distance;
    SolidModel solid;
  };
  std::vector<Ranked> ranked;
  ranked.reserve(io_solids.size());
  for (const SolidModel& solid : io_solids)
    ranked.push_back({compute_distance(solid, level, place_world), solid});
  std::nth_element(ranked.begin(), ranked.begin() + static_cast<std::ptrdiff_t>(max_count), ranked.end(),
                   [](const Ranked& a, const Ranked& b) {
                     return std::pair(a.distance, a.solid.entity) < std::pair(b.distance, b.solid.entity);
                   });
  io_solids.clear();
  for (std::size_t i = 0; i < max_count; ++i) io_solids.push_back(ranked[i].solid);
  std::sort(io_solids.begin(), io_solids.end(),
            [](const SolidModel& a, const SolidModel& b) { return a.entity < b.entity; });
}

}  // namespace temblor::client
