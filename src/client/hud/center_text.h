// Text in the middle of the screen: messages of the game (svc_centerprint) and the text of finales.
#pragma once

#include <cstddef>
#include <string_view>

#include "client/hud/panel.h"

namespace temblor::client {

// Draws each line centered; breaks lines at 40 characters. Short texts begin above the middle of the frame,
// long ones further up. Draws only the first `letters` characters, at their final places, so that text which
// is being written does not move; line ends do not count.
void draw_center_text(const Panel& panel, std::string_view text,
                      std::size_t letters = std::string_view::npos);

// How many letters of a finale's text are visible after `seconds`.
std::size_t count_written_letters(double seconds, double letters_per_second);

}  // namespace temblor::client
