// The tree and the potentially visible set: which leaf a point lies in, and which leaves that leaf can see.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "world/level.h"

namespace temblor::world {

// The leaf of the world's hull 0 that holds the point; points on a plane belong to its front. Leaf 0 is
// solid.
LeafIndex find_leaf(const Level& level, const math::Vec3& point);
Contents point_contents(const Level& level, const math::Vec3& point);

// One bit a leaf: bit i stands for leaf i + 1. `out_row` gets (visible_leaf_count + 7) / 8 bytes, resized if
// needed (no allocation when it has the capacity). Everything is visible from leaf 0, from leaves without an
// offset, and in levels without a PVS. A row cut short by the end of the data sees nothing more; bits past
// visible_leaf_count are 0.
void decompress_pvs(const Level& level, LeafIndex from, std::vector<std::uint8_t>& out_row);

inline bool pvs_has(std::span<const std::uint8_t> row, LeafIndex leaf) {
  const std::size_t bit = base::to_size(leaf) - 1;
  return leaf != LeafIndex{0} && bit / 8 < row.size() && (row[bit / 8] >> (bit % 8) & 1) != 0;
}

}  // namespace temblor::world
