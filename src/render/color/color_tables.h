// The look of a game, as everything that writes pixels reads it: worked out once from palette and colormap.
#pragma once

#include <array>
#include <cstdint>

#include "formats/images/palette.h"
#include "render/color/blend_tables.h"

namespace temblor::render {

// Rows of the colormap.
constexpr std::uint8_t kLightAsStored = 31, kLightNone = 63;

struct ColorTables {
  formats::Palette palette;
  formats::Colormap colormap;
  std::array<std::uint32_t, 256> rgb;          // 0xffRRGGBB
  std::array<std::uint32_t, 256> surface_rgb;  // the same, with alpha 0 where light changes nothing
  int first_fullbright = 224;
  PaletteMatch match;
  BlendTables blends;
};

ColorTables make_color_tables(const formats::Palette& palette, const formats::Colormap& colormap);

}  // namespace temblor::render
