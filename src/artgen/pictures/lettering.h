// Large letters, of straight cuts, for titles, numbers and signs.
#pragma once

#include <string_view>

#include "artgen/pictures/outline.h"

namespace temblor::artgen::pictures {

struct LetteringLook {
  double height = 20;  // pixels, cuts included
  double weight = 4;   // width of a cut
  double flare = 1;    // how much wider cuts are at their ends
  double spacing = 2;  // between letters
  double narrow = 1;   // times as wide as usual
};

// Small letters become capitals. Signs: - : / . ! ' and the blank.
bool has_letter(char letter);

double text_width(std::string_view text, const LetteringLook& look);
// `left` and `top` of the first letter's edge. CHECKs that there is something to see and that all letters are
// known.
Outline make_text(std::string_view text, math::Vec2d left_top, const LetteringLook& look);

}  // namespace temblor::artgen::pictures
