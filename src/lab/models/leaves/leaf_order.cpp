#include "lab/models/leaves/leaf_order.h"

#include <algorithm>

namespace temblor::lab {

LeafOrder::LeafOrder(const world::Level& level, const math::Vec3d& eye_world,
                     const render::VisibleFaces& visible, base::Arena& arena)
    : places_(arena.allocate_filled(2 * level.nodes.size(), LeafPlace{0, kBehindAll})) {
  const std::span<render::SortKey> face_keys =
      arena.allocate_filled<render::SortKey>(level.faces.size(), kBehindAll);
  for (const render::VisibleFace& face : visible.faces) face_keys[base::to_size(face.face)] = face.key;

  // Nodes whose far side is still to be painted, or, after that, whose faces and near side are.
  struct Open {
    world::NodeIndex node;
    bool is_far_done;
  };
  base::ArenaVector<Open> open(arena, 256);
  std::uint32_t order = 0;
  render::SortKey behind = kBehindAll;
  const auto enter = [&](world::NodeIndex parent, std::size_t side) {
    const world::Child child = level.node(parent).children[side];
    if (!child.is_leaf()) {
      open.push_back({child.node(), false});
      return;
    }
    const auto leaf = base::to_size(child.leaf());
    if (leaf < visible.leaf_keys.size() && visible.leaf_keys[leaf] != render::kNotVisited)
      behind = std::min(behind, visible.leaf_keys[leaf]);
    places_[2 * base::to_size(parent) + side] = {order++, behind};
  };
  if (!level.world().head.is_leaf()) open.push_back({level.world().head.node(), false});
  while (!open.view().empty()) {
    const Open now = open.view().back();
    open.pop_back();
    const world::Node& node = level.node(now.node);
    const std::size_t near = world::distance_to(level.planes[node.plane], eye_world) >= 0 ? 0 : 1;
    if (!now.is_far_done) {
      open.push_back({now.node, true});
      enter(now.node, 1 - near);
      continue;
    }
    for (std::uint32_t face = node.first_face; face < node.first_face + node.face_count; ++face)
      behind = std::min(behind, face_keys[face]);
    enter(now.node, near);
  }
}

}  // namespace temblor::lab
