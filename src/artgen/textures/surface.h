// A texture while it is painted. Each texel has a color, a height above the wall, and the piece of the wall
// (a brick, a board) that it belongs to; layers read and change them. All grids wrap around at their sides,
// so every texture tiles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "artgen/palette.h"

namespace temblor::artgen {

// A two-dimensional array whose coordinates wrap around.
template <typename T>
struct Grid {
  Grid(std::int32_t columns, std::int32_t rows, T value = {})
      : width(columns),
        height(rows),
        cells(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), value) {}

  // Any coordinates are valid; they are wrapped.
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

// The state of one texel. Palette indices are computed only at the end, so layers can add and subtract tones
// freely.
struct Texel {
  Ramp ramp = Ramp::kGray;
  // The position on the ramp: 0 is dark, 1 bright. Values outside are clamped at the end.
  double tone = 0.5;
  // In texels, toward the viewer. The `relief` layer turns it into shading.
  double height = 0;
  // Transparent, for textures whose name begins with "{".
  bool hole = false;
  // The number of the piece; set by structure layers.
  std::int32_t piece = 0;
  // The distance in texels to the edge of the piece; 0 or less in the joints.
  double rim = 1e9;
};

using Surface = Grid<Texel>;

// How far inside a shape each texel lies: the distance in texels to the shape's edge, 0 or less outside.
using Cover = Grid<double>;

// Whether the engine draws the ramp's colors without light.
bool is_fullbright(Ramp ramp);

// Row by row; holes become kTransparent.
std::vector<std::uint8_t> to_palette_indices(const Surface& surface);

}  // namespace temblor::artgen
