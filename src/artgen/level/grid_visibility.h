// Computes which leaves of a grid can see each other, and compresses the result as BSP files store it. It may
// call hidden leaves visible, but never the reverse.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "artgen/level/grid.h"
#include "artgen/level/grid_tree.h"

namespace temblor::artgen {

// Returns a row for each of `leaves`, with one bit per leaf (leaf i is bit i % 8 of byte i / 8) that is set
// if a straight line may connect the two. Method: a straight line moves in one direction only on each axis.
// For each of the 8 combinations of directions, a flood fill from the leaf's cells marks every cell that
// steps in those directions can reach through open cells.
std::vector<std::vector<std::uint8_t>> find_visible_leaves(const CellGrid& grid,
                                                           std::span<const GridTree::Leaf> leaves);

// A row as BSP files store it: each run of zero bytes becomes a zero and the run's length.
std::vector<std::uint8_t> compress_row(std::span<const std::uint8_t> row);

}  // namespace temblor::artgen
