// Text in the console's character set: 8 x 8 pixels each, codes 0 to 127 in white and 128 to 255 as the same
// shapes in the second color. A byte is a character; there is no UTF-8 here.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace temblor::client {

// Character codes of symbols.
namespace glyph {
constexpr char kBlock = 11, kArrow = 13;
constexpr char kSliderLeft = '\x80', kSliderMiddle = '\x81', kSliderRight = '\x82', kSliderKnob = '\x83';
}  // namespace glyph

// Replaces line ends and symbols with spaces, so that only letters, digits and signs are left.
std::string to_printable(std::string_view text);
// The same text in the second color.
std::string to_second_color(std::string_view text);
// At most `chars` characters. Text that is cut off ends with "..".
std::string truncate(std::string_view text, std::size_t chars);
// Breaks text into lines of at most `chars` (1 or more) characters, between words where possible. Keeps empty
// lines. Returns at most `lines` lines; if text is left over, the last line is truncated.
std::vector<std::string> wrap(std::string_view text, std::size_t chars,
                              std::size_t lines = static_cast<std::size_t>(-1));
// Whether `text` contains `part`, regardless of case and color.
bool contains_text(std::string_view text, std::string_view part);

}  // namespace temblor::client
