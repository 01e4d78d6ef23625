// The bitmap letters of signs: capitals, digits, and a few symbols, 5 texels wide and 7 high.
#pragma once

#include <cstdint>
#include <string_view>

namespace temblor::artgen {

constexpr std::int32_t kLetterWidth = 5, kLetterHeight = 7;

// Lower-case letters do not exist.
bool has_letter(char letter);

// The width in texels of a line of text, with one column between letters. -1 for an empty text.
std::int32_t measure_letters(std::string_view text);

// Whether a texel of that line belongs to a letter. False outside the line and for unknown letters.
bool has_ink(std::string_view text, std::int32_t column, std::int32_t row);

}  // namespace temblor::artgen
