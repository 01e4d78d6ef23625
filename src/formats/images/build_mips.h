// The smaller mip levels of a texture, made from its largest.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "formats/images/nearest_color.h"
#include "formats/images/palette.h"

namespace temblor::formats {

// The palette, and what of it a texel may become. Making one takes some ten milliseconds.
struct MipColors {
  explicit MipColors(const Palette& game_palette)
      : palette(game_palette),
        dull(palette, 0, kFirstFullbright),
        bright(palette, kFirstFullbright, kTransparentIndex - kFirstFullbright),
        any(palette, 0, kTransparentIndex) {}

  Palette palette;
  NearestColor dull, bright, any;
};

// Each texel is the mean of the four below it, given to the palette by error diffusion (Floyd and Steinberg,
// "An Adaptive Algorithm for Spatial Grayscale", 1976), row by row from the left.
//
// The mean is taken of light, not of the palette's numbers, because that is what the eye does with texels too
// small to be told apart: so a wall keeps its brightness where one mip level gives way to the next. A
// channel's light is taken as its square, close to what displays do (2.2) and exact on every machine.
//
// A level's mean light, as a color, stays within 2 + 48 / (its shorter side) of 255 of the largest level's,
// where neither has holes or full-bright texels.
//
// A texel is full-bright only where at least half of its four are (then chosen among all colors; where all
// four are, among the full-bright alone), never because the mean happens to lie near a full-bright color.
//
// `mip0` has width * height indices. With holes, index 255 is transparent, and a texel is where at least
// three of its four are; otherwise 255 is a full-bright color, which is never chosen. Level k is (width >>
// k) x (height >> k).
std::array<std::vector<std::uint8_t>, 4> build_mips(std::vector<std::uint8_t> mip0, std::uint32_t width,
                                                    std::uint32_t height, bool has_holes,
                                                    const MipColors& colors);

}  // namespace temblor::formats
