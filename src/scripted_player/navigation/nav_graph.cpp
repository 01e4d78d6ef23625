#include "scripted_player/navigation/nav_graph.h"

#include <algorithm>
#include <cmath>

#include "movement/player.h"
#include "scripted_player/navigation/flood.h"

namespace temblor::player {

NavGraph::NavGraph(const NavSpace& space, std::span<const math::Vec3> starts, const GraphLimits& limits) {
  // One empty row or column on each side, so that positions just outside the level have a cell, too.
  const math::Bounds& bounds = space.level().world().bounds;
  low_ = glm::floor(bounds.mins / static_cast<float>(kCell_units)) * static_cast<float>(kCell_units) -
         static_cast<float>(kCell_units);
  const math::Vec3 size = (bounds.maxs - low_) / static_cast<float>(kCell_units);
  width_ = static_cast<int>(size.x) + 3;
  height_ = static_cast<int>(size.y) + 3;
  cells_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  Flood(space, limits, *this).run(starts);
}

int NavGraph::grid_row(float along, float low, int rows) {
  // fmax() before fmin(): this order turns NaN into 0.
  return static_cast<int>(
      std::fmin(std::fmax((along - low) / kCell_units, 0.0f), static_cast<float>(rows - 1)));
}

std::size_t NavGraph::cell_index(const math::Vec3& at) const {
  const int x = grid_row(at.x, low_.x, width_), y = grid_row(at.y, low_.y, height_);
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
}

std::size_t NavGraph::link_count() const {
  std::size_t count = 0;
  for (const Place& place : places_) count += place.links.size();
  return count;
}

int NavGraph::find_nearest(const math::Vec3& at, float within_units,
                           base::FunctionRef<bool(const Place&)> is_there) const {
  const int reach = static_cast<int>(std::ceil(within_units / kCell_units));
  int best = -1;
  float best_distance = within_units;
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx) {
      const math::Vec3 cell = at + math::Vec3(dx, dy, 0) * static_cast<float>(kCell_units);
      if (cell.x < low_.x || cell.y < low_.y) continue;
      for (const std::uint32_t i : cells_[cell_index(cell)]) {
        const math::Vec3 offset = places_[i].at - at;
        // Height counts more, because a place on another floor is a long walk away.
        const float distance = std::max(glm::length(math::Vec2(offset)), 1.5f * std::abs(offset.z));
        if (distance < best_distance && is_there(places_[i])) {
          best_distance = distance;
          best = static_cast<int>(i);
        }
      }
    }
  return best;
}

// Two boxes touch if one's center is in the other one expanded by its size, so expand `box` and test only
// origins.
std::vector<std::uint32_t> NavGraph::find_touching(const math::Bounds& box, float grown) const {
  std::vector<std::uint32_t> found;
  const math::Vec3 low = box.mins - movement::kPlayerMaxs - grown;
  const math::Vec3 high = box.maxs - movement::kPlayerMins + grown;
  const int last_x = grid_row(high.x, low_.x, width_), last_y = grid_row(high.y, low_.y, height_);
  for (int y = grid_row(low.y, low_.y, height_); y <= last_y; ++y)
    for (int x = grid_row(low.x, low_.x, width_); x <= last_x; ++x)
      for (const std::uint32_t i : cells_[static_cast<std::size_t>(y * width_ + x)]) {
        const math::Vec3& at = places_[i].at;
        if (glm::all(glm::greaterThanEqual(at, low)) && glm::all(glm::lessThanEqual(at, high)))
          found.push_back(i);
      }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace temblor::player
