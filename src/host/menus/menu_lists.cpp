#include "host/menus/menu_lists.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "formats/game/sav.h"
#include "formats/levels/entities.h"
#include "host/host.h"
#include "vfs/disk.h"

namespace temblor::host {
namespace {

constexpr std::string_view kHelp = R"(# Playing
W A S D walk, the mouse looks, its left button fires and its right one jumps.
1 to 8 and the wheel choose weapons. Shift walks slowly where one always runs.
F6 saves at once, F9 goes back to that. Escape opens the menu.
A game for one is also saved by itself. Who is dead fires to go on from the last save, or jumps to begin the level again.
# The console
` opens it. Type a word and press Tab to see what there is; `help NAME` explains it.
`map NAME` begins a game on a level, `maps` lists them.
`bind KEY "COMMANDS"` has a key run any commands.
# Where things are kept
Settings are in temblor.cfg, saved games in NAME.sav, pictures in temblorNNNN.png: all in the game's folder.
Commands in autoexec.cfg are run at every start.
)";

// The level's own title. Only the entities of a level are looked at: they stand at its end mostly, and all of
// it is read, which for all levels of a game takes a moment.
std::string title_of(const vfs::FileSystem& files, const std::string& file) {
  const base::Result<base::ByteVector> bytes = files.read(file);
  if (!bytes.ok()) return {};
  base::ByteReader reader(*bytes);
  reader.u32();  // the version; the first lump is the entities' in all of them
  const std::uint32_t offset = reader.u32(), size = reader.u32();
  if (!reader.ok() || offset > bytes->size() || size > bytes->size() - offset) return {};
  const auto entities = formats::read_entities(base::as_text(base::Bytes(*bytes).subspan(offset, size)));
  if (!entities.ok() || entities->empty()) return {};
  return std::string(entities->front().find("message").value_or(""));
}

}  // namespace

std::vector<std::string> written_files(const GameData& data, std::string_view suffix) {
  std::vector<std::pair<std::filesystem::file_time_type, std::string>> found;
  std::error_code failure;
  for (const auto& entry : std::filesystem::directory_iterator(data.write_folder, failure)) {
    if (entry.path().extension() != suffix) continue;
    std::error_code ignored;
    found.emplace_back(entry.last_write_time(ignored), entry.path().stem().string());
  }
  std::sort(found.rbegin(), found.rend());
  std::vector<std::string> names;
  for (auto& [time, name] : found) names.push_back(std::move(name));
  return names;
}

MenuLists::MenuLists(Host& host, const GameData& data) : host_(host), data_(data), thumbnails_(data) {}

std::vector<client::MenuLevel> MenuLists::levels() {
  if (!levels_.empty()) return levels_;
  const vfs::FileSystem& files = data_.library.files();
  for (const std::string& file : files.list("maps/", ".bsp")) {
    const std::string name = file.substr(5, file.size() - 9);
    if (!name.starts_with("b_")) levels_.push_back({name, title_of_level(name)});
  }
  return levels_;
}

const std::string& MenuLists::title_of_level(const std::string& level) {
  const auto [entry, is_new] = titles_.try_emplace(level);
  const std::string file = "maps/" + level + ".bsp";
  if (is_new && data_.library.files().contains(file)) entry->second = title_of(data_.library.files(), file);
  return entry->second;
}

std::vector<client::MenuSave> MenuLists::saves() {
  std::vector<client::MenuSave> saves;
  for (const std::string& name : written_files(data_, ".sav")) {
    const base::Result<base::ByteVector> bytes = vfs::read_disk_file(data_.write_folder / (name + ".sav"));
    if (!bytes.ok()) continue;
    const base::Result<formats::Sav> sav = formats::read_sav(base::as_text(*bytes));
    if (!sav.ok()) {
      saves.push_back({.name = name, .level_title = "damaged"});
      continue;
    }
    // "The Slipgate Complex   kills:  3/ 21"
    client::MenuSave save{
        .name = name, .level_title = sav->comment.substr(0, 22), .time_s = double{sav->time_s}};
    // Of which it holds no more than that.
    if (const std::string& title = title_of_level(sav->map); title.size() > save.level_title.size())
      save.level_title = title;
    while (save.level_title.ends_with(' ') || save.level_title.ends_with('_')) save.level_title.pop_back();
    if (const std::size_t kills = sav->comment.find("kills:"); kills != std::string::npos) {
      save.kills = std::atoi(sav->comment.c_str() + kills + 6);
      if (const std::size_t slash = sav->comment.find('/', kills); slash != std::string::npos)
        save.monsters = std::atoi(sav->comment.c_str() + slash + 1);
    }
    saves.push_back(std::move(save));
  }
  return saves;
}

std::vector<client::MenuDemo> MenuLists::demos() const {
  std::set<std::string> names;
  for (const std::string& file : data_.library.files().list("", ".dem"))
    names.insert(file.substr(0, file.size() - 4));
  for (const std::string& name : written_files(data_, ".dem")) names.insert(name);
  std::vector<client::MenuDemo> demos;
  for (const std::string& name : names) demos.push_back({name, ""});
  return demos;
}

std::vector<client::MenuGameFolder> MenuLists::game_folders() const {
  std::vector<client::MenuGameFolder> folders;
  std::error_code failure;
  const auto in_use = data_.library.files().folders();
  for (const auto& entry : std::filesystem::directory_iterator(host_.folders().base_folder, failure)) {
    std::error_code ignored;
    const std::string name = entry.path().filename().string();
    if (!entry.is_directory(ignored) || name.starts_with('.')) continue;
    const auto has = [&](const char* file) { return std::filesystem::exists(entry.path() / file, ignored); };
    if (!has("pak0.pak") && !has("progs.dat") && !has("maps") && !has("gfx.wad")) continue;
    const bool is_used = std::any_of(in_use.begin(), in_use.end(), [&](const std::filesystem::path& folder) {
      return std::filesystem::equivalent(folder, entry.path(), ignored);
    });
    folders.push_back({name, "", is_used});
  }
  std::sort(folders.begin(), folders.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return folders;
}

client::MenuContent MenuLists::content() {
  Host* const host = &host_;
  return {
      .levels = [this] { return levels(); },
      .level_picture = [this](std::string_view level) { return thumbnails_.of_level(std::string(level)); },
      .episodes = {},
      .saves = [this] { return saves(); },
      .save_picture = [this](std::string_view save) { return thumbnails_.of_save(std::string(save)); },
      .demos = [this] { return demos(); },
      .game_folders = [this] { return game_folders(); },
      .servers = [host] { return host->found_servers(); },
      .search_servers = [host] { host->search_servers(); },
      .displays = [host] { return host->window().displays(); },
      .display_sizes = [host](int) { return host->window().full_screen_sizes(); },
      .game_runs = [host] { return host->session().is_playing(); },
      .can_save = [host] { return host->can_save(); },
      .unsaved = [host] { return host->unsaved(); },
      .keys_of = [host](std::string_view commands) { return host->bindings().keys_of(commands); },
      .clipboard = [host] { return host->window().clipboard(); },
      .help_text = [] { return std::string(kHelp); }};
}

}  // namespace temblor::host
