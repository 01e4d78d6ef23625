// Scores: a level's monsters and secrets, and the frags of a deathmatch.
#pragma once

#include <string_view>

#include "client/hud/panel.h"
#include "client/session/client_state.h"

namespace temblor::client {

// The picture of draw_team_frame(), which only that pack has.
constexpr std::string_view kTeamFramePicture = "r_teambord";

// Draws monsters, secrets, time and the level's name in place of the status bar; in a deathmatch the player's
// frags and place instead of monsters and secrets. `bar`: a panel kBarHeight high.
void draw_level_scores(const Panel& bar, const Game& game, double time_s, float opacity);

// Draws the frags of the four leaders at the upper right of the inventory, with the player's own in brackets.
// `inventory`: a panel kInventoryHeight high.
void draw_leaders(const Panel& inventory, const Game& game);

// Draws the player's colors and frags in the team frame of Dissolution of Eternity, in place of the face.
// `bar`: a panel kBarHeight high.
void draw_team_frame(const Panel& bar, const Game& game);

// Whether the server has sent the captures of capture the flag.
bool has_captures(const Game& game);

// Draws each team's captures, else the sum of its frags, above the ranking, best first, in boxes of the
// pants' color; nothing with one team. `screen`: a panel kScreenHeight high.
void draw_team_scores(const Panel& screen, const Game& game);

// Draws all players, best first, with an arrow at the player's own row. `screen`: a panel kScreenHeight high.
void draw_ranking(const Panel& screen, const Game& game);

}  // namespace temblor::client
