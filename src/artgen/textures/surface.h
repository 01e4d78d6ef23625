// What a texture is while it is painted: for each texel its color, how far it stands out, and which piece of
// the wall (a brick, a board) it belongs to. Sides wrap: what leaves at the right comes in at the left.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "artgen/palette.h"

namespace temblor::artgen {

template <typename T>
struct Grid {
  Grid(std::int32_t columns, std::int32_t rows, T value = {})
      : width(columns),
        height(rows),
        cells(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), value) {}

  // Any x and y: wrapped.
  T& at(std::int32_t x, std::int32_t y) { return cells[index(x, y)]; }
  const T& at(std::int32_t x, std::int32_t y) const { return cells[index(x, y)]; }

  std::int32_t width, height;
  std::vector<T> cells;  // row by row from the top

 private:
  std::size_t index(std::int32_t x, std::int32_t y) const {
    const std::int32_t column = (x % width + width) % width, row = (y % height + height) % height;
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  }
};

struct Texel {
  Ramp ramp = Ramp::kGray;
  double tone = 0.5;  // along the ramp, 0 dark to 1 bright; outside counts as the nearest
  double height = 0;  // texels towards the eye
  bool hole = false;  // transparent
  std::int32_t piece = 0;
  double rim = 1e9;  // texels to the piece's edge; 0 or less in the joints
};

using Surface = Grid<Texel>;

// Which texels a layer covers, and how deep they lie in it: texels from its edge, 0 or less outside.
using Cover = Grid<double>;

bool is_fullbright(Ramp ramp);

// The palette's indices, row by row.
std::vector<std::uint8_t> indices_of(const Surface& surface);

}  // namespace temblor::artgen
