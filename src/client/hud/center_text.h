// Messages in the middle of the screen.
#pragma once

#include <cstddef>
#include <string_view>

#include "client/hud/panel.h"

namespace temblor::client {

// Each line in the middle of the frame, lines of more than 40 characters broken. Short messages begin above
// the frame's middle, long ones further up. Only the first `letters` are shown, where they will stand when
// all are; line ends do not count.
void draw_center_text(const Panel& panel, std::string_view text,
                      std::size_t letters = std::string_view::npos);

// How many letters of a text have been written after `seconds`.
std::size_t letters_written(double seconds);

}  // namespace temblor::client
