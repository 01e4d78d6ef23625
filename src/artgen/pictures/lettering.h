// Large letters that consist of straight cuts, as if cut into stone: for titles, numbers, and signs.
#pragma once

#include <string_view>

#include "artgen/pictures/outline.h"

namespace temblor::artgen::pictures {

// All sizes are pixels.
struct LetteringStyle {
  // The height of a letter, including the width of its cuts.
  double height = 20;
  // The width of a cut.
  double weight = 4;
  // How many times wider a cut is at its ends.
  double flare = 1;
  // Between letters.
  double spacing = 2;
  // A factor for the letters' width.
  double narrow = 1;
};

// Lower-case letters are drawn as capitals. Also exist: digits, the blank, and - : / . ! '
bool has_letter(char letter);

// The width of a line of text.
double measure_text(std::string_view text, const LetteringStyle& style);
// The outline of a line of text with its upper left corner at `left_top`. CHECKs that all letters exist and
// that at least one of them is visible.
Outline make_text(std::string_view text, math::Vec2d left_top, const LetteringStyle& style);

}  // namespace temblor::artgen::pictures
