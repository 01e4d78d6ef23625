// Each part has an intrusive list, so that the cost of linking does not depend on the number of entities. The
// tree of triggers is as deep as the original's, because it decides which trigger is touched first. Every
// trace searches the solids, so their tree is deeper.
#include "server/game/areas.h"

namespace temblor::server {
namespace {

constexpr int kTriggerCuts = 4, kSolidCuts = 8;

// Boxes that share only a side touch, too. A box with NaN touches nothing.
bool touches(const math::Bounds& a, const math::Bounds& b) {
  return a.mins.x <= b.maxs.x && a.maxs.x >= b.mins.x && a.mins.y <= b.maxs.y && a.maxs.y >= b.mins.y &&
         a.mins.z <= b.maxs.z && a.maxs.z >= b.mins.z;
}

}  // namespace

Areas::Areas(const math::Bounds& world_bounds)
    : trees_{Tree(world_bounds, kSolidCuts), Tree(world_bounds, kTriggerCuts)} {}

// A full binary tree with `cuts` levels of cuts has 2^(cuts + 1) - 1 parts.
Areas::Tree::Tree(const math::Bounds& bounds, int cuts) : parts((std::size_t{2} << cuts) - 1) {
  cut(0, bounds, cuts);
}

// Cuts along x or y only: levels are wide and flat.
void Areas::Tree::cut(std::size_t part, const math::Bounds& bounds, int cuts_left) {
  if (cuts_left == 0) return;
  const math::Vec3 size = bounds.maxs - bounds.mins;
  const int axis = size.x > size.y ? 0 : 1;
  const float distance = 0.5f * (bounds.maxs[axis] + bounds.mins[axis]);
  parts[part].axis = axis;
  parts[part].distance = distance;
  parts[part].is_cut = true;
  math::Bounds upper = bounds, lower = bounds;
  upper.mins[axis] = lower.maxs[axis] = distance;
  cut(2 * part + 1, upper, cuts_left - 1);
  cut(2 * part + 2, lower, cuts_left - 1);
}

std::size_t Areas::Tree::find_part(const math::Bounds& box) const {
  std::size_t part = 0;
  while (parts[part].is_cut) {
    const Part& here = parts[part];
    if (box.mins[here.axis] > here.distance)
      part = 2 * part + 1;
    else if (box.maxs[here.axis] < here.distance)
      part = 2 * part + 2;
    else
      break;
  }
  return part;
}

// Appends at the end of the list: the order of linking is the order in which triggers are touched.
void Areas::link(vm::EntityIndex entity, const math::Bounds& box, AreaKind kind) {
  unlink(entity);
  const std::size_t i = base::to_size(entity);
  if (i >= links_.size()) links_.resize(i + 1);
  Tree& tree = trees_[static_cast<std::size_t>(kind)];
  const std::size_t part_index = tree.find_part(box);
  Part& part = tree.parts[part_index];
  links_[i] = {box, part.last, kNone, static_cast<std::uint32_t>(part_index), kind};
  const auto number = static_cast<std::uint32_t>(entity);
  (part.last == kNone ? part.first : links_[part.last].next) = number;
  part.last = number;
}

void Areas::unlink(vm::EntityIndex entity) {
  const std::size_t i = base::to_size(entity);
  if (i >= links_.size() || links_[i].part == kNone) return;
  const Link link = links_[i];
  Part& part = trees_[static_cast<std::size_t>(link.kind)].parts[link.part];
  (link.previous == kNone ? part.first : links_[link.previous].next) = link.next;
  (link.next == kNone ? part.last : links_[link.next].previous) = link.previous;
  links_[i].part = kNone;
}

void Areas::find(const math::Bounds& box, AreaKind kind, std::vector<vm::EntityIndex>& io_found) const {
  find_below(trees_[static_cast<std::size_t>(kind)], 0, box, io_found);
}

// Visits a part before its halves, and the upper half before the lower one. A box that only touches a cut
// needs neither half beyond it: boxes in there are strictly on their side.
void Areas::find_below(const Tree& tree, std::size_t part_index, const math::Bounds& box,
                       std::vector<vm::EntityIndex>& io_found) const {
  const Part& part = tree.parts[part_index];
  for (std::uint32_t i = part.first; i != kNone; i = links_[i].next)
    if (touches(links_[i].box, box)) io_found.push_back(vm::EntityIndex{i});
  if (!part.is_cut) return;
  if (box.maxs[part.axis] > part.distance) find_below(tree, 2 * part_index + 1, box, io_found);
  if (box.mins[part.axis] < part.distance) find_below(tree, 2 * part_index + 2, box, io_found);
}

}  // namespace temblor::server
