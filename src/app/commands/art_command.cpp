#include "app/commands/art_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include "app/commands/command_line.h"
#include "app/files/atomic_write.h"
#include "artgen/art.h"
#include "base/parallel_for.h"
#include "base/text.h"
#include "vfs/disk.h"

namespace temblor::app {
namespace {

namespace fs = std::filesystem;

// Finds the *.art and *.level files in a folder and its subfolders, sorted by path. Returns a file as it is.
base::Result<std::vector<fs::path>> find_scripts(const fs::path& place) {
  std::error_code failure;
  if (!fs::is_directory(place, failure)) return std::vector{place};
  std::vector<fs::path> found;
  for (fs::recursive_directory_iterator it(place, failure), end; !failure && it != end; it.increment(failure))
    if (it->path().extension() == ".art" || it->path().extension() == ".level") found.push_back(it->path());
  if (failure) return base::Error{base::ErrorCode::kIo, failure.message(), place.string()};
  if (found.empty())
    return base::Error{base::ErrorCode::kNotFound, "the folder has no .art or .level file", place.string()};
  std::sort(found.begin(), found.end());
  return found;
}

// Reads and parses a script. Errors name the file and the line.
base::Result<artgen::ScriptFile> read_script_file(const fs::path& path) {
  TRY(const base::ByteVector bytes, vfs::read_disk_file(path));
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  TRY(std::vector<artgen::ScriptLine> things, artgen::read_script(text).with_file(path.string()));
  return artgen::ScriptFile{path.string(), std::move(things)};
}

// Writes the file unless it already has these bytes.
base::Status write_art_file(const fs::path& folder, const artgen::ArtFile& file) {
  const fs::path path = folder / file.path;
  const base::Result<base::ByteVector> old = vfs::read_disk_file(path);
  if (old.ok() && *old == file.bytes) return base::Ok{};
  std::error_code failure;
  fs::create_directories(path.parent_path(), failure);
  if (failure) return base::Error{base::ErrorCode::kIo, failure.message(), path.parent_path().string()};
  return replace_file(path, file.bytes);
}

}  // namespace

Command* add_art_command(Command& program, ArtOptions& io_options) {
  Command* command = program.add_subcommand("art", "Make game files from art scripts and level scripts");
  command
      ->add_option("SCRIPTS", io_options.scripts,
                   "Art scripts (.art), level scripts (.level), or folders of them")
      ->required();
  command->add_option("-o,--output", io_options.output, "Game directory to write to")->required();
  command->footer(
      "Files that have not changed are not written again. docs/art-scripts.md and docs/level-scripts.md "
      "describe\n"
      "the scripts.\n"
      "\n"
      "Examples:\n"
      "  temblor art game/art -o mygame\n"
      "  temblor art game/art/textures/stone.art -o /tmp/try");
  return command;
}

base::Status run_art(const ArtOptions& options) {
  std::vector<artgen::ScriptFile> scripts;
  for (const fs::path& place : options.scripts) {
    TRY(const std::vector<fs::path> files, find_scripts(place));
    for (const fs::path& file : files) {
      TRY(artgen::ScriptFile script, read_script_file(file));
      scripts.push_back(std::move(script));
    }
  }
  // All scripts are made before the first file is written, on all cores.
  base::Jobs jobs(static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
  TRY(const std::vector<artgen::ArtFile> art, artgen::make_art(scripts, jobs));
  for (const artgen::ArtFile& file : art) TRY_STATUS(write_art_file(options.output, file));
  fmt::print("{}: {}\n", options.output.string(), base::counted(art.size(), "file"));
  return base::Ok{};
}

}  // namespace temblor::app
