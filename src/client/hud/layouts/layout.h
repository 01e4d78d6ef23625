// The HUD's layouts: the classic bar, the corners, or two numbers. All give way to the score bar.
#pragma once

#include "assets/mission_pack.h"
#include "client/hud/hud.h"
#include "client/hud/notices/notices.h"
#include "client/hud/panel.h"
#include "client/session/client_state.h"

namespace temblor::client {

// A frame of the HUD during the game.
struct LayoutFrame {
  Panel panel;  // any panel of the frame
  const Game& game;
  const HudTimes& times;
  double time_s;
  const HudSettings& settings;
  assets::MissionPack pack;
};

LayoutHeights measure_layout(const LayoutFrame& frame);

// Draws the layout, or the score bar while the player is dead or looks at the scores.
void draw_layout(const LayoutFrame& frame);

}  // namespace temblor::client
