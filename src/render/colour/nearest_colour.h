// The palette entry that looks most like a colour.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "formats/palette.h"

namespace temblor::render {

// Exact: the entry with the smallest squared distance in red, green and blue, the lowest index where several
// are as near. The colour cube is cut into cells, and each knows the few entries that can be nearest to a
// point in it.
class NearestColour {
 public:
  // Only of the entries `eligible`: at least one, increasing.
  NearestColour(const formats::Palette& palette, std::span<const std::uint8_t> eligible);

  std::uint8_t operator()(formats::Rgb colour) const;

 private:
  static constexpr int kCellBits = 4;  // of each channel: 16 cells each way
  static constexpr int kCells = 1 << kCellBits, kCellSize = 256 / kCells;
  struct Candidate {
    std::int16_t r, g, b;
    std::uint8_t index;
  };
  std::vector<Candidate> candidates_;                                             // cell by cell
  std::array<std::uint32_t, std::size_t{kCells} * kCells * kCells + 1> begin_{};  // into candidates_, by cell
};

}  // namespace temblor::render
