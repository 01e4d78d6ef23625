#include "host/commands/list_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"
#include "host/commands/command_adder.h"
#include "host/frame/host_parts.h"
#include "host/session/games.h"

namespace temblor::host {
namespace {

using Arguments = command::Console::Arguments;

// The name of a file without its folder and extension.
std::string stem(std::string_view file) {
  return std::filesystem::path(file).stem().string();
}

// Prints the names that contain the filter, and how many there are.
void print_names(Host& io_host, const std::vector<std::string>& names, Arguments arguments,
                 std::string_view what) {
  const std::string filter = arguments.size() > 1 ? base::to_lower(arguments[1]) : "";
  std::size_t count = 0;
  for (const std::string& name : names) {
    if (base::to_lower(name).find(filter) == std::string::npos) continue;
    print_line(io_host, fmt::format("   {}", name));
    ++count;
  }
  print_line(io_host, base::counted(count, what));
}

std::vector<std::string> list_files(const Host& host, std::string_view prefix, std::string_view suffix) {
  std::vector<std::string> names;
  for (const std::string& file : host.game.data->library.files().list(prefix, suffix))
    names.push_back(stem(file));
  return names;
}

// Levels without the models of items.
std::vector<std::string> list_level_names(const Host& host) {
  std::vector<std::string> names = list_files(host, "maps/", ".bsp");
  std::erase_if(names, [](const std::string& name) { return name.starts_with("b_"); });
  return names;
}

// The sky boxes, by the name of their upper side.
std::vector<std::string> list_skies(const Host& host) {
  constexpr std::string_view kUpperSide = "up";
  std::set<std::string> names;
  for (const std::string_view suffix : {".tga", ".png"})
    for (std::string name : list_files(host, "gfx/env/", suffix))
      if (name.ends_with(kUpperSide)) names.insert(name.substr(0, name.size() - kUpperSide.size()));
  return {names.begin(), names.end()};
}

std::vector<std::string> list_mods(const Host& host) {
  std::vector<std::string> names;
  for (const client::MenuGameFolder& folder : host.game.menu_lists->game_folders())
    names.push_back(folder.in_use ? folder.name + " (in use)" : folder.name);
  return names;
}

std::vector<std::string> list_demos(const Host& host) {
  std::vector<std::string> names;
  for (const client::MenuDemo& demo : host.game.menu_lists->demos()) names.push_back(demo.name);
  return names;
}

std::vector<std::string> list_saves(const Host& host) {
  std::vector<std::string> names;
  for (const client::MenuSave& save : host.game.menu_lists->saves()) names.push_back(save.name);
  return names;
}

void print_sources(Host& io_host) {
  for (const vfs::FileSystem::Source& source : io_host.game.data->library.files().sources())
    print_line(io_host, source.files_inside ? fmt::format("{} ({})", source.path.string(),
                                                          base::counted(*source.files_inside, "file"))
                                            : source.path.string());
}

// Prints where a file of the game comes from. A name without a folder may be in any one.
void locate_file(Host& io_host, Arguments arguments) {
  if (arguments.size() != 2)
    return io_host.console.commands.print_error("flocate FILE: for example maps/start.bsp");
  const vfs::FileSystem& files = io_host.game.data->library.files();
  const std::string& name = arguments[1];
  const std::string where = files.where(name);
  if (!where.empty()) return print_line(io_host, where);
  const std::vector<std::string> elsewhere = files.list("", "/" + base::to_lower(name));
  for (const std::string& found : elsewhere)
    print_line(io_host, fmt::format("{}: {}", found, files.where(found)));
  if (elsewhere.empty())
    print_line(io_host, fmt::format("\"{}\" is in no game folder", base::quotable(name)));
}

// Whether the name has this form, in which each '*' is any text.
bool has_form(std::string_view name, std::string_view form) {
  std::size_t n = 0, f = 0, after_star = std::string_view::npos, star_begin = 0;
  while (n < name.size()) {
    if (f < form.size() && form[f] == '*') {
      after_star = ++f;
      star_begin = n;
    } else if (f < form.size() && form[f] == name[n]) {
      ++f;
      ++n;
    } else if (after_star != std::string_view::npos) {
      f = after_star;
      n = ++star_begin;
    } else {
      return false;
    }
  }
  return form.find_first_not_of('*', f) == std::string_view::npos;
}

// Prints the files and folders in a folder of the game, or those whose names have a form.
void print_folder(Host& io_host, Arguments arguments) {
  std::string folder = arguments.size() > 1 ? base::to_lower(arguments[1]) : "";
  std::string form = "*";
  if (folder.find('*') != std::string::npos) {
    const std::size_t name = folder.rfind('/') + 1;
    form = folder.substr(name);
    folder.resize(name);
  } else if (!folder.empty() && !folder.ends_with('/')) {
    folder += '/';
  }
  std::set<std::string> names;
  for (const std::string& file : io_host.game.data->library.files().list(folder, "")) {
    const std::string name = file.substr(folder.size());
    const std::size_t end = std::min(name.find('/'), name.size());
    if (has_form(std::string_view(name).substr(0, end), form)) names.insert(name.substr(0, end + 1));
  }
  for (const std::string& name : names) print_line(io_host, fmt::format("   {}", name));
  print_line(io_host, base::counted(names.size(), "name"));
}

void print_level_name(Host& io_host) {
  if (!io_host.game.session->is_playing()) return print_line(io_host, "No game is running.");
  const client::Game& game = io_host.game.session->connection()->state().game();
  print_line(io_host, fmt::format("{}: {}", stem(game.models[1]), game.level_name));
}

// Any level with a start for players would do, so it is one of all.
void start_random_level(Host& io_host) {
  const std::vector<std::string> names = list_level_names(io_host);
  if (names.empty()) return io_host.console.commands.print_error("randmap: there are no levels");
  const auto ticks = static_cast<std::size_t>(io_host.timing.now_s * 1000);
  const base::Status started = start_map(io_host, names[ticks % names.size()]);
  if (!started.ok()) io_host.console.commands.print_error(started.error().message());
}

}  // namespace

void add_list_commands(Host& io_host) {
  const auto add = make_adder(io_host);
  const auto add_list = [&](std::string_view name, std::string_view what, auto list) {
    add(name, fmt::format("{} [PART]: lists all {}s, or those whose name contains PART.", name, what),
        [what, list](Host& host, Arguments arguments) { print_names(host, list(host), arguments, what); });
  };
  add("version", "Shows the version of Temblor.",
      [](Host& host, Arguments) { print_line(host, host.options.version); });
  add("path", "Lists the folders and archives that the game's files come from, in the order of search.",
      [](Host& host, Arguments) { print_sources(host); });
  add("dir",
      "dir [FOLDER]: lists the files in a folder of the game; dir maps/e1*.bsp: those with such names.",
      print_folder);
  add("flocate", "flocate FILE: shows where a file of the game comes from.", locate_file);
  add("mapname", "Shows the name of the level.", [](Host& host, Arguments) { print_level_name(host); });
  add("randmap", "Starts a new game on a random level.",
      [](Host& host, Arguments) { start_random_level(host); });
  for (const char* const name : {"mods", "games"}) add_list(name, "game folder", list_mods);
  add_list("demos", "demo", list_demos);
  add_list("saves", "saved game", list_saves);
  add_list("skies", "sky picture", list_skies);
  add_list("configs", "config file", [](const Host& host) { return list_files(host, "", ".cfg"); });
}

}  // namespace temblor::host
