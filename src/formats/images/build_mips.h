// Computes the three smaller mip levels of a palette texture from the largest.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "formats/images/nearest_color.h"
#include "formats/images/palette.h"

namespace temblor::formats {

// A palette with color searches in its parts: dull colors, fullbright colors, and both.
struct MipColors {
  // Takes about 10 ms.
  explicit MipColors(const Palette& game_palette)
      : palette(game_palette),
        dull(palette, 0, kFirstFullbright),
        bright(palette, kFirstFullbright, kTransparentIndex - kFirstFullbright),
        any(palette, 0, kTransparentIndex) {}

  Palette palette;
  NearestColor dull, bright, any;
};

// Each texel is the mean of four texels of the level below, mapped to the palette with error diffusion (Floyd
// and Steinberg, "An Adaptive Algorithm for Spatial Grayscale", 1976), row by row from the left.
//
// The mean is computed in linear light, not in palette values, so that a wall keeps its brightness where the
// mip level changes. Linear light is the square of a channel: close to the gamma of displays (2.2), and exact
// on every machine.
//
// The mean color of a level differs from that of the largest level by at most 2 + 48 / (shorter side) of 255,
// if the texture has no holes and no fullbright texels.
//
// A texel may become fullbright only if at least half of its four texels are; if all four are, it must. So
// the mean never becomes fullbright just because it is near a fullbright color.
//
// `mip0`: width * height indices (CHECKed). With has_holes, index 255 is transparent, and a texel becomes
// transparent if at least three of its four are; otherwise 255 is an ordinary color that is never chosen.
// Level k has (width >> k) x (height >> k) texels.
std::array<std::vector<std::uint8_t>, 4> build_mips(std::vector<std::uint8_t> mip0, std::uint32_t width,
                                                    std::uint32_t height, bool has_holes,
                                                    const MipColors& colors);

}  // namespace temblor::formats
