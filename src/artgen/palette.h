// The project's own palette: what the level made in code and the art of the shipped game are painted with.
#pragma once

#include <cstddef>
#include <cstdint>

#include "formats/palette.h"

namespace temblor::artgen {

// 14 ramps of 16 colours, each from dark (0) to bright (15), then two full-bright ramps. Index 0 is black;
// 255 is the colour of transparent texels.
enum class Ramp : std::uint8_t {
  kGrey,
  kBrown,
  kBrick,
  kSand,
  kRust,
  kOlive,
  kGreen,
  kTeal,
  kBlue,
  kSlate,
  kPurple,
  kRed,
  kSkin,
  kGold,
  kFire,      // full-bright
  kElectric,  // full-bright
};
constexpr std::size_t kRampColours = 16;
constexpr std::uint8_t kFirstFullbright = 224;
constexpr std::uint8_t kTransparent = 255;

// The index of a ramp's colour; `brightness` from 0 to 1, values outside count as the nearest.
std::uint8_t ramp_colour(Ramp ramp, double brightness);

formats::Palette make_palette();

}  // namespace temblor::artgen
