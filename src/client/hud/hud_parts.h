// The parts of the built-in HUD, of which a HUD program may replace some.
#pragma once

namespace temblor::client {

struct HudParts {
  bool crosshair = true;
  bool bars = true;         // status bar and inventory
  bool scores = true;       // instead of the status bar, and the ranking
  bool center_text = true;  // messages in the middle
  bool hints = true;        // for a dead player
  bool ending = true;       // intermission and the title of a finale
};

}  // namespace temblor::client
