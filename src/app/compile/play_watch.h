// `play --watch`: reloads the running game when a mapper or modder saves a file.
//
//   .map  is compiled in a separate process, into the last game directory, and then reloaded as a .bsp
//   .bsp  is reloaded
//   .dat  is reloaded together with the current level
//
// A map is compiled with --fast at once, and in full when it has not changed for a while:
//
//   saved --> fast --> reload --- 5 s without a change ---> full, at low priority --> reload
//     ^                  |                                    |
//     '------------------'------------- saved, which stops it '
//
// A level that leaks is not compiled in full. Its leak is shown as a line (`pointfile`).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/child_process.h"
#include "app/files/file_watch.h"
#include "base/result.h"
#include "host/game_folders.h"

namespace temblor::app {

class PlayWatch {
 public:
  // Starts to watch `files`. Compiles every map once, with --fast, so that there is a level to play, and
  // fails if that fails.
  static base::Result<PlayWatch> begin(const std::vector<std::string>& files,
                                       const host::GameFolders& folders);

  // The level to play and the progs.dat to use; empty if --watch named none.
  const std::string& level() const { return level_; }
  const std::string& program() const { return program_; }

  // Checks the files, at most every 0.2 s. Returns console commands to run: `reload` after a change,
  // `pointfile` when a level that leaks begins, and `echo` with the compiler's messages. `played_level`: the
  // level that the player is in; empty: none. Never waits for the compiler.
  std::vector<std::string> look(double now_s, std::string_view played_level);

 private:
  struct Map {
    std::string level;                  // its name
    std::filesystem::path leak_points;  // exists if the level leaks
    std::vector<std::string> compile;   // command line of the compiler, without --fast
    FileWatch watch;
    bool needs_fast = false, needs_full = false;
    double changed_at_s = 0;
  };
  // The running compiler.
  struct Compiling {
    ChildProcess process;
    std::size_t map;
    bool is_full;
    bool is_stopped = false;
  };

  void find_changes(double now_s);
  void finish_compiling();
  void start_compiling(double now_s);
  void start(std::size_t map, bool is_full);
  void echo(std::string_view line);

  std::vector<Map> maps_;
  // The .bsp and .dat files that the game reads.
  FileWatch played_;
  std::string level_, program_;
  // Commands for the next look().
  std::vector<std::string> lines_;
  std::optional<Compiling> compiling_;
  double looked_at_s_ = 0;
  // The level at the last look().
  std::string played_level_;
};

}  // namespace temblor::app
