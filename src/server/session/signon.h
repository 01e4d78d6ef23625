// What a client is told before it plays, in the order that it asks for it.
#pragma once

#include <span>
#include <vector>

#include "base/bytes.h"
#include "server/game.h"
#include "server/session/client.h"

namespace temblor::server {

// The longest reliable message that a client of that dialect takes.
std::size_t max_reliable_bytes(const net::Dialect& dialect);

// Stage 1: the level's name and rules, what files it needs, its music, whose eyes the player has.
// kTooLarge where protocol 15 has no room for the names.
base::Result<base::ByteVector> level_message(Game& io_game, std::size_t slot);

// Stage 2: statics, baselines and whatever the program says to all who join; as many messages as are needed,
// none over max_reliable_bytes(), cut only between two messages of the server. kTooLarge where that cannot
// be.
base::Result<std::vector<base::ByteVector>> beginning_messages(Game& io_game);

// Stage 3: names, frags and colors of all players, light styles, totals, where to look, the own state; cut
// as above.
base::Result<std::vector<base::ByteVector>> state_messages(Game& io_game, std::span<const Client> clients,
                                                           std::size_t slot);

}  // namespace temblor::server
