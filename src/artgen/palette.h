// The project's own palette: 256 colors for the generated small level and for the art of the shipped game.
//
//   index  0..223    14 ramps of 16 colors, each from dark to bright
//   index  224..254  2 full-bright ramps, which the colormap does not darken
//   index  255       transparent texels
//
// The colors differ from the stock palette, but ramps that game effects address by index have the same
// meaning: ramp 4 is blood, 6 the fire of explosions, 9 contains the spawn's drops, 14 is lava. Index 0 is
// black.
#pragma once

#include <cstddef>
#include <cstdint>

#include "formats/images/palette.h"

namespace temblor::artgen {

// A ramp of the palette; its value times kRampColors is the index of its darkest color.
enum class Ramp : std::uint8_t {
  kGray,
  kBrown,
  kBrick,
  kSand,
  kRed,
  kOlive,
  kGold,
  kTeal,
  kBlue,
  kPurple,
  kSlate,
  kRust,
  kSkin,
  kGreen,
  kFire,      // full-bright
  kElectric,  // full-bright
};
constexpr std::size_t kRampColors = 16;
constexpr std::uint8_t kFirstFullbright = 224;
constexpr std::uint8_t kTransparent = 255;

// The palette index of a ramp's color. `brightness` is clamped to 0 (dark) to 1 (bright) and rounded to one
// of the 16 steps. The brightest color of the last ramp is index 254, because 255 is transparent.
std::uint8_t ramp_color(Ramp ramp, double brightness);

// Computes the palette: each ramp is interpolated between three colors.
formats::Palette make_palette();

}  // namespace temblor::artgen
