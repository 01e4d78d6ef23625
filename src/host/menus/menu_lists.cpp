#include "host/menus/menu_lists.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <span>

#include "base/text.h"
#include "formats/game/sav.h"
#include "formats/levels/entities.h"
#include "host/frame/host_parts.h"
#include "host/menus/episodes.h"
#include "host/menus/save_list.h"
#include "host/session/game_texts.h"
#include "host/session/games.h"
#include "lab/registry.h"
#include "vfs/disk.h"

namespace temblor::host {
namespace {

constexpr std::string_view kHelp = R"(# Playing
WASD move, mouse aims, left button fires, right button jumps.
1 to 8 or the mouse wheel select weapons. Hold Shift to walk.
F6 quicksaves, F9 loads the quicksave. Escape opens the menu.
Single-player games autosave. When you die, press Fire to load the last save or Jump to restart the level.
# The console
` opens the console. Type a word and press Tab to complete it; `help NAME` explains it.
`map NAME` starts a game on a level, `maps` lists all levels.
`bind KEY "COMMANDS"` binds commands to a key.
# Files
Settings are in temblor.cfg, saved games in NAME.sav, screenshots in temblorNNNN.png, all in the game's folder.
Commands in autoexec.cfg run at every start.
)";

// Reads the entities of a level; none if the file is damaged. Nothing else is parsed, to keep the list fast
// when there are hundreds of levels. The start of a BSP file, in 32-bit little-endian integers:
//
//   version | lump 0: offset, size | lump 1: offset, size | ...
//             the entities, as text
std::vector<formats::Entity> read_level_entities(const vfs::FileSystem& files, const std::string& file) {
  const base::Result<base::ByteVector> bytes = files.read(file);
  if (!bytes.ok()) return {};
  base::ByteReader reader(*bytes);
  reader.u32();  // the version; in all versions the first lump holds the entities
  const std::uint32_t offset = reader.u32(), size = reader.u32();
  if (!reader.ok() || offset > bytes->size() || size > bytes->size() - offset) return {};
  return formats::read_faulty_entities(base::as_text(base::Bytes(*bytes).subspan(offset, size))).entities;
}

bool has_class(std::span<const formats::Entity> entities, std::string_view name) {
  return std::ranges::any_of(entities,
                             [&](const formats::Entity& entity) { return entity.find("classname") == name; });
}

}  // namespace

std::vector<std::string> list_written_files(const GameData& data, std::string_view suffix) {
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

namespace {

// Whether a folder has a file with this extension.
bool has_file(const std::filesystem::path& folder, std::string_view extension) {
  std::error_code failure;
  return std::ranges::any_of(std::filesystem::directory_iterator(folder, failure), [&](const auto& entry) {
    return base::to_lower(entry.path().extension().string()) == extension;
  });
}

// Folders of documentation, saved screenshots, or an editor's maps hold none. Names on old disks are in
// capitals.
bool has_game_data(const std::filesystem::path& folder) {
  std::error_code failure;
  for (const auto& entry : std::filesystem::directory_iterator(folder, failure)) {
    const std::string name = base::to_lower(entry.path().filename().string());
    if (name == "pak0.pak" || name == "progs.dat" || name == "gfx.wad") return true;
    if (name == "maps" && has_file(entry.path(), ".bsp")) return true;
  }
  return false;
}

// Sorts levels as they are played, by the names that games use: start, numbered levels, the last one, arenas
// ("dm" in the name), and others. Numbers sort by value.
std::pair<int, std::string> make_play_order(const std::string& name) {
  constexpr std::string_view kDigits = "0123456789";
  const bool is_numbered = name.find_last_of(kDigits) == name.size() - 1;
  const int rank = name == "start"                ? 0
                   : name == "end"                ? 2
                   : name.find("dm") != name.npos ? 3
                   : is_numbered                  ? 1
                                                  : 4;
  std::string key;
  for (std::size_t at = 0; at < name.size();) {
    const std::size_t end = std::min(name.find_first_not_of(kDigits, at), name.size());
    key += end > at ? fmt::format("{:0>6}", name.substr(at, end - at)) : std::string(1, name[at]);
    at = std::max(end, at + 1);
  }
  return {rank, key};
}

}  // namespace

MenuLists::MenuLists(Host& host, const GameData& data) : host_(host), data_(data), thumbnails_(data) {}

std::vector<client::MenuLevel> MenuLists::levels() {
  if (!levels_.empty()) return levels_;
  const vfs::FileSystem& files = data_.library.files();
  for (const std::string& file : files.list("maps/", ".bsp")) {
    const std::string name = file.substr(5, file.size() - 9);
    // b_*.bsp are the models of ammo boxes.
    if (name.starts_with("b_")) continue;
    const LevelTexts& texts = level_texts(name);
    levels_.push_back({name, texts.title, texts.has_flags});
  }
  std::ranges::sort(levels_, {}, [](const client::MenuLevel& level) { return make_play_order(level.name); });
  return levels_;
}

// Only levels that come with the level "start" belong to the game: below a mission pack are also the episodes
// of the game that it extends.
std::vector<client::MenuEpisode> MenuLists::episodes() {
  const vfs::FileSystem& files = data_.library.files();
  const std::optional<std::size_t> game = files.find_game("maps/start.bsp");
  std::vector<client::MenuLevel> levels_of_game = levels();
  if (game)
    std::erase_if(levels_of_game, [&](const client::MenuLevel& level) {
      return files.find_game("maps/" + level.name + ".bsp") != game;
    });
  return find_episodes(levels_of_game);
}

const MenuLists::LevelTexts& MenuLists::level_texts(const std::string& level) {
  const auto [entry, is_new] = texts_.try_emplace(level);
  const std::string file = "maps/" + level + ".bsp";
  if (!is_new || !data_.library.files().contains(file)) return entry->second;
  const std::vector<formats::Entity> entities = read_level_entities(data_.library.files(), file);
  if (entities.empty()) return entry->second;
  LevelTexts& texts = entry->second;
  texts.title = load_game_texts(host_)->localize(entities.front().find("message").value_or(""));
  texts.has_flags = has_class(entities, "item_flag_team1") && has_class(entities, "item_flag_team2");
  return texts;
}

std::vector<client::MenuSave> MenuLists::saves() {
  std::vector<client::MenuSave> saves;
  for (const std::string& name : list_written_files(data_, ".sav")) {
    const std::filesystem::path path = data_.write_folder / (name + ".sav");
    const base::Result<base::ByteVector> bytes = vfs::read_disk_file(path);
    if (!bytes.ok()) continue;
    const base::Result<formats::Sav> sav = formats::read_sav(base::as_text(*bytes));
    if (!sav.ok()) {
      saves.push_back({.name = name, .title = {}, .level_title = "damaged", .date = format_date(path)});
      continue;
    }
    client::MenuSave save = describe_save(*sav, level_texts(sav->map).title);
    save.name = name;
    save.date = format_date(path);
    saves.push_back(std::move(save));
  }
  return saves;
}

std::vector<client::MenuDemo> MenuLists::demos() const {
  std::set<std::string> names;
  for (const std::string& file : data_.library.files().list("", ".dem"))
    names.insert(file.substr(0, file.size() - 4));
  for (const std::string& name : list_written_files(data_, ".dem")) names.insert(name);
  std::vector<client::MenuDemo> demos;
  for (const std::string& name : names) demos.push_back({name, ""});
  return demos;
}

std::vector<client::MenuGameFolder> MenuLists::game_folders() const {
  std::vector<client::MenuGameFolder> folders;
  std::error_code failure;
  const auto in_use = data_.library.files().folders();
  for (const auto& entry : std::filesystem::directory_iterator(in_use.front().parent_path(), failure)) {
    std::error_code ignored;
    const std::string name = entry.path().filename().string();
    if (!entry.is_directory(ignored) || name.starts_with('.')) continue;
    if (!has_game_data(entry.path())) continue;
    const bool is_used = std::any_of(in_use.begin(), in_use.end(), [&](const std::filesystem::path& folder) {
      return std::filesystem::equivalent(folder, entry.path(), ignored);
    });
    folders.push_back({name, "", is_used});
  }
  std::sort(folders.begin(), folders.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return folders;
}

std::vector<client::MenuGameData> MenuLists::game_data() const {
  std::vector<client::MenuGameData> list;
  for (const GameSource& source : host_.options.sources)
    list.push_back({source.name, source.title, source.base_folder.string(),
                    source.base_folder == host_.options.folders.base_folder});
  return list;
}

std::vector<client::MenuTechnique> MenuLists::techniques() const {
  const std::size_t used = host_.variables.technique();
  std::vector<client::MenuTechnique> list;
  for (const lab::Technique& technique : lab::list_techniques())
    list.push_back({std::string(technique.name), std::string(technique.title), std::string(technique.summary),
                    list.size() == used});
  return list;
}

client::MenuContent MenuLists::content() {
  Host* const host = &host_;
  return {
      .levels = [this] { return levels(); },
      .level_pictures =
          [this](std::string_view level) {
            const LevelPictures* const pictures = thumbnails_.level_pictures(std::string(level));
            return pictures == nullptr ? client::MenuLevelPictures{}
                                       : client::MenuLevelPictures{&pictures->room, &pictures->overview};
          },
      .has_tremor = [this] { return data_.library.files().contains("progs/v_tremor.mdl"); },
      .episodes = [this] { return episodes(); },
      .saves = [this] { return saves(); },
      .save_picture = [this](std::string_view save) { return thumbnails_.save_picture(std::string(save)); },
      .demos = [this] { return demos(); },
      .game_folders = [this] { return game_folders(); },
      .game_data = [this] { return game_data(); },
      .techniques = [this] { return techniques(); },
      .servers = [host] { return host->search.found(); },
      .search_servers = [host] { search_servers(*host); },
      .displays = [host] { return host->services.window.displays(); },
      .display_sizes = [host](int display) { return host->services.window.full_screen_sizes(display); },
      .game_runs = [host] { return host->game.session->is_playing(); },
      .can_save = [host] { return can_save(*host); },
      .demo_plays = [host] { return host->demos.session && !host->demos.is_attracting(); },
      .unsaved = [host] { return find_unsaved_progress(*host); },
      .find_keys = [host](std::string_view commands) { return host->input.bindings.find_keys(commands); },
      .clipboard = [host] { return host->services.window.clipboard(); },
      .help_text = [] { return std::string(kHelp); }};
}

}  // namespace temblor::host
