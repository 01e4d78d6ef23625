// `temblor lab replay`: simulates a lockstep game again, without a window.
#pragma once

#include <string>

#include "app/commands/options.h"
#include "base/result.h"

namespace temblor::app {

class Command;

struct ReplayOptions {
  std::string file;
  int player = 1;  // whose view is recorded
  std::string program;
  bool json = false;
  std::string out;  // a demo; empty: none
};

Command* add_replay_command(Command& lab, ReplayOptions& io_options);

// Prints how long the game is, how large its replay, and how fast it was simulated. Errors: a file that
// cannot be read, other game files, a game that is not the recorded one.
base::Status run_replay(const ReplayOptions& options, const GameFolders& folders);

}  // namespace temblor::app
