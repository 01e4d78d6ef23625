#include "app/files/game_files.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <system_error>
#include <tuple>
#include <utility>

#include "artgen/palette.h"
#include "base/nearest_name.h"
#include "base/text.h"

namespace temblor::app {
namespace {

constexpr std::size_t kSuggestions = 8;

// Locations of the shipped game relative to the program: in a build tree or an unpacked archive, and after
// `make install` or in a package.
constexpr const char* kInstalledGame = "../share/games/temblor";
constexpr std::array kShippedGame = {"game", kInstalledGame};

std::filesystem::path find_beside_program(const char* place) {
  std::error_code failure;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", failure);
  return (program.parent_path() / place).lexically_normal();
}

std::optional<std::filesystem::path> find_shipped_game() {
  std::error_code failure;
  for (const char* const place : kShippedGame) {
    const std::filesystem::path folder = find_beside_program(place);
    if (std::filesystem::exists(folder / "id1/gfx/palette.lmp", failure)) return folder;
  }
  return {};
}

}  // namespace

bool has_no_game_data(const GameFolders& folders) {
  std::error_code ignored;
  return folders.base_folder.empty() && !std::filesystem::is_directory("id1", ignored);
}

// --basedir is not checked here; opening its files fails with a better message.
base::Result<std::filesystem::path> find_base_folder(const GameFolders& folders) {
  if (!has_no_game_data(folders))
    return std::filesystem::path(folders.base_folder.empty() ? "." : folders.base_folder);
  if (std::optional<std::filesystem::path> shipped = find_shipped_game()) return *std::move(shipped);
  return base::error(base::ErrorCode::kNotFound,
                     "no game data: the current directory does not contain id1, and the included game is not "
                     "beside the program; name "
                     "the directory that contains id1 with --basedir DIR");
}

bool is_installed_game(const std::filesystem::path& base_folder) {
  // The error is set if either does not exist; the result is then false.
  std::error_code failure;
  return std::filesystem::equivalent(base_folder, find_beside_program(kInstalledGame), failure);
}

base::Result<vfs::FileSystem> open_files(const GameFolders& folders) {
  TRY(const std::filesystem::path base_folder, find_base_folder(folders));
  return vfs::FileSystem::open(base_folder, folders.games);
}

assets::Look make_builtin_look() {
  const formats::Palette palette = artgen::make_palette();
  return {palette, formats::make_colormap(palette)};
}

base::Result<assets::Look> find_look(const GameFolders& folders) {
  if (has_no_game_data(folders)) return make_builtin_look();
  TRY(const vfs::FileSystem files, open_files(folders));
  return assets::load_look(files);
}

base::Result<formats::Palette> find_palette(const GameFolders& folders) {
  if (has_no_game_data(folders)) return artgen::make_palette();
  TRY(const assets::Look look, find_look(folders));
  return look.palette;
}

// Names with the same distance are sorted by name, so the order does not depend on the file system.
std::string suggest(std::string_view wanted, std::vector<std::string> names) {
  if (names.empty()) return "there are none";
  const std::string lower = base::to_lower(wanted);
  std::sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
    return std::tuple(base::edit_distance(lower, a), a) < std::tuple(base::edit_distance(lower, b), b);
  });
  names.resize(std::min(names.size(), kSuggestions));
  return fmt::format("similar names: {}", fmt::join(names, ", "));
}

std::vector<std::string> list_stems(const vfs::FileSystem& files, std::string_view folder,
                                    std::string_view suffix) {
  std::vector<std::string> names;
  for (const std::string& path : files.list(folder, suffix))
    names.push_back(path.substr(folder.size(), path.size() - folder.size() - suffix.size()));
  return names;
}

}  // namespace temblor::app
