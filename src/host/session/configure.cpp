#include "host/session/configure.h"

#include <fmt/format.h>

#include <sstream>

#include "assets/library.h"
#include "base/text.h"
#include "command/text.h"
#include "host/commands/configuration.h"
#include "host/frame/host_parts.h"
#include "host/frame/hud_program_stage.h"
#include "host/session/games.h"
#include "vfs/file_system.h"

namespace temblor::host {
namespace {

// Reports lines of temblor.cfg that could not be read to the player, and keeps a copy of the file, because it
// is overwritten when the program ends. `wrong_lines` were readable text, but not valid commands.
void report_damaged_configuration(Host& io_host, std::size_t wrong_lines) {
  const GameData& data = *io_host.game.data;
  const base::Result<ReadConfiguration> read = read_configuration(data);
  const std::size_t lost = wrong_lines + (read.ok() ? read->unreadable_lines : 1);
  if (lost == 0) return;
  const auto copy = copy_damaged_configuration(data);
  std::string text =
      fmt::format("{} of {} could not be read and {} ignored. All other settings are in effect.",
                  base::counted(lost, "line"), kConfigurationFile, lost == 1 ? "was" : "were");
  if (!copy.ok())
    text += fmt::format("\n\nThe file could not be copied: {}", copy.error().message());
  else if (*copy)
    text += fmt::format("\n\nA copy of the file was saved as\n{}", (*copy)->string());
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) print_line(io_host, line);
  io_host.notices.push_back({"Damaged settings", text, {{"Options", client::MenuPage::kOptions}}});
}

// While the player is on a server, without what that has set.
std::string current_configuration(Host& io_host) {
  const StuffedText::OwnSettings own = io_host.stuffed_text.own_settings(io_host);
  return configuration_text(own.bindings.to_text(),
                            io_host.variables.to_text(own.variables, io_host.overrides));
}

// Stock data has this script in quake.rc; `stuffcmds` marks where the commands of the command line run.
constexpr std::string_view kStartupFile = "quake.rc";
constexpr std::string_view kStockStartup =
    "exec default.cfg\nexec config.cfg\nexec autoexec.cfg\nstuffcmds\nstartdemos demo1 demo2 demo3\n";

// A game's default.cfg is for its own settings and the additional keys that it binds. Our bindings override
// it.
std::string default_commands(const GameData& data) {
  const base::Result<std::string> text = read_commands(data, "default.cfg");
  client::Bindings own;
  own.add_defaults();
  return (text.ok() ? *text + "\n" : "") + own.bind_lines();
}

// Returns the text of a file that the startup script runs. Scripts name the files of stock Quake, which need
// not exist.
base::Result<std::string> read_startup_file(Host& io_host, std::string_view name) {
  const GameData& data = *io_host.game.data;
  if (name == "default.cfg") return default_commands(data);
  if (name == "config.cfg") {
    io_host.variables.adopt_game_defaults();
    io_host.game.startup.has_configured = true;
    const std::optional<std::string> file = configuration_to_run(data);
    if (!file) return std::string();
    return *file == name ? read_commands(data, name) : command::join_words({"exec", *file});
  }
  if (!has_commands(data, name)) {
    if (name == kStartupFile) return std::string(kStockStartup);
    if (name == "autoexec.cfg") return std::string();
  }
  return read_commands(data, name);
}

base::Result<std::string> read_console_file(Host& io_host, std::string_view name) {
  if (name == kConfigurationFile) {
    TRY(ReadConfiguration configuration, read_configuration(*io_host.game.data));
    return std::move(configuration.text);
  }
  return io_host.game.startup.is_running ? read_startup_file(io_host, name)
                                         : read_commands(*io_host.game.data, name);
}

// Runs commands at once, before anything that is queued after them. `wait` has no frames to wait for. An
// alias that waits and calls itself goes on in the frames.
void run_at_once(Host& io_host, std::string_view commands) {
  constexpr int kMaxWaits = 100;
  command::Console& console = io_host.console.commands;
  console.append(commands);
  console.run();
  for (int waits = 0; console.has_pending() && waits < kMaxWaits; ++waits) console.run();
}

// The player's settings are read even if a mod's script does not ask for them: they are written at the end.
void run_startup_script(Host& io_host) {
  StartupScript& startup = io_host.game.startup;
  client::Bindings& bindings = io_host.input.bindings;
  bindings.unbind_all();
  bindings.add_defaults();
  startup = {};
  startup.is_running = true;
  const std::size_t errors = io_host.console.commands.errors_in_file(kConfigurationFile);
  run_at_once(io_host, command::join_words({"exec", std::string(kStartupFile)}));
  if (!startup.has_configured) run_at_once(io_host, "exec config.cfg");
  startup.is_running = false;
  if (configuration_to_run(*io_host.game.data) == kConfigurationFile)
    report_damaged_configuration(io_host,
                                 io_host.console.commands.errors_in_file(kConfigurationFile) - errors);
  report_unknown_names(io_host);
}

}  // namespace

// The menu refers to the pictures of the data and to the lists, so it is made last.
void load_game_folders(Host& io_host) {
  LoadedGame& game = io_host.game;
  GameData& data = *game.data;
  game.session = std::make_unique<Session>(io_host.services, data.library, data.write_folder,
                                           io_host.variables.server(), io_host.options.program_file);
  game.texts = {};
  game.hud_program = std::make_unique<client::HudProgram>(hud_program_services(io_host));
  data.presentation.set_hud_program(game.hud_program.get());
  game.menu_lists = std::make_unique<MenuLists>(io_host, data);
  game.menu.emplace(io_host.variables.variables(), data.presentation.pictures(), game.menu_lists->content());
}

void restore_default_bindings(Host& io_host) {
  io_host.input.bindings.unbind_all();
  std::istringstream lines(default_commands(*io_host.game.data));
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("bind ")) run_at_once(io_host, line);
}

base::Status run_configuration(Host& io_host) {
  command::Variables& variables = io_host.variables.variables();
  // Discard the settings of the previous game folders. The command line's values are applied again below.
  io_host.overrides.release_changed(variables);
  io_host.variables.reset();
  io_host.variables.server().set_registered(
      io_host.game.data->library.files().contains(assets::kRegisteredMark));
  io_host.console.commands.set_loader(
      [&io_host](std::string_view name) { return read_console_file(io_host, name); });
  run_startup_script(io_host);
  if (io_host.options.apply_overrides)
    TRY_STATUS(io_host.overrides.apply(io_host.options.apply_overrides, variables));
  io_host.console.ui.load_history(read_history(*io_host.game.data));
  io_host.video.window_settings = io_host.variables.window();
  // The game can still be played if this display does not support the window settings.
  print_if_error(io_host, io_host.services.window.apply(io_host.video.window_settings));
  for (const std::string& line : io_host.options.commands) io_host.console.commands.append(line);
  io_host.game.has_begun = false;
  return base::Ok{};
}

namespace {

// Switches to these folders, or fails before anything has changed.
base::Status change_folders(Host& io_host, GameFolders folders) {
  // The settings belong to the old folders: save them before the write folder changes.
  TRY_STATUS(save_configuration(io_host));
  TRY(std::unique_ptr<GameData> data, GameData::open(folders));
  // Nothing below can fail because of the folders. Destroy users before the data that they refer to.
  disconnect(io_host);
  io_host.game.menu.reset();
  io_host.game.menu_lists.reset();
  io_host.game.session.reset();
  io_host.game.hud_program.reset();
  io_host.game.data = std::move(data);
  io_host.options.folders = std::move(folders);
  // The command line's "+map NAME" was meant for the first game only.
  io_host.options.commands.clear();
  load_game_folders(io_host);
  return run_configuration(io_host);
}

}  // namespace

base::Status change_games(Host& io_host, std::vector<std::string> games) {
  GameFolders folders = io_host.options.folders;
  folders.games = std::move(games);
  return change_folders(io_host, std::move(folders));
}

base::Status change_source(Host& io_host, const GameSource& source) {
  GameFolders folders = io_host.options.folders;
  folders.base_folder = source.base_folder;
  folders.games.clear();
  folders.is_installed = source.is_installed;
  if (folders != io_host.options.folders) {
    TRY_STATUS(change_folders(io_host, std::move(folders)));
    // The game code of the command line belongs to the first game data.
    io_host.options.program_file.clear();
  }
  return io_host.options.remember_source ? io_host.options.remember_source(source.name) : base::Ok{};
}

base::Status save_configuration(Host& io_host) {
  const std::filesystem::path& folder = io_host.game.data->write_folder;
  TRY_STATUS(io_host.services.write_file(folder / kConfigurationFile,
                                         base::as_bytes(current_configuration(io_host))));
  const std::string history = io_host.console.ui.history_text();
  // Do not overwrite the history of an earlier run with nothing.
  if (history.empty()) return base::Ok{};
  return io_host.services.write_file(folder / kHistoryFile, base::as_bytes(history));
}

base::Status write_configuration(Host& io_host, std::string_view file) {
  constexpr std::string_view kSuffix = ".cfg";
  const std::optional<std::string> name =
      vfs::normalize_name(fmt::format("{}{}", file, base::to_lower(file).ends_with(kSuffix) ? "" : kSuffix));
  if (!name) return base::error(base::ErrorCode::kUsage, "\"{}\" is not a valid file name", file);
  const std::filesystem::path path = io_host.game.data->write_folder / *name;
  TRY_STATUS(io_host.services.write_file(path, base::as_bytes(current_configuration(io_host))));
  print_line(io_host, fmt::format("Settings saved: {}", io_host.game.data->shorten_path(path)));
  return base::Ok{};
}

}  // namespace temblor::host
