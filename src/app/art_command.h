// `temblor art`: from recipes to the files of a game folder.
#pragma once

#include <filesystem>
#include <vector>

#include "base/result.h"

namespace CLI {
class App;
}

namespace temblor::app {

struct ArtOptions {
  std::vector<std::filesystem::path> recipes;  // files, or folders of *.recipe
  std::filesystem::path output;
};

CLI::App* add_art_command(CLI::App& program, ArtOptions& io_options);

// Files that are there with the same bytes are left as they are, their time, too.
base::Status run_art(const ArtOptions& options);

}  // namespace temblor::app
