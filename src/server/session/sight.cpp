#include "server/session/sight.h"

#include <algorithm>

#include "world/visibility.h"

namespace temblor::server {

// Walks the BSP tree, into both sides of planes that are nearer than the margin.
void Sight::update(const world::Level& level, const math::Vec3& eye) {
  row_.assign((level.visible_leaf_count + 7) / 8, 0);
  to_visit_.assign(1, level.world().head);
  bool is_outside = true;
  while (!to_visit_.empty()) {
    const world::Child child = to_visit_.back();
    to_visit_.pop_back();
    if (!child.is_leaf()) {
      const world::Node& node = level.node(child.node());
      const double distance = world::distance_to(level.planes[node.plane], math::Vec3d(eye));
      if (distance > -kFat_units) to_visit_.push_back(node.children[0]);
      if (distance < kFat_units) to_visit_.push_back(node.children[1]);
      continue;
    }
    if (level.leaf(child.leaf()).contents == world::Contents::kSolid) continue;
    is_outside = false;
    world::decompress_pvs(level, child.leaf(), one_);
    for (std::size_t i = 0; i < row_.size(); ++i) row_[i] |= one_[i];
  }
  if (is_outside) std::fill(row_.begin(), row_.end(), std::uint8_t{255});
}

bool Sight::sees(const EdictState& state) const {
  if (state.is_in_too_many_leaves) return true;
  for (const world::LeafIndex leaf : state.leaves)
    if (world::is_in_pvs(row_, leaf)) return true;
  return false;
}

bool Sight::sees(const world::Level& level, const math::Vec3& place) const {
  // The middle of a button or door may be inside the wall that it is set into.
  const world::LeafIndex leaf = world::find_leaf(level, place);
  return leaf == world::LeafIndex{0} || world::is_in_pvs(row_, leaf);
}

}  // namespace temblor::server
