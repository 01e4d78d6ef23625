// Leaf queries and the potentially visible set (PVS): the leaf at a point, and the leaves visible from a
// leaf. The vis compiler has computed the PVS as one compressed row of bits for each leaf. The renderer
// draws, and the server sends, only what is in the row of the viewer's leaf.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "world/level.h"

namespace temblor::world {

// Returns the leaf of the world's hull 0 that contains the point. A point on a plane counts as in front. Leaf
// 0 is solid.
LeafIndex find_leaf(const Level& level, const math::Vec3& point);

// A func_water of a Half-Life level: its model, and where it is now.
struct PlacedLiquid {
  ModelIndex model{};
  math::Vec3 origin{0.0f};
};

// The contents of that leaf. In an empty leaf of a Half-Life level, a func_water at the point counts: its
// liquid. Other brush models do not count. A func_water that is not in `placed` is where the level puts it.
Contents point_contents(const Level& level, const math::Vec3& point,
                        std::span<const PlacedLiquid> placed = {});

// Decompresses the PVS row of a leaf: one bit for each leaf, bit i for leaf i + 1 (leaf 0 is solid).
//
//   data: 05 00 03 80  ->  row: 05 00 00 00 80      a zero byte is followed by the number of zeros
//
// `out_row` is resized to (visible_leaf_count + 7) / 8 bytes, without an allocation if it has the capacity.
// Everything is visible from leaf 0, from leaves without an offset, and in levels without a PVS. If the data
// ends early, the rest of the row is invisible. Bits past visible_leaf_count are 0.
void decompress_pvs(const Level& level, LeafIndex from, std::vector<std::uint8_t>& out_row);

// Returns whether a decompressed row contains a leaf. Never true for leaf 0.
inline bool is_in_pvs(std::span<const std::uint8_t> row, LeafIndex leaf) {
  const std::size_t bit = base::to_size(leaf) - 1;
  return leaf != LeafIndex{0} && bit / 8 < row.size() && (row[bit / 8] >> (bit % 8) & 1) != 0;
}

}  // namespace temblor::world
