// Screens at the end of a level: intermission and finale.
#pragma once

#include "client/hud/panel.h"
#include "client/session/client_state.h"

namespace temblor::client {

// Draws time, secrets and kills of the finished level, or the ranking in a deathmatch. Without the game's
// pictures only the numbers appear. A par time is shown below the time, in gold letters if the player has
// reached it; 0: none.
void draw_intermission(const Panel& panel, const Game& game, float par_s);

// Draws the finale's title and its text, letter by letter, at server time `time_s`. A cut scene has only the
// text.
// `letters`: a panel with the scale of the text.
void draw_finale(const Panel& panel, const Panel& letters, const Game& game, double time_s,
                 double letters_per_second);

}  // namespace temblor::client
