// `play --watch`: what a mapper or modder works on is taken up by the running game when it is saved.
#pragma once

#include <future>
#include <optional>
#include <string>
#include <vector>

#include "app/files/file_watch.h"
#include "base/result.h"
#include "host/game_data.h"

namespace temblor::app {

class PlayWatch {
 public:
  // `files`: maps, which are compiled to where the last game folder's files are written, levels and a program
  // (.dat). Compiles the maps once, so that there is something to play; fails where that does.
  static base::Result<PlayWatch> begin(const std::vector<std::string>& files,
                                       const host::GameFolders& folders);

  // The level to play and the game's code to use; empty: none was named.
  const std::string& level() const { return level_; }
  const std::string& program() const { return program_; }

  // Looks at the files now and then. Console lines to be run for what has changed.
  std::vector<std::string> look(double now_s);

 private:
  // What the compiler had to say; fails where there is no new level.
  using Compiled = base::Result<std::vector<std::string>>;
  static Compiled run_compiler(const std::vector<std::string>& words);

  struct Map {
    std::vector<std::string> compile;  // the words of the command
    FileWatch watch;
  };

  std::vector<Map> maps_;
  FileWatch played_;  // levels and programs, as the game reads them
  std::string level_, program_;
  std::vector<std::string> lines_;  // still to be run
  std::optional<std::future<Compiled>> compiling_;
  double looked_at_s_ = 0;
};

}  // namespace temblor::app
