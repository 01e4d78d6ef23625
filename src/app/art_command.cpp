#include "app/art_command.h"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include "app/written_file.h"
#include "artgen/art.h"
#include "base/parallel_for.h"
#include "vfs/disk.h"

namespace temblor::app {
namespace {

namespace fs = std::filesystem;

// The *.recipe files of a folder and those in it, in the order of their names; a file is itself.
base::Result<std::vector<fs::path>> find_recipes(const fs::path& place) {
  std::error_code failure;
  if (!fs::is_directory(place, failure)) return std::vector{place};
  std::vector<fs::path> found;
  for (fs::recursive_directory_iterator it(place, failure), end; !failure && it != end; it.increment(failure))
    if (it->path().extension() == ".recipe") found.push_back(it->path());
  if (failure) return base::Error{base::ErrorCode::kIo, failure.message(), place.string()};
  if (found.empty()) return base::Error{base::ErrorCode::kNotFound, "no .recipe file in it", place.string()};
  std::sort(found.begin(), found.end());
  return found;
}

base::Result<artgen::RecipeFile> read_recipe_file(const fs::path& path) {
  TRY(const base::ByteVector bytes, vfs::read_disk_file(path));
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  TRY(std::vector<artgen::RecipeLine> things, artgen::read_recipe(text).with_file(path.string()));
  return artgen::RecipeFile{path.string(), std::move(things)};
}

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

CLI::App* add_art_command(CLI::App& program, ArtOptions& io_options) {
  CLI::App* command = program.add_subcommand("art", "Makes art and sound of a game folder from recipes");
  command->add_option("RECIPES", io_options.recipes, "Recipe files, or folders with .recipe files")
      ->required();
  command->add_option("-o,--output", io_options.output, "The game folder to write to")->required();
  command->footer(
      "Examples:\n"
      "  temblor art game/art -o mygame\n"
      "  temblor art game/art/textures/stone.recipe -o /tmp/try");
  return command;
}

base::Status run_art(const ArtOptions& options) {
  std::vector<artgen::RecipeFile> recipes;
  for (const fs::path& place : options.recipes) {
    TRY(const std::vector<fs::path> files, find_recipes(place));
    for (const fs::path& file : files) {
      TRY(artgen::RecipeFile recipe, read_recipe_file(file));
      recipes.push_back(std::move(recipe));
    }
  }
  base::Jobs jobs(static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
  TRY(const std::vector<artgen::ArtFile> art, artgen::make_art(recipes, jobs));
  for (const artgen::ArtFile& file : art) TRY_STATUS(write_art_file(options.output, file));
  fmt::print("{}: {} files\n", options.output.string(), art.size());
  return base::Ok{};
}

}  // namespace temblor::app
