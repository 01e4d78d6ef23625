// Commands that players type: lines that their clients pass on to the server. The table of commands is at the
// end of player_commands.cpp.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace temblor::server {

struct Server;

// A name as everybody may see it: no control characters, no quotes, at most 15 characters, never empty.
std::string presentable_name(std::string_view wanted);

// Runs one command of a player; an unknown one is answered with a line of text. Cheats (god, noclip, give
// ...) work only in single player, or if sv_cheats is set.
void run_player_command(Server& io_server, std::size_t slot, std::string_view line);

}  // namespace temblor::server
