// Builds a BSP tree over a grid of cells. Its planes are the grid's lines, and each leaf is a box of cells
// with the same contents.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "artgen/level/grid.h"

namespace temblor::artgen {

struct GridTree {
  struct Node {
    std::size_t axis;
    // The index of the splitting line on that axis.
    std::size_t line;
    CellRange range;
    // The side above the line, then the side below. A negative child is leaf ~child.
    std::array<std::int32_t, 2> children;
  };
  struct Leaf {
    std::int32_t contents;
    CellRange range;
  };
  // The root is node 0.
  std::vector<Node> nodes;
  // Every box of cells is a leaf of its own, also solid ones.
  std::vector<Leaf> leaves;
};

// CHECKs that the grid contains at least two different contents, because a tree has at least one node.
GridTree build_grid_tree(const CellGrid& grid);

}  // namespace temblor::artgen
