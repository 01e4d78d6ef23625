// Exact nearest-color search in a palette, for tools that convert images and compute mip levels.
//
// Method: divide the RGB cube into 16 x 16 x 16 cells. Each cell stores the few palette colors that can be
// the nearest to any of its points, so a lookup takes a few comparisons instead of 256. A color can be
// nearest only if its distance to the nearest point of the cell is at most the smallest distance of any color
// to the farthest point.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "formats/images/palette.h"

namespace temblor::formats {

// Fixed meanings of palette indices.
constexpr std::size_t kFirstFullbright = 224;    // this index and higher ones ignore light
constexpr std::uint8_t kTransparentIndex = 255;  // in pictures and in textures named {...

// Searches the `count` (at least 1) palette colors from index `first`. Construction takes about half a
// millisecond.
class NearestColor {
 public:
  NearestColor(const Palette& palette, std::size_t first, std::size_t count);

  // Returns the nearest color by squared RGB distance; ties go to the lowest index.
  std::uint8_t find(Rgb color) const;

 private:
  // A palette color.
  struct Candidate {
    std::int16_t r, g, b;
    std::uint8_t index;
  };
  struct Cell {
    int r, g, b, size;  // lowest values, and size in each channel
  };
  struct Range {
    std::uint32_t begin = 0, end = 0;  // in candidates_
  };
  // Finds the colors of `among` that can be the nearest somewhere in each part of the cell, and divides the
  // parts until they are fine.
  void divide(const Cell& cell, std::span<const Candidate> among, std::size_t level);

  std::vector<Candidate> candidates_;  // of all cells; by palette index within a cell
  std::vector<Range> cells_;           // index order: red, green, blue (fastest)
};

}  // namespace temblor::formats
