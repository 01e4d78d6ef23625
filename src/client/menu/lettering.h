// Text as the console's characters show it: 8 x 8 pixels each, 128 shapes in two colors.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace temblor::client {

// Codes of the console's characters.
namespace glyph {
constexpr char kBlock = 11, kArrow = 13;
constexpr char kSliderLeft = '\x80', kSliderMiddle = '\x81', kSliderRight = '\x82', kSliderKnob = '\x83';
}  // namespace glyph

// Spaces for line ends and for characters that are frames and signs rather than text.
std::string shown(std::string_view text);
// The same text in the console's other color.
std::string in_second_color(std::string_view text);
// At most `chars` of it, the last ones dots where some are missing.
std::string cut(std::string_view text, std::size_t chars);
// Lines of at most `chars` (1 or more) characters, broken between words where there are some; empty lines are
// kept. At most `lines` of them, the last one cut where some are missing.
std::vector<std::string> wrap(std::string_view text, std::size_t chars,
                              std::size_t lines = static_cast<std::size_t>(-1));
// Whether `text` holds `part`, without regard to case and color.
bool holds(std::string_view text, std::string_view part);

}  // namespace temblor::client
