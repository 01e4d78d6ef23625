// Small letters from rows of dots: the console's characters, and writing in pictures.
//
//   glyph A
//     ..xx....
//     .x..x...      x is ink; at most 8 rows of at most 8 places
//   glyph 18 like=0    a copy; codes of two digits and more
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
  std::array<std::uint8_t, kGlyphSide> rows{};  // bit 0 is the left place
  bool ink(std::int32_t x, std::int32_t y) const {
    return x >= 0 && y >= 0 && x < kGlyphSide && y < kGlyphSide &&
           (rows[static_cast<std::size_t>(y)] >> x & 1) != 0;
  }
  bool operator==(const Glyph&) const = default;
};
using Glyphs = std::map<std::uint8_t, Glyph>;

// Those among the lines; other lines are passed over.
base::Result<Glyphs> read_glyphs(std::span<const ScriptLine> lines);

}  // namespace temblor::artgen::pictures
