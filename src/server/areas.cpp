// Method: intrusive lists, one for each part and kind, so that linking, moving and unlinking cost the same
// however many entities there are. Shape and order are those of the original, which decides who is touched
// first.
#include "server/areas.h"

namespace temblor::server {
namespace {

// Boxes that share no more than a side touch. With NaN nothing does.
bool touches(const math::Bounds& a, const math::Bounds& b) {
  return a.mins.x <= b.maxs.x && a.maxs.x >= b.mins.x && a.mins.y <= b.maxs.y && a.maxs.y >= b.mins.y &&
         a.mins.z <= b.maxs.z && a.maxs.z >= b.mins.z;
}

}  // namespace

Areas::Areas(const math::Bounds& world_bounds) {
  cut(0, world_bounds, kCuts);
}

void Areas::cut(std::size_t part, const math::Bounds& bounds, int cuts_left) {
  if (cuts_left == 0) return;
  const math::Vec3 size = bounds.maxs - bounds.mins;
  const int axis = size.x > size.y ? 0 : 1;
  const float distance = 0.5f * (bounds.maxs[axis] + bounds.mins[axis]);
  parts_[part] = {axis, distance, true};
  math::Bounds upper = bounds, lower = bounds;
  upper.mins[axis] = lower.maxs[axis] = distance;
  cut(2 * part + 1, upper, cuts_left - 1);
  cut(2 * part + 2, lower, cuts_left - 1);
}

std::size_t Areas::part_of(const math::Bounds& box) const {
  std::size_t part = 0;
  while (parts_[part].is_cut) {
    const auto [axis, distance, unused] = parts_[part];
    if (box.mins[axis] > distance)
      part = 2 * part + 1;
    else if (box.maxs[axis] < distance)
      part = 2 * part + 2;
    else
      break;
  }
  return part;
}

void Areas::link(vm::EntityIndex entity, const math::Bounds& box, AreaKind kind) {
  unlink(entity);
  const std::size_t i = base::to_size(entity);
  if (i >= links_.size()) links_.resize(i + 1);
  const std::size_t list_index = 2 * part_of(box) + (kind == AreaKind::kTrigger ? 1 : 0);
  List& list = lists_[list_index];
  links_[i] = {box, list.last, kNone, static_cast<std::uint32_t>(list_index)};
  const auto number = static_cast<std::uint32_t>(entity);
  (list.last == kNone ? list.first : links_[list.last].behind) = number;
  list.last = number;
}

void Areas::unlink(vm::EntityIndex entity) {
  const std::size_t i = base::to_size(entity);
  if (i >= links_.size() || links_[i].list == kNone) return;
  const Link link = links_[i];
  List& list = lists_[link.list];
  (link.before == kNone ? list.first : links_[link.before].behind) = link.behind;
  (link.behind == kNone ? list.last : links_[link.behind].before) = link.before;
  links_[i].list = kNone;
}

void Areas::find(const math::Bounds& box, AreaKind kind, std::vector<vm::EntityIndex>& io_found) const {
  find_below(0, box, kind, io_found);
}

void Areas::find_below(std::size_t part, const math::Bounds& box, AreaKind kind,
                       std::vector<vm::EntityIndex>& io_found) const {
  const List& list = lists_[2 * part + (kind == AreaKind::kTrigger ? 1 : 0)];
  for (std::uint32_t i = list.first; i != kNone; i = links_[i].behind)
    if (touches(links_[i].box, box)) io_found.push_back(vm::EntityIndex{i});
  const auto [axis, distance, is_cut] = parts_[part];
  if (!is_cut) return;
  if (box.maxs[axis] > distance) find_below(2 * part + 1, box, kind, io_found);
  if (box.mins[axis] < distance) find_below(2 * part + 2, box, kind, io_found);
}

}  // namespace temblor::server
