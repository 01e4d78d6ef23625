// `play --watch`: reloads the running game when a mapper or modder saves a file.
//
//   .map  is compiled in a separate process, into the last game directory, and then reloaded as a .bsp
//   .bsp  is reloaded
//   .dat  is reloaded together with the current level
#pragma once

#include <future>
#include <optional>
#include <string>
#include <vector>

#include "app/files/file_watch.h"
#include "base/result.h"
#include "host/game_folders.h"

namespace temblor::app {

class PlayWatch {
 public:
  // Starts to watch `files`. Compiles every map once, so that there is a level to play, and fails if that
  // fails.
  static base::Result<PlayWatch> begin(const std::vector<std::string>& files,
                                       const host::GameFolders& folders);

  // The level to play and the progs.dat to use; empty if --watch named none.
  const std::string& level() const { return level_; }
  const std::string& program() const { return program_; }

  // Checks the files, at most every 0.2 s. Returns console commands to run: `reload` after a change, and
  // `echo` with the compiler's messages. Never waits for the compiler.
  std::vector<std::string> look(double now_s);

 private:
  // The compiler's messages; an error if it made no level.
  using Compiled = base::Result<std::vector<std::string>>;
  static Compiled run_compiler(const std::vector<std::string>& words);

  struct Map {
    // Command line of the compiler.
    std::vector<std::string> compile;
    FileWatch watch;
  };

  std::vector<Map> maps_;
  // The .bsp and .dat files that the game reads.
  FileWatch played_;
  std::string level_, program_;
  // Commands for the next look().
  std::vector<std::string> lines_;
  // The running compiler.
  std::optional<std::future<Compiled>> compiling_;
  double looked_at_s_ = 0;
};

}  // namespace temblor::app
