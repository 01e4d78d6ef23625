// `temblor art`: makes the files of a game directory from art scripts and level scripts, with the artgen
// library.
#pragma once

#include <filesystem>
#include <vector>

#include "base/result.h"

namespace temblor::app {

class Command;

struct ArtOptions {
  // Files, or folders with *.art and *.level files.
  std::vector<std::filesystem::path> scripts;
  // Game directory to write to.
  std::filesystem::path output;
};

// Describes the command line. `io_options` must live until it is parsed.
Command* add_art_command(Command& program, ArtOptions& io_options);

// Makes all files, then writes them, so an error in a script leaves the directory as it is. A file that
// already has the same bytes is not touched, so that its time stamp does not trigger a rebuild.
base::Status run_art(const ArtOptions& options);

}  // namespace temblor::app
