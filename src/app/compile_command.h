// `temblor compile`: from an editor's .map to a level.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/options.h"
#include "base/result.h"

namespace CLI {
class App;
}

namespace temblor::app {

struct CompileCommandOptions {
  std::string map;                // a .map file
  std::string out;                // empty: beside the map, .bsp
  std::string textures;           // a folder of PNG files, which come before all other textures
  std::vector<std::string> wads;  // WADs or levels, looked through before those that the map names
  bool fast = false;
  bool no_vis = false, no_light = false;
  bool opaque_water = false;
  bool built_mips = false;
  bool bsp2 = false;
  int extra = 1;
  std::optional<int> bounces;
  std::optional<int> threads;
};

CLI::App* add_compile_command(CLI::App& program, CompileCommandOptions& io_options);

// Writes the level, its .lit where there is coloured light, and a .pts where it leaks; prints a summary.
base::Status run_compile(const CompileCommandOptions& options, const GameFolders& folders);

}  // namespace temblor::app
