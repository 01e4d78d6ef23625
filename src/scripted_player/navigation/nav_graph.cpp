#include "scripted_player/navigation/nav_graph.h"

#include <algorithm>
#include <cmath>

#include "movement/player.h"
#include "scripted_player/navigation/flood.h"

namespace temblor::player {

NavGraph::NavGraph(const NavSpace& space, std::span<const math::Vec3> starts, const GraphLimits& limits) {
  const math::Bounds& bounds = space.level().world().bounds;
  low_ = glm::floor(bounds.mins / static_cast<float>(kCell_units)) * static_cast<float>(kCell_units) -
         static_cast<float>(kCell_units);
  const math::Vec3 size = (bounds.maxs - low_) / static_cast<float>(kCell_units);
  width_ = static_cast<int>(size.x) + 3;
  height_ = static_cast<int>(size.y) + 3;
  cells_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  Flood(space, limits, *this).run(starts);
}

int NavGraph::row_of(float along, float low, int rows) {
  // In this order what is no number is 0.
  return static_cast<int>(
      std::fmin(std::fmax((along - low) / kCell_units, 0.0f), static_cast<float>(rows - 1)));
}

std::size_t NavGraph::cell_of(const math::Vec3& at) const {
  const int x = row_of(at.x, low_.x, width_), y = row_of(at.y, low_.y, height_);
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
}

std::size_t NavGraph::ways() const {
  std::size_t count = 0;
  for (const Place& place : places_) count += place.ways.size();
  return count;
}

int NavGraph::nearest(const math::Vec3& at, float within_units,
                      base::FunctionRef<bool(const Place&)> is_there) const {
  const int reach = static_cast<int>(std::ceil(within_units / kCell_units));
  int best = -1;
  float best_distance = within_units;
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx) {
      const math::Vec3 cell = at + math::Vec3(dx, dy, 0) * static_cast<float>(kCell_units);
      if (cell.x < low_.x || cell.y < low_.y) continue;
      for (const std::uint32_t i : cells_[cell_of(cell)]) {
        const math::Vec3 way = places_[i].at - at;
        // Another floor is farther than it looks.
        const float distance = std::max(glm::length(math::Vec2(way)), 1.5f * std::abs(way.z));
        if (distance < best_distance && is_there(places_[i])) {
          best_distance = distance;
          best = static_cast<int>(i);
        }
      }
    }
  return best;
}

std::vector<std::uint32_t> NavGraph::touching(const math::Bounds& box, float grown) const {
  std::vector<std::uint32_t> found;
  const math::Vec3 low = box.mins - movement::kPlayerMaxs - grown;
  const math::Vec3 high = box.maxs - movement::kPlayerMins + grown;
  const int last_x = row_of(high.x, low_.x, width_), last_y = row_of(high.y, low_.y, height_);
  for (int y = row_of(low.y, low_.y, height_); y <= last_y; ++y)
    for (int x = row_of(low.x, low_.x, width_); x <= last_x; ++x)
      for (const std::uint32_t i : cells_[static_cast<std::size_t>(y * width_ + x)]) {
        const math::Vec3& at = places_[i].at;
        if (glm::all(glm::greaterThanEqual(at, low)) && glm::all(glm::lessThanEqual(at, high)))
          found.push_back(i);
      }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace temblor::player
