// A game for `temblor lab wire`: the engine's own server plays a level with players who run around, in
// virtual time, and the states that it sends to the first of them are kept.
#pragma once

#include <string>

#include "app/commands/options.h"
#include "base/result.h"
#include "lab/wire.h"

namespace temblor::app {

struct RecordingOptions {
  std::string map;  // of the game; empty: lab::wire::make_built_in_world()
  double seconds = 20;
  int players = 2;
};

// The same game for the same options and data. The server sends as to stock clients on another machine, in a
// deathmatch with bots, if the game has them. Errors: no game data, no such level, or a level that ends, or
// that players cannot join.
base::Result<lab::wire::World> record_game(const GameFolders& folders, const RecordingOptions& options);

}  // namespace temblor::app
