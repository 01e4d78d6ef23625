// Finds the episodes of a game by the names of its levels.
//
// The first level of an episode ends with its number and "m1": e1m1 to e4m1 in the stock game, hip2m1 or r1m1
// in its mission packs.
#pragma once

#include <span>
#include <vector>

#include "client/menu/menu_content.h"

namespace temblor::host {

// Returns the places where a new game can start: the level "start" if there is one, then the episodes by
// number. Returns nothing if there are fewer than two episodes.
std::vector<client::MenuEpisode> find_episodes(std::span<const client::MenuLevel> levels);

}  // namespace temblor::host
