// Text in the middle of the screen: messages of the game (svc_centerprint) and the text of finales; and the
// breaking of text into centered lines, for hints and warnings.
#pragma once

#include <cstddef>
#include <string_view>

#include "client/hud/panel.h"

namespace temblor::client {

// How many lines the text takes on a panel. A line has at most 40 characters, and at most as many as fit in
// the frame; then it is broken between words.
int count_text_lines(const Panel& panel, std::string_view text);

// Draws the text in such lines, `line_height` apart, each centered on the panel's 320 pixels. Draws only the
// first `letters` characters, at their final places; line ends do not count.
void draw_text_lines(const Panel& panel, std::string_view text, int line_height,
                     std::size_t letters = std::string_view::npos);

// Draws the text in the middle of the frame. Short texts begin above the middle, long ones further up, like
// those of stock Quake, but not above `min_top_px` if they fit below it. `letters` as above, for text that is
// being written.
void draw_center_text(const Panel& panel, std::string_view text, std::size_t letters = std::string_view::npos,
                      int min_top_px = 0);

// How many letters of a finale's text are visible after `seconds`.
std::size_t count_written_letters(double seconds, double letters_per_second);

}  // namespace temblor::client
