// Tables that the renderer computes once for each level and then only reads: parent links of the BSP tree,
// which BSP files lack. They let the visibility stage mark the path from a leaf up to the root.
#pragma once

#include <cstdint>
#include <vector>

#include "world/level.h"

namespace temblor::render {

struct LevelTables {
  static constexpr std::uint32_t kNoParent = 0xffffffff;
  // Node indices, by node and by leaf. kNoParent for the root, and for nodes and leaves outside the world's
  // tree.
  std::vector<std::uint32_t> node_parent, leaf_parent;
};

LevelTables make_level_tables(const world::Level& level);

}  // namespace temblor::render
