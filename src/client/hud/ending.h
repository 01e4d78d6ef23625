// What stands over the view when a level has ended.
#pragma once

#include "client/hud/panel.h"
#include "client/session/client_state.h"

namespace temblor::client {

// Time, secrets and kills of a finished level; in deathmatch the ranking.
void draw_intermission(const Panel& panel, const Game& game);

// The title of the end, and its text, letter by letter. A cut scene has the text alone.
void draw_finale(const Panel& panel, const Game& game, double time_s);

}  // namespace temblor::client
