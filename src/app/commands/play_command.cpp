#include "app/commands/play_command.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>

#include "app/bench/system.h"
#include "app/commands/command_line.h"
#include "app/commands/play_watch.h"
#include "app/files/atomic_write.h"
#include "app/files/game_files.h"
#include "app/files/interrupt.h"
#include "command/text.h"
#include "host/host.h"
#include "platform/posix/udp_socket.h"
#include "platform/sdl2/audio.h"
#include "platform/sdl2/window.h"

namespace temblor::app {
namespace {

constexpr const char* kPlayHelpFooter =
    R"(Escape opens the menu, ` the console; `help NAME` there explains a command or variable.

Examples:
  temblor --basedir quake play
  temblor --basedir quake play --map e1m1 --size 1920x1080
  temblor --basedir quake play --connect example.net:26000
  temblor --basedir quake play --map start --progs mymod/progs.dat)";

void print_line(std::string_view line) {
  std::string text(line);
  // QuakeC's letters with the upper bit set are the same ones in another color.
  for (char& c : text) c = static_cast<char>(c & 127);
  std::erase_if(text, [](char c) { return c < ' ' && c != '\t'; });
  fmt::print("{}\n", text);
  std::fflush(stdout);
}

host::Services services_for(platform::Window& window, bool silent) {
  client::OpenAudioDevice open_audio = [](platform::AudioFill fill) {
    return platform::sdl2::open_audio({}, std::move(fill));
  };
  return {.window = window,
          .open_socket = [](std::uint16_t port) { return platform::posix::open_udp_socket({.port = port}); },
          .look_up = [](std::string_view host,
                        std::uint16_t default_port) { return platform::posix::look_up(host, default_port); },
          .open_audio = silent ? client::OpenAudioDevice() : std::move(open_audio),
          .write_file = [](const std::filesystem::path& file,
                           base::Bytes bytes) { return replace_file(file, bytes, Remedy::kNone); },
          .print_line = print_line,
          .seed = any_seed(),
          .secret = any_secret()};
}

// Where settings, saved games and the like go that may not lie beside the game's data.
std::filesystem::path user_folder() {
  const char* const data = std::getenv("XDG_DATA_HOME");
  if (data != nullptr && *data != 0) return std::filesystem::path(data) / "temblor";
  const char* const home = std::getenv("HOME");
  return home != nullptr ? std::filesystem::path(home) / ".local/share/temblor" : std::filesystem::path();
}

// What the command line asks for, as the console has it.
std::vector<std::string> first_commands(const PlayOptions& options, const std::string& watched_level) {
  std::vector<std::string> lines = options.execute;
  for (const auto& [command, name] :
       {std::pair{"map", options.map.empty() ? watched_level : options.map},
        std::pair{"playdemo", options.demo}, std::pair{"connect", options.connect}})
    if (!name.empty()) lines.push_back(command::join_words({command, name}));
  return lines;
}

base::Status apply_command_line(const PlayOptions& options, const CommonOptions& common,
                                command::Variables& io_variables) {
  TRY_STATUS(apply_options(common, std::nullopt, io_variables));
  if (!options.size) return base::Ok{};
  TRY_STATUS(io_variables.set("vid_width", std::to_string(options.size->width)));
  return io_variables.set("vid_height", std::to_string(options.size->height));
}

}  // namespace

Command* add_play_command(Command& program, PlayOptions& io_options) {
  Command* command = program.add_subcommand("play", "The game, in a window");
  command->add_option("--map", io_options.map, "Begins a game on this level")->type_name("NAME");
  command->add_option("--demo", io_options.demo, "Plays a recording")->type_name("NAME");
  command->add_option("--connect", io_options.connect, "Joins a game on another machine")
      ->type_name("HOST[:PORT]");
  add_parsed_option(*command, "--size", io_options.size, parse_size, "Size of the window")->type_name("WxH");
  command
      ->add_option("--progs", io_options.program, "The game's code; without it the game folders' progs.dat")
      ->type_name("FILE");
  command->add_option("--exec", io_options.execute, "Console commands to begin with; may be repeated")
      ->type_name("COMMANDS")
      ->allow_extra_args(false)
      ->take_all();
  command
      ->add_option(
          "--watch", io_options.watch,
          "A .map (compiled on every save), .bsp or progs.dat: the game goes on with the new one; may "
          "be repeated")
      ->type_name("FILE")
      ->allow_extra_args(false)
      ->take_all();
  command->add_flag("--nosound", io_options.silent, "Opens no audio device");
  command->add_option("--duration", io_options.duration_s, "Ends by itself after so many seconds")
      ->type_name("SECONDS")
      ->check(not_negative());
  command->footer(kPlayHelpFooter);
  return command;
}

base::Status run_play(const PlayOptions& options, const CommonOptions& common,
                      const host::HostVariables& variables) {
  Interrupt interrupt;
  TRY_STATUS(apply_command_line(options, common, variables.variables()));
  TRY(const std::filesystem::path base_folder, find_base_folder(common.folders));
  const host::GameFolders folders{base_folder, common.folders.games, user_folder(),
                                  is_installed_game(base_folder)};
  TRY(PlayWatch watch, PlayWatch::begin(options.watch, folders));
  base::Result<std::unique_ptr<platform::Window>> opened =
      platform::sdl2::open_window("Temblor", variables.window());
  if (!opened.ok())
    return base::error(
        base::ErrorCode::kIo,
        "there is no display to open a window on ({}); `temblor render` makes pictures and films "
        "without one",
        opened.error().message());
  const std::unique_ptr<platform::Window> window = std::move(*opened);
  host::HostOptions host_options{
      .folders = folders,
      .program_file = options.program.empty() ? watch.program() : options.program,
      .commands = first_commands(options, watch.level()),
      .version = "Temblor " TEMBLOR_VERSION,
      .apply_overrides = [&] { return apply_command_line(options, common, variables.variables()); }};
  TRY(const std::unique_ptr<host::Host> host,
      host::Host::start(services_for(*window, options.silent), variables, std::move(host_options)));
  interrupt.hold();
  const double began_s = clock_s();
  const auto is_over = [&] {
    return interrupt.was_noted() || (options.duration_s > 0 && clock_s() - began_s >= options.duration_s);
  };
  while (host->frame()) {
    if (is_over()) host->quit();
    for (const std::string& line : watch.look(clock_s())) host->console().append(line);
  }
  return base::Ok{};
}

}  // namespace temblor::app
