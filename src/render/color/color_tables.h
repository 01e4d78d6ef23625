// The palette and colormap of a game, in the forms that drawing code reads; computed once.
#pragma once

#include <array>
#include <cstdint>

#include "formats/images/palette.h"
#include "render/color/blend_tables.h"
#include "render/color/palette_match.h"
#include "render/color/tint_tables.h"

namespace temblor::render {

// Rows of the colormap, which has 64, from brightest to darkest: the row that shows the palette as it is, and
// the row without light. Rows below 31 are brighter than the palette.
constexpr std::uint8_t kLightAsStored = 31, kLightNone = 63;

struct ColorTables {
  formats::Palette palette;
  formats::Colormap colormap;
  std::array<std::uint32_t, 256> rgb;          // 0xffRRGGBB
  std::array<std::uint32_t, 256> surface_rgb;  // the same, with alpha 0 for full-bright entries
  int first_fullbright = 224;                  // entries from this index on are full-bright
  std::uint8_t gray = 0, black = 0;            // the lit entries nearest to half brightness, and to black
  PaletteMatch match;
  BlendTables blends;
  TintTables tints;
};

ColorTables make_color_tables(const formats::Palette& palette, const formats::Colormap& colormap);

}  // namespace temblor::render
