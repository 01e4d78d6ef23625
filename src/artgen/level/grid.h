// A grid of box-shaped cells between axial planes. It turns overlapping boxes into a partition of space, in
// which every cell has one contents, and it computes the clip hulls: a grid whose solid cells are expanded by
// a box's size. Used only for the generated small level; the compiler works on arbitrary brushes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "artgen/level/layout.h"
#include "math/vec.h"

namespace temblor::artgen {

// The contents of a cell, and the materials of its surfaces.
struct Cell {
  std::int32_t contents;
  CellLook look;
  bool operator==(const Cell&) const = default;
};

// A cell's indices on the x, y, and z axes. The same type addresses grid points, which have one more index on
// each axis.
using CellPosition = std::array<std::size_t, 3>;

// A box of cells: on each axis from `first` up to, but not including, `last`.
struct CellRange {
  CellPosition first{}, last{};
};

struct CellGrid {
  // The coordinates of the planes on each axis, ascending. Cell i lies between lines i and i + 1.
  std::array<std::vector<float>, 3> lines;
  // x varies fastest, then y, then z.
  std::vector<Cell> cells;

  // The number of cells on an axis.
  std::size_t size(std::size_t axis) const { return lines[axis].size() - 1; }
  CellRange all() const { return {{}, {size(0), size(1), size(2)}}; }
  std::size_t index(const CellPosition& at) const { return (at[2] * size(1) + at[1]) * size(0) + at[0]; }
  const Cell& at(const CellPosition& position) const { return cells[index(position)]; }
  math::Bounds bounds(const CellRange& range) const;
};

// Paints the boxes over `background` in their order, with one more layer of background cells on all sides.
// Additional planes keep cells from being wider than `max_cell_units`. `boxes` must not be empty.
CellGrid make_grid(std::span<const LayoutBox> boxes, std::int32_t background, float max_cell_units);

// Returns a grid in which a cell is solid if a box from `mins` to `maxs` around any of its points would touch
// solid or sky, and empty otherwise (a Minkowski sum, exact for axial planes). `background` is the contents
// outside the grid.
CellGrid grow_grid(const CellGrid& grid, const math::Vec3& mins, const math::Vec3& maxs,
                   std::int32_t background);

}  // namespace temblor::artgen
