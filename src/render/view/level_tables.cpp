#include "render/view/level_tables.h"

namespace temblor::render {

LevelTables make_level_tables(const world::Level& level) {
  LevelTables tables;
  tables.node_parent.assign(level.nodes.size(), LevelTables::kNoParent);
  tables.leaf_parent.assign(level.leaves.size(), LevelTables::kNoParent);
  // Only the world's tree is linked: brush models are drawn face by face. Iterative, because trees from files
  // may be deep; read_bsp guarantees that they have no cycles.
  std::vector<std::uint32_t> open;
  if (!level.world().head.is_leaf()) open.push_back(static_cast<std::uint32_t>(level.world().head.value));
  while (!open.empty()) {
    const std::uint32_t node = open.back();
    open.pop_back();
    for (const world::Child child : level.nodes[node].children) {
      if (child.is_leaf()) {
        tables.leaf_parent[base::to_size(child.leaf())] = node;
      } else {
        tables.node_parent[base::to_size(child.node())] = node;
        open.push_back(static_cast<std::uint32_t>(child.value));
      }
    }
  }
  return tables;
}

}  // namespace temblor::render
