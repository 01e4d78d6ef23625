// `temblor art`: from scripts to the files of a game folder.
#pragma once

#include <filesystem>
#include <vector>

#include "base/result.h"

namespace temblor::app {

class Command;

struct ArtOptions {
  std::vector<std::filesystem::path> scripts;  // files, or folders of *.art and *.level files
  std::filesystem::path output;
};

Command* add_art_command(Command& program, ArtOptions& io_options);

// Files that are there with the same bytes are left as they are, their time, too.
base::Status run_art(const ArtOptions& options);

}  // namespace temblor::app
