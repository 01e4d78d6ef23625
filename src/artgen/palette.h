// The project's own palette: what the level made in code and the art of the shipped game are painted with.
#pragma once

#include <cstddef>
#include <cstdint>

#include "formats/images/palette.h"

namespace temblor::artgen {

// 14 ramps of 16 colors, each from dark (0) to bright (15), then two full-bright ramps. Index 0 is black;
// 255 is the color of transparent texels. The game's effects name their colors by index, as the original's
// palette has them: ramp 4 is blood, 6 the fire of explosions, 9 has the drops of a spawn's, 14 lava.
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

// The index of a ramp's color; `brightness` from 0 to 1, values outside count as the nearest.
std::uint8_t ramp_color(Ramp ramp, double brightness);

formats::Palette make_palette();

}  // namespace temblor::artgen
