// The crosshair.
#pragma once

#include <cstdint>

#include "client/hud/panel.h"

namespace temblor::client {

// The values of the variable `crosshair`. kCharacter is the original's: a '+' of the console's characters.
enum class Crosshair { kNone, kCharacter, kDot, kLines };

struct CrosshairLook {
  Crosshair shape = Crosshair::kNone;
  std::uint8_t color = 15;  // palette index, for dot and lines
  double scale = 1;         // of dot and lines
};

// Draws the crosshair in the center of the frame. Line widths follow the frame's height.
void draw_crosshair(const Panel& panel, const CrosshairLook& look);

}  // namespace temblor::client
