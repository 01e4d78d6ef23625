// The letters of signs: capitals, digits and a few marks, 5 texels wide and 7 high.
#pragma once

#include <cstdint>
#include <string_view>

namespace temblor::artgen {

constexpr std::int32_t kLetterWidth = 5, kLetterHeight = 7;

bool has_letter(char letter);

// Of a line with a column between letters.
std::int32_t letters_width(std::string_view text);

// Whether a texel of that line is ink; nowhere outside of it.
bool letters_at(std::string_view text, std::int32_t column, std::int32_t row);

}  // namespace temblor::artgen
