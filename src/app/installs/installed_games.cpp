#include "app/installs/installed_games.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>

#include "app/installs/store_files.h"
#include "base/text.h"
#include "vfs/disk.h"

namespace temblor::app {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxStoreFileBytes = 1 << 20;
// Entries of a folder that are looked at.
constexpr std::size_t kMaxEntries = 2000;

// Lists a folder; empty if it cannot be read.
std::vector<fs::path> list_folder(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code failure;
  for (fs::directory_iterator i(folder, failure), end; !failure && i != end && entries.size() < kMaxEntries;
       i.increment(failure))
    entries.push_back(i->path());
  std::sort(entries.begin(), entries.end());
  return entries;
}

// Finds an entry of that name, ignoring case: Windows games have "Id1" and "PAK0.PAK".
std::optional<fs::path> find_entry(const fs::path& folder, std::string_view name) {
  for (const fs::path& entry : list_folder(folder))
    if (base::equal_ignoring_case(entry.filename().string(), name)) return entry;
  return std::nullopt;
}

bool has_quake(const fs::path& folder) {
  const std::optional<fs::path> id1 = find_entry(folder, "id1");
  const std::optional<fs::path> pak = id1 ? find_entry(*id1, "pak0.pak") : std::nullopt;
  std::error_code failure;
  return pak && fs::is_regular_file(*pak, failure);
}

// Reads a store's file; empty if it cannot be read or is too large.
std::string read_text(const fs::path& file) {
  const base::Result<base::ByteVector> bytes = vfs::read_disk_file(file, kMaxStoreFileBytes);
  return bytes.ok() ? std::string(base::as_text(*bytes)) : std::string();
}

bool is_named_quake(const fs::path& path) {
  return base::to_lower(path.filename().string()).find("quake") != std::string::npos;
}

// Collects games, each once.
class Collector {
 public:
  // Adds the games of a folder. Stores put the release's folder, and some their own "game" or "data" folder,
  // around id1.
  void add(const fs::path& folder, std::string_view store) {
    if (folder.empty() || !visited_.insert(folder.lexically_normal()).second) return;
    for (const char* const inner : {"", "game", "data"}) {
      const fs::path place = *inner == 0 ? folder : folder / inner;
      if (const std::optional<fs::path> release = find_entry(place, "rerelease");
          release && has_quake(*release))
        add_game("Quake, 2021 release", *release, store);
      // Players also name the release's own folder.
      if (has_quake(place))
        add_game(find_entry(place, "QuakeEX.kpf") ? "Quake, 2021 release" : "Quake", place, store);
    }
  }

  // Adds the games of all folders in this one that are named after Quake.
  void add_all_in(const fs::path& folder, std::string_view store) {
    for (const fs::path& entry : list_folder(folder))
      if (is_named_quake(entry)) add(entry, store);
  }

  // Adds the games in a folder in which Wine keeps its drive C.
  void add_wine_prefix(const fs::path& prefix, std::string_view store) {
    for (const char* const inner :
         {"GOG Games", "Games", "Program Files", "Program Files (x86)",
          "Program Files (x86)/GOG Galaxy/Games", "Program Files (x86)/Steam/steamapps/common"})
      add_all_in(prefix / "drive_c" / inner, store);
  }

  std::vector<InstalledGame> take() { return std::move(games_); }

 private:
  void add_game(std::string_view title, const fs::path& base_folder, std::string_view store) {
    std::error_code failure;
    const fs::path real = fs::canonical(base_folder, failure);
    if (failure || games_.size() >= kMaxInstalledGames || !found_.insert(real).second) return;
    games_.push_back({fmt::format("{} ({})", title, store), base_folder});
  }

  std::set<fs::path> visited_, found_;
  std::vector<InstalledGame> games_;
};

void find_steam(const UserFolders& user, Collector& io_games) {
  const fs::path flatpak = user.home / ".var/app/com.valvesoftware.Steam";
  for (const fs::path& root :
       {user.home / ".steam/steam", user.home / ".steam/root", user.data / "Steam",
        user.home / ".local/share/Steam", flatpak / ".local/share/Steam", flatpak / "data/Steam",
        flatpak / ".steam/steam", user.home / "snap/steam/common/.local/share/Steam"}) {
    std::vector<fs::path> libraries = {root};
    for (const char* const file : {"steamapps/libraryfolders.vdf", "config/libraryfolders.vdf"})
      for (fs::path& library : read_steam_libraries(read_text(root / file)))
        libraries.push_back(std::move(library));
    for (const fs::path& library : libraries) io_games.add(library / "steamapps/common/Quake", "Steam");
  }
}

void find_heroic(const UserFolders& user, Collector& io_games) {
  const fs::path flatpak = user.home / ".var/app/com.heroicgameslauncher.hgl/config";
  for (const fs::path& config : {user.config, flatpak})
    for (const char* const file :
         {"heroic/gog_store/installed.json", "heroic/legendaryConfig/legendary/installed.json",
          "legendary/installed.json"})
      for (const fs::path& folder : read_heroic_folders(read_text(config / file)))
        io_games.add(folder, "Heroic");
  io_games.add_all_in(user.home / "Games/Heroic", "Heroic");
}

void find_lutris(const UserFolders& user, Collector& io_games) {
  const fs::path flatpak = user.home / ".var/app/net.lutris.Lutris";
  for (const fs::path& parent : {user.config, user.data, flatpak / "config", flatpak / "data"})
    for (const fs::path& file : list_folder(parent / "lutris/games")) {
      if (!is_named_quake(file)) continue;
      for (const fs::path& path : read_lutris_paths(read_text(file))) {
        io_games.add(path, "Lutris");
        io_games.add(path.parent_path(), "Lutris");  // of a program
        io_games.add_wine_prefix(path, "Lutris");
      }
    }
  for (const fs::path& folder : list_folder(user.home / "Games"))
    if (is_named_quake(folder)) {
      io_games.add(folder, "Lutris");
      io_games.add_wine_prefix(folder, "Lutris");
    }
}

fs::path read_folder(const char* variable, const fs::path& otherwise) {
  const char* const value = std::getenv(variable);
  // The XDG base directory specification: relative paths are invalid.
  return value != nullptr && *value == '/' ? fs::path(value) : otherwise;
}

}  // namespace

UserFolders find_user_folders() {
  UserFolders user;
  user.home = read_folder("HOME", {});
  user.config = read_folder("XDG_CONFIG_HOME", user.home.empty() ? fs::path() : user.home / ".config");
  user.data = read_folder("XDG_DATA_HOME", user.home.empty() ? fs::path() : user.home / ".local/share");
  return user;
}

std::vector<InstalledGame> find_installed_games(const UserFolders& user) {
  if (user.home.empty()) return {};
  Collector games;
  find_steam(user, games);
  games.add_all_in(user.home / "GOG Games", "GOG");
  find_heroic(user, games);
  find_lutris(user, games);
  return games.take();
}

}  // namespace temblor::app
