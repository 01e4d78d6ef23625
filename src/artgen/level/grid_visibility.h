// Which leaves of a grid can see each other, never too few.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "artgen/level/grid.h"
#include "artgen/level/grid_tree.h"

namespace temblor::artgen {

// For each of `leaves`, one bit for each of them (bit i of byte i / 8 first): whether a straight line leads
// from the one to the other. Conservative: a line runs one way along each axis, so every cell that it can
// reach is found by steps that never turn back.
std::vector<std::vector<std::uint8_t>> visible_leaves(const CellGrid& grid,
                                                      std::span<const GridTree::Leaf> leaves);

// A row as levels store it: zero bytes run-length coded.
std::vector<std::uint8_t> compress_row(std::span<const std::uint8_t> row);

}  // namespace temblor::artgen
