// Scores: what the level still holds, and who leads a deathmatch.
#pragma once

#include "client/hud/panel.h"
#include "client/session/client_state.h"

namespace temblor::client {

// In the bar's place: monsters, secrets, time, the level's name. `bar`: of kBarHeight.
void draw_level_scores(const Panel& bar, const Game& game, double time_s, float opacity);

// The frags of the first four, in the inventory's upper right. `inventory`: of kInventoryHeight.
void draw_leaders(const Panel& inventory, const Game& game);

// All players, best first. `screen`: of kScreenHeight.
void draw_ranking(const Panel& screen, const Game& game);

}  // namespace temblor::client
