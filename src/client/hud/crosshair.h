// A mark in the middle of the frame, where shots go.
#pragma once

#include <cstdint>

#include "client/hud/panel.h"

namespace temblor::client {

enum class Crosshair { kNone, kCharacter, kDot, kLines };

struct CrosshairLook {
  Crosshair shape = Crosshair::kNone;
  std::uint8_t color = 15;  // index into the palette, of dot and lines
};

void draw_crosshair(const Panel& panel, const CrosshairLook& look);

}  // namespace temblor::client
