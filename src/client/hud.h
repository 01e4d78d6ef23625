// The 2-D part of a frame: status bar, centre print, intermission and finale screens, as a DrawList.
#pragma once

#include "assets/pictures.h"
#include "client/client_state.h"
#include "render/draw_list.h"

namespace temblor::client {

enum class StatusBar { kNone, kSmall, kFull };

struct HudSettings {
  StatusBar status_bar = StatusBar::kFull;
  int scale = 0;  // frame pixels for each of the original's; 0: as large as the frame's size asks for
  float opacity = 1;
};

class Hud {
 public:
  explicit Hud(const assets::Pictures& pictures) : pictures_(pictures) {}
  // Appends to `io_list`, for a frame of that size. Valid while the pictures live.
  void draw(const Game& game, double time_s, int width, int height, const HudSettings& settings,
            render::DrawList& io_list);

 private:
  const assets::Pictures& pictures_;
};

}  // namespace temblor::client
