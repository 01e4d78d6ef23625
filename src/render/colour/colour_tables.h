// The look of a game, as everything that writes pixels reads it: worked out once from palette and colormap.
#pragma once

#include <array>
#include <cstdint>

#include "formats/palette.h"
#include "render/colour/blend_tables.h"

namespace temblor::render {

// Rows of the colormap.
constexpr std::uint8_t kLightAsStored = 31, kLightNone = 63;

struct ColourTables {
  formats::Palette palette;
  formats::Colormap colormap;
  std::array<std::uint32_t, 256> rgb;          // 0xffRRGGBB
  std::array<std::uint32_t, 256> surface_rgb;  // the same, with alpha 0 where light changes nothing
  int first_fullbright = 224;
  PaletteMatch match;
  BlendTables blends;
};

ColourTables make_colour_tables(const formats::Palette& palette, const formats::Colormap& colormap);

}  // namespace temblor::render
