// The messages that a client is sent before it plays, in the order in which it asks for them (see
// joining.cpp).
#pragma once

#include <span>
#include <vector>

#include "base/bytes.h"
#include "server/game.h"
#include "server/session/client.h"

namespace temblor::server {

// The longest reliable message that clients of this dialect accept.
std::size_t max_reliable_bytes(const net::Dialect& dialect);

// Step 1: the level's name, the files that it needs, its music, and which entity the player is. kTooLarge if
// the dialect has no room for the names.
base::Result<base::ByteVector> make_level_message(Game& io_game, std::size_t slot);

// Step 2: the signon: static entities, baselines, and what QuakeC sends to everyone who joins. Split into as
// many messages as needed, none over max_reliable_bytes(). kTooLarge if one piece alone is longer.
base::Result<std::vector<base::ByteVector>> make_signon_messages(Game& io_game);

// Step 3: names, frags and colors of all players, light styles, totals, the direction of view, and the
// player's own state. Split like step 2.
base::Result<std::vector<base::ByteVector>> make_state_messages(Game& io_game,
                                                                std::span<const Client> clients,
                                                                std::size_t slot);

}  // namespace temblor::server
