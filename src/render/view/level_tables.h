// What the renderer works out once for a level and then only reads.
#pragma once

#include <cstdint>
#include <vector>

#include "world/level.h"

namespace temblor::render {

struct LevelTables {
  static constexpr std::uint32_t kNoParent = 0xffffffff;
  std::vector<std::uint32_t> node_parent, leaf_parent;  // nodes
};

LevelTables make_level_tables(const world::Level& level);

}  // namespace temblor::render
