// Loading the game folders and running their configuration files, at the start and when the player switches
// to another mod.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace temblor::host {

struct Host;
struct GameSource;  // host/host.h

// Creates the session and the menus for LoadedGame::data, which must be open.
void load_game_folders(Host& io_host);

// Resets all variables and bindings, then runs quake.rc, or without that file the script of stock Quake.
// Later commands win:
//
//   our key bindings
//   quake.rc: exec default.cfg     the game's file, then our key bindings again
//             exec config.cfg      temblor.cfg, or config.cfg if that does not exist
//             exec autoexec.cfg
//             stuffcmds            does nothing: the commands of the command line run after the script
//             startdemos ...       remembers the demos that play behind the menu
//   command line
// Afterwards applies the window settings and queues the commands of HostOptions. Fails only if the command
// line's settings are wrong.
base::Status run_configuration(Host& io_host);

// Binds the program's default keys, and the additional ones of the game's default.cfg, and no others.
void restore_default_bindings(Host& io_host);

// Switches to other game folders without a restart. Saves the configuration of the old ones and ends the
// running game. If the new folders cannot be read, fails and the game continues.
base::Status change_games(Host& io_host, std::vector<std::string> games);

// Switches to other game data, without its mods, and stores the choice for the next run. If it cannot be
// read, fails and the game continues.
base::Status change_source(Host& io_host, const GameSource& source);

// Writes the configuration and the console's history to the write folder. An empty history is not written.
base::Status save_configuration(Host& io_host);

// Writes the configuration to a file in the write folder, adds ".cfg" to a name that lacks it, and prints the
// file's path. Fails with kUsage if the name leads out of the folder.
base::Status write_configuration(Host& io_host, std::string_view file);

}  // namespace temblor::host
