// The status bar: 320 x 24 of the original's pixels, and above it the inventory, as large.
#pragma once

#include "client/hud/hud.h"
#include "client/hud/panel.h"
#include "client/session/client_state.h"

namespace temblor::client {

struct BarLook {
  float opacity = 1;         // of what the bar stands on
  bool safe_colors = false;  // marks beside what colors alone tell: warnings, kinds of armor, of keys
};

// Armor, face, health, ammunition, each with its number. `bar`: of kBarHeight.
void draw_status_bar(const Panel& bar, const Game& game, const HudTimes& times, double time_s, BarLook look);

// Weapons, ammunition of all kinds, keys, power-ups, sigils, and in deathmatch the leaders' frags.
// `inventory`: of kInventoryHeight.
void draw_inventory(const Panel& inventory, const Game& game, const HudTimes& times, double time_s,
                    BarLook look);

}  // namespace temblor::client
