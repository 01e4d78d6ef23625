// The palette's colour nearest to any other, exactly, at a few comparisons each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "formats/palette.h"

namespace temblor::formats {

// What the palette's indices mean, whatever its colours.
constexpr std::size_t kFirstFullbright = 224;    // from here on colours shine in the dark
constexpr std::uint8_t kTransparentIndex = 255;  // in pictures and in textures named {...

// Searches `count` colours of the palette from `first` on, at least one. Making one takes milliseconds.
class NearestColour {
 public:
  NearestColour(const Palette& palette, std::size_t first, std::size_t count);

  // By squared distance of RGB; the lowest index where several are as near.
  std::uint8_t find(Rgb colour) const;

 private:
  std::span<const std::uint8_t> candidates_near(Rgb colour) const;

  Palette palette_;
  // The indices that are nearest to some colour in each cell of a regular grid over RGB, cell after cell.
  std::vector<std::uint8_t> candidates_;
  std::vector<std::uint32_t> first_candidates_;  // by cell, and the end
};

}  // namespace temblor::formats
