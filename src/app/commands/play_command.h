// `temblor play`: the game in a window. Connects the host library, which contains the game loop, to window,
// audio, network, and files.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/commands/options.h"
#include "base/result.h"

namespace temblor::host {
class HostVariables;
}

namespace temblor::app {

class Command;

struct PlayOptions {
  // At most one of these is useful: the level to start, the demo or replay to play, or the HOST[:PORT] to
  // join. All empty: the menu.
  std::string map, demo, replay, connect;
  // Path of a progs.dat; empty: the one in the game directories.
  std::string program;
  // Window size; nothing: as vid_width and vid_height say.
  std::optional<FrameSize> size{};
  // Console commands to run at the start, and files to reload when they change.
  std::vector<std::string> execute, watch;
  // Open no audio device.
  bool silent = false;
  // 0: until the player quits.
  double duration_s = 0;
};

Command* add_play_command(Command& program, PlayOptions& io_options);
// Plays until the player quits, Ctrl-C, or the duration has passed.
base::Status run_play(const PlayOptions& options, const CommonOptions& common,
                      const host::HostVariables& variables);

}  // namespace temblor::app
