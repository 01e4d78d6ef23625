#include "world/hull_cells.h"

#include <algorithm>
#include <cmath>

namespace temblor::world {
namespace {

// The size of a cell. A level with more than kMaxCells such cells has larger ones.
constexpr float kMinCell_units = 32;
constexpr float kMaxCells = 1 << 20;
// A box is this much larger than its cell on each side, so that short paths from the cell stay inside.
constexpr float kMargin_units = 16;
// Slack for rounding: a plane this close to the box cuts it.
constexpr double kNear_units = 0.125;

// The signed distances of the corner nearest to the plane's back, and of the one farthest in front.
struct Range {
  double low, high;
};
Range distance_range(const Plane& plane, const math::Bounds& box) {
  math::Vec3d low, high;
  for (int axis = 0; axis < 3; ++axis) {
    const bool is_forward = plane.normal[axis] >= 0;
    low[axis] = is_forward ? box.mins[axis] : box.maxs[axis];
    high[axis] = is_forward ? box.maxs[axis] : box.mins[axis];
  }
  return {distance_to(plane, low), distance_to(plane, high)};
}

bool is_inside(const math::Bounds& box, const math::Vec3& point) {
  return point.x >= box.mins.x && point.y >= box.mins.y && point.z >= box.mins.z && point.x <= box.maxs.x &&
         point.y <= box.maxs.y && point.z <= box.maxs.z;
}

}  // namespace

HullCells::HullCells(const Level& level, ModelIndex model, Hull hull)
    : level_(&level), model_(model), hull_(hull), low_(level.models[base::to_size(model)].bounds.mins) {
  const math::Vec3 size = level.models[base::to_size(model)].bounds.maxs - low_;
  const auto count = [&](int axis) { return std::floor(std::max(size[axis], 0.0f) / cell_units_) + 1; };
  cell_units_ = kMinCell_units;
  while (count(0) * count(1) * count(2) > kMaxCells) cell_units_ *= 2;
  for (int axis = 0; axis < 3; ++axis)
    counts_[static_cast<std::size_t>(axis)] = static_cast<int>(count(axis));
  cells_.resize(static_cast<std::size_t>(counts_[0] * counts_[1] * counts_[2]));
}

// Returns the new tree's head. The depth of a level's trees is limited (formats/levels/bsp_validate.h).
std::int32_t HullCells::copy_part(std::int32_t node, const math::Bounds& box) {
  const bool is_drawn = hull_ == Hull::kPoint;
  while (node >= 0) {
    const auto i = static_cast<std::size_t>(node);
    const std::uint32_t plane = is_drawn ? level_->nodes[i].plane : level_->clipnodes[i].plane;
    const std::array<std::int32_t, 2> children =
        is_drawn ? std::array{level_->nodes[i].children[0].value, level_->nodes[i].children[1].value}
                 : level_->clipnodes[i].children;
    const Range range = distance_range(level_->planes[plane], box);
    if (range.low > kNear_units) {
      node = children[0];
    } else if (range.high < -kNear_units) {
      node = children[1];
    } else {
      const std::int32_t front = copy_part(children[0], box);
      const std::int32_t back = copy_part(children[1], box);
      if (front < 0 && front == back) return front;
      clipnodes_.push_back({plane, {front, back}});
      return static_cast<std::int32_t>(clipnodes_.size() - 1);
    }
  }
  return is_drawn ? static_cast<std::int32_t>(level_->leaf(Child{node}.leaf()).contents) : node;
}

// Makes the cell of a point the current one; returns false if there is none.
bool HullCells::enter_cell(const math::Vec3& at) {
  std::size_t number = 0;
  math::Bounds box;
  for (int axis = 2; axis >= 0; --axis) {
    const int count = counts_[static_cast<std::size_t>(axis)];
    const float along = (at[axis] - low_[axis]) / cell_units_;
    if (!(along >= 0 && along < static_cast<float>(count))) return false;  // negated because of NaN
    const int cell = static_cast<int>(along);
    const float corner = low_[axis] + static_cast<float>(cell) * cell_units_;
    box.mins[axis] = corner - kMargin_units;
    box.maxs[axis] = corner + cell_units_ + kMargin_units;
    number = number * static_cast<std::size_t>(count) + static_cast<std::size_t>(cell);
  }
  Cell& cell = cells_[number];
  if (!cell.is_made) {
    const Model& model = level_->models[base::to_size(model_)];
    cell.head = copy_part(
        hull_ == Hull::kPoint ? model.head.value : model.clip_heads[static_cast<std::size_t>(hull_) - 1],
        box);
    cell.is_made = true;
  }
  box_ = box;
  head_ = cell.head;
  return true;
}

// Most paths follow the last one, so they are in the same box.
std::optional<HullPart> HullCells::find_part(const math::Vec3& start, const math::Vec3& end) {
  const auto is_in_box = [&] { return is_inside(box_, start) && is_inside(box_, end); };
  if (!is_in_box() && !(enter_cell(start) && is_in_box())) return std::nullopt;
  return HullPart{clipnodes_, head_};
}

Trace HullCells::trace_line(const math::Vec3& start, const math::Vec3& end) {
  if (const std::optional<HullPart> part = find_part(start, end))
    return world::trace_line(*level_, *part, start, end);
  return world::trace_line(*level_, model_, hull_, start, end);
}

Contents HullCells::contents(const math::Vec3& point) {
  if (const std::optional<HullPart> part = find_part(point, point))
    return world::hull_contents(*level_, *part, point);
  return world::hull_contents(*level_, model_, hull_, point);
}

}  // namespace temblor::world
