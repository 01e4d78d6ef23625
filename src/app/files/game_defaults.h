// The settings that a game comes with, for pictures, films, and benchmarks. (`play` also runs the game's
// other commands: host/session/configure.h.)
#pragma once

#include "app/commands/options.h"
#include "command/variables.h"

namespace temblor::app {

// Sets the variables that the game's default.cfg sets. Other commands, unknown variables, and wrong values
// are ignored, and so is a game without such a file.
void apply_game_defaults(const GameFolders& folders, command::Variables& io_variables);

}  // namespace temblor::app
