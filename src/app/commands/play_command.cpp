#include "app/commands/play_command.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>

#include "app/commands/command_line.h"
#include "app/compile/play_watch.h"
#include "app/files/atomic_write.h"
#include "app/files/game_files.h"
#include "app/files/interrupt.h"
#include "app/files/system.h"
#include "app/installs/game_choice.h"
#include "command/text.h"
#include "host/host.h"
#include "host/host_variables.h"
#include "host/services.h"
#include "platform/egl/offscreen_context.h"
#include "platform/posix/udp_socket.h"
#include "platform/sdl2/audio.h"
#include "platform/sdl2/window.h"

namespace temblor::app {
namespace {

constexpr const char* kPlayHelpFooter =
    R"(Without --map, --demo, --replay, and --connect, the menu opens. In the game, Escape opens the menu and ` the
console, where `help NAME` explains a command or variable.

Examples:
  temblor play
  temblor --basedir ~/quake play --map e1m1 --size 1920x1080
  temblor --basedir ~/quake play --connect example.net:26000
  temblor --basedir ~/quake play --map start --progs mymod/progs.dat
  temblor -basedir ~/quake -game hipnotic +skill 2 +map start)";

// Prints a line of the console. Characters with the high bit set are the same letters in bronze. Flushes, so
// that scripts can follow the output.
void print_line(std::string_view line) {
  std::string text(line);
  for (char& c : text) c = static_cast<char>(c & 127);
  std::erase_if(text, [](char c) { return c < ' ' && c != '\t'; });
  fmt::print("{}\n", text);
  std::fflush(stdout);
}

// Connects the host to this machine: SDL2 for window and audio, POSIX for sockets and files.
host::Services make_services(platform::Window& window, bool silent) {
  host::Services services{
      .window = window,
      .open_socket = [](std::uint16_t port) { return platform::posix::open_udp_socket({.port = port}); },
      .look_up = [](std::string_view host,
                    std::uint16_t default_port) { return platform::posix::look_up(host, default_port); },
      .is_own_host = platform::posix::is_own_host,
      .open_gl = platform::egl::make_offscreen_context,
      .write_file = [](const std::filesystem::path& file,
                       base::Bytes bytes) { return replace_file(file, bytes, Remedy::kNone); },
      .print_line = print_line,
      .seed = make_seed(),
      .secret = make_secret()};
  if (!silent)
    services.open_audio = [](platform::AudioFill fill) {
      return platform::sdl2::open_audio({}, std::move(fill));
    };
  return services;
}

// Returns the folder for settings and saved games when the game directory is not writable (XDG base
// directories).
std::filesystem::path user_folder(const UserFolders& user) {
  return user.data.empty() ? std::filesystem::path() : user.data / "temblor";
}

base::Status remember_choice(const UserFolders& user, std::string_view name) {
  const std::filesystem::path file = find_choice_file(user);
  if (file.empty()) return base::error(base::ErrorCode::kIo, "the choice cannot be stored: HOME is not set");
  return write_choice(file, name);
}

// Whether the command line starts or joins a game: then --exec waits until the player is in it.
bool starts_game(const PlayOptions& options, const std::string& watched_level) {
  return !options.map.empty() || !watched_level.empty() || !options.connect.empty();
}

// Returns the console commands to run at the start: --exec, unless it waits for a game, then --map, --demo,
// --replay, and --connect.
std::vector<std::string> list_first_commands(const PlayOptions& options, const std::string& watched_level) {
  std::vector<std::string> lines;
  if (!starts_game(options, watched_level)) lines = options.execute;
  for (const auto& [command, name] :
       {std::pair{"map", options.map.empty() ? watched_level : options.map},
        std::pair{"playdemo", options.demo}, std::pair{"playreplay", options.replay},
        std::pair{"connect", options.connect}})
    if (!name.empty()) lines.push_back(command::join_words({command, name}));
  return lines;
}

// Sets the variables that the command line names. The host calls it again after the configuration files,
// because the command line has priority.
base::Status apply_command_line(const PlayOptions& options, const CommonOptions& common,
                                command::Variables& io_variables) {
  TRY_STATUS(apply_options(common, std::nullopt, io_variables));
  if (!options.size) return base::Ok{};
  TRY_STATUS(io_variables.set("vid_width", std::to_string(options.size->width)));
  return io_variables.set("vid_height", std::to_string(options.size->height));
}

}  // namespace

Command* add_play_command(Command& program, PlayOptions& io_options) {
  Command* command = program.add_subcommand("play", "Play the game in a window");
  command->add_option("--map", io_options.map, "Start a game on this level")->type_name("NAME");
  command->add_option("--demo", io_options.demo, "Play a demo")->type_name("NAME");
  command->add_option("--replay", io_options.replay, "Play the replay of a lockstep game")->type_name("FILE");
  command->add_option("--connect", io_options.connect, "Join a network game")->type_name("HOST[:PORT]");
  add_parsed_option(*command, "--size", io_options.size, parse_size, "Window size")->type_name("WxH");
  command->add_option("--progs", io_options.program, "Game code (default: progs.dat of the game directories)")
      ->type_name("FILE");
  command
      ->add_option("--exec", io_options.execute,
                   "Run console commands at the start, or once you are in the game of --map or --connect; "
                   "repeatable")
      ->type_name("COMMANDS")
      ->allow_extra_args(false)
      ->take_all();
  command
      ->add_option("--watch", io_options.watch,
                   "Reload this .map, .bsp, or progs.dat whenever it is saved; repeatable")
      ->type_name("FILE")
      ->allow_extra_args(false)
      ->take_all();
  command->add_flag("--nosound", io_options.silent, "Open no audio device");
  command->add_option("--duration", io_options.duration_s, "Quit after this time, for scripts")
      ->type_name("SECONDS")
      ->check(not_negative());
  command->footer(kPlayHelpFooter);
  return command;
}

base::Status run_play(const PlayOptions& options, const CommonOptions& common,
                      const host::HostVariables& variables) {
  Interrupt interrupt;
  TRY_STATUS(apply_command_line(options, common, variables.variables()));
  const UserFolders user = find_user_folders();
  TRY(GameChoice choice, choose_game(common.folders, user));
  if (!choice.warning.empty()) print_line(choice.warning);
  const host::GameFolders folders{choice.base_folder, common.folders.games, user_folder(user),
                                  is_installed_game(choice.base_folder)};
  // Report a damaged archive before a window opens.
  TRY_STATUS(host::mount_games(folders));
  TRY(PlayWatch watch, PlayWatch::begin(options.watch, folders));
  base::Result<std::unique_ptr<platform::Window>> opened =
      platform::sdl2::open_window("Temblor", variables.window());
  if (!opened.ok())
    return base::error(base::ErrorCode::kIo,
                       "no display for a window ({}); `temblor render` makes pictures and films without one",
                       opened.error().message());
  const std::unique_ptr<platform::Window> window = std::move(*opened);
  print_line(fmt::format("display: {}", window->describe()));
  host::HostOptions host_options{
      .folders = folders,
      .sources = std::move(choice.sources),
      .asks_for_source = choice.asks,
      .remember_source = [&](std::string_view name) { return remember_choice(user, name); },
      .program_file = options.program.empty() ? watch.program() : options.program,
      .commands = list_first_commands(options, watch.level()),
      .commands_in_game = starts_game(options, watch.level()) ? options.execute : std::vector<std::string>(),
      .version = "Temblor " TEMBLOR_VERSION,
      .apply_overrides = [&] { return apply_command_line(options, common, variables.variables()); }};
  TRY(const host::HostPointer host,
      host::start_host(make_services(*window, options.silent), variables, std::move(host_options)));
  // From here on, Ctrl-C quits as the menu does, so that the host can save settings and disconnect.
  interrupt.defer();
  const double began_s = clock_s();
  const auto is_over = [&] {
    return interrupt.was_requested() || (options.duration_s > 0 && clock_s() - began_s >= options.duration_s);
  };
  while (host::run_frame(*host)) {
    if (is_over()) host::quit(*host);
    for (const std::string& line : watch.look(clock_s(), host::find_played_level(*host)))
      host::append_commands(*host, line);
  }
  return base::Ok{};
}

}  // namespace temblor::app
