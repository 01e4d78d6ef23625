// The status bar, 320 x 24 of the original's pixels, and the inventory of the same size above it.
//
//   | ammo counts                        | leaders' frags          |   inventory: 8 pixels
//   | weapons                            | keys, power-ups, sigils |            16 pixels
//   | armor 25 |  face  | health 100 |  ammo 50                    |   status bar: 24 pixels
#pragma once

#include "client/hud/hud.h"
#include "client/hud/layouts/player_figures.h"
#include "client/hud/panel.h"
#include "client/session/client_state.h"

namespace temblor::client {

// Draws armor, face, health and ammo with their numbers. `bar`: a panel kBarHeight high.
void draw_status_bar(const Panel& bar, const Game& game, const HudTimes& times, double time_s,
                     const BarLook& look);

// Draws weapons, all ammo counts, keys, power-ups, sigils, and in a deathmatch the leaders' frags.
// `inventory`: a panel kInventoryHeight high.
void draw_inventory(const Panel& inventory, const Game& game, const HudTimes& times, double time_s,
                    const BarLook& look);

}  // namespace temblor::client
