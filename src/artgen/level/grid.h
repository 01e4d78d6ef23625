// Space cut into cells by planes across each axis: a plan as cells, and the same grown by a box for clip
// hulls.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "artgen/level/plan.h"
#include "math/vec.h"

namespace temblor::artgen {

struct Cell {
  std::int32_t contents;
  CellLook look;
  bool operator==(const Cell&) const = default;
};

using CellPosition = std::array<std::size_t, 3>;

// The cells from `first` up to, without, `last` on each axis.
struct CellRange {
  CellPosition first{}, last{};
};

struct CellGrid {
  std::array<std::vector<float>, 3> lines;  // where the planes cut each axis, ascending; cells lie between
  std::vector<Cell> cells;                  // x fastest, then y, then z

  std::size_t size(std::size_t axis) const { return lines[axis].size() - 1; }
  CellRange all() const { return {{}, {size(0), size(1), size(2)}}; }
  std::size_t index(const CellPosition& at) const { return (at[2] * size(1) + at[1]) * size(0) + at[0]; }
  const Cell& at(const CellPosition& position) const { return cells[index(position)]; }
  math::Bounds bounds(const CellRange& range) const;
};

// Paints the boxes over `background`, with one more layer of background around them. No cell is wider than
// `max_cell_units`.
CellGrid make_grid(std::span<const PlanBox> boxes, std::int32_t background, float max_cell_units);

// Solid wherever a box from `mins` to `maxs` around the point would touch solid or sky; empty elsewhere.
// `background`: what lies outside the grid.
CellGrid grow_grid(const CellGrid& grid, const math::Vec3& mins, const math::Vec3& maxs,
                   std::int32_t background);

}  // namespace temblor::artgen
