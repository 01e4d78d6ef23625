// A grid as a tree of splitting planes whose leaves are boxes of one contents.
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
    std::size_t line;  // of the grid, on that axis
    CellRange range;
    std::array<std::int32_t, 2> children;  // the side above the line, the side below; negative: leaf ~child
  };
  struct Leaf {
    std::int32_t contents;
    CellRange range;
  };
  std::vector<Node> nodes;   // the root first
  std::vector<Leaf> leaves;  // each box its own, solid ones too
};

// The grid must have cells of more than one contents.
GridTree build_grid_tree(const CellGrid& grid);

}  // namespace temblor::artgen
