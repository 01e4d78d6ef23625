// The palette's color nearest to any other, exactly, at a few comparisons each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "formats/images/palette.h"

namespace temblor::formats {

// What the palette's indices mean, whatever its colors.
constexpr std::size_t kFirstFullbright = 224;    // from here on colors shine in the dark
constexpr std::uint8_t kTransparentIndex = 255;  // in pictures and in textures named {...

// Searches `count` colors of the palette from `first` on, at least one. Making one takes a millisecond
// or two. The color cube is cut into cells, and each knows the few colors that can be nearest to a point in
// it.
class NearestColor {
 public:
  NearestColor(const Palette& palette, std::size_t first, std::size_t count);

  // By squared distance of RGB; the lowest index where several are as near.
  std::uint8_t find(Rgb color) const;

 private:
  struct Candidate {
    std::int16_t r, g, b;
    std::uint8_t index;
  };
  struct Cell {
    int r, g, b, size;  // lowest values, and how many of each channel
  };
  struct Range {
    std::uint32_t begin = 0, end = 0;  // in candidates_
  };
  static void add_candidates(const Cell& cell, std::span<const Candidate> among,
                             std::vector<Candidate>& io_found);

  std::vector<Candidate> candidates_;  // of every cell, by increasing index
  std::vector<Range> cells_;           // by red, green, blue, the last fastest
};

}  // namespace temblor::formats
