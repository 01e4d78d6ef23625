// `temblor play`: the game, in a window.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/commands/options.h"
#include "base/result.h"
#include "host/host_variables.h"

namespace temblor::app {

class Command;

struct PlayOptions {
  std::string map, demo, connect, program;
  std::optional<FrameSize> size{};
  std::vector<std::string> execute, watch;
  bool silent = false;
  double duration_s = 0;  // 0: until the player ends it
};

Command* add_play_command(Command& program, PlayOptions& io_options);
base::Status run_play(const PlayOptions& options, const CommonOptions& common,
                      const host::HostVariables& variables);

}  // namespace temblor::app
