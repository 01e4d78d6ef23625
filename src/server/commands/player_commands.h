// What players may type: lines that their clients pass on to the server.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "server/server.h"

namespace temblor::server {

// A name as everybody may see it: no control characters, no quotes, at most 15 characters, never empty.
std::string presentable_name(std::string_view wanted);

// Runs one command of a player; one that there is not is answered with a line. Those that change what a
// player can do (god, noclip, give ...) work in a game for one alone, or where sv_cheats is set.
void run_player_command(Server& io_server, std::size_t slot, std::string_view line);

}  // namespace temblor::server
