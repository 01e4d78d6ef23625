// Bitmap glyphs of up to 8 x 8 dots, for the console font and for small writing in pictures.
//
//   glyph A
//     ..xx....
//     .x..x...           x is ink; at most 8 rows of at most 8 dots
//   glyph 18 like=0      a copy; codes have two or more digits
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>

#include "artgen/scripts/script.h"
#include "base/result.h"

namespace temblor::artgen::pictures {

constexpr std::int32_t kGlyphSide = 8;

struct Glyph {
  // From the top; bit 0 is the left dot.
  std::array<std::uint8_t, kGlyphSide> rows{};
  // False outside the glyph.
  bool ink(std::int32_t x, std::int32_t y) const {
    return x >= 0 && y >= 0 && x < kGlyphSide && y < kGlyphSide &&
           (rows[static_cast<std::size_t>(y)] >> x & 1) != 0;
  }
  bool operator==(const Glyph&) const = default;
};
// By character code.
using Glyphs = std::map<std::uint8_t, Glyph>;

// Reads the `glyph` lines and skips all others. Fails for a glyph that is defined twice.
base::Result<Glyphs> read_glyphs(std::span<const ScriptLine> lines);

}  // namespace temblor::artgen::pictures
