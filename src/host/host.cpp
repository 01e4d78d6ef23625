#include "host/host.h"

#include <fmt/format.h>

#include <utility>

#include "client/input/input_variables.h"
#include "host/commands/host_commands.h"
#include "host/frame/frame_stages.h"
#include "host/frame/host_parts.h"
#include "host/frame/hud_program_stage.h"
#include "host/session/configure.h"
#include "host/session/games.h"

namespace temblor::host {

Host::Host(Services own_services, const HostVariables& own_variables, HostOptions own_options)
    : services(std::move(own_services)),
      variables(own_variables),
      options(std::move(own_options)),
      console{
          .commands = command::Console(own_variables.variables(),
                                       [this](std::string_view line) { print_line(*this, line); }),
          .ui = client::ConsoleUi(
              {.complete = [this](std::string_view line) { return console.commands.complete_line(line); },
               .read_clipboard = [this] { return services.window.clipboard(); },
               .write_clipboard = [this](std::string_view text) { services.window.set_clipboard(text); }}),
          .foreign_names = ForeignNames(console.commands, own_variables.variables()),
          .unfinished_line = {}},
      search(services) {}

// The worker's job uses the other parts, so it must be done before they are destroyed.
Host::~Host() {
  worker.wait();
}

void HostDeleter::operator()(Host* host) const {
  delete host;
}

base::Result<HostPointer> start_host(Services services, const HostVariables& variables, HostOptions options) {
  // The commands must be registered before the configuration files run: unknown commands in them are errors.
  HostPointer pointer(new Host(std::move(services), variables, std::move(options)));
  Host& host = *pointer;
  host.timing.now_s = host.services.window.now_s();
  TRY(host.game.data, GameData::open(host.options.folders));
  load_game_folders(host);
  client::add_binding_commands(host.console.commands, host.input.bindings,
                               [&host](std::string_view line) { print_line(host, line); });
  client::add_input_commands(host.console.commands, host.input.player, host.input.event_time_s);
  add_host_commands(host);
  StuffedText::add_rules(host);
  host.console.commands.set_foreign_setter([&host](command::Console::Arguments arguments) {
    return host.console.foreign_names.set_known(arguments);
  });
  host.console.commands.set_unknown_handler([&host](command::Console::Arguments arguments) {
    return run_hud_program_command(host, arguments) || host.console.foreign_names.handle(arguments);
  });
  if (host.services.open_audio) host.sound.output.emplace(host.services.open_audio);
  TRY_STATUS(run_configuration(host));
  return pointer;
}

bool run_frame(Host& io_host) {
  wait_for_frame(io_host);
  read_input(io_host);
  run_commands(io_host);
  apply_variables(io_host);
  read_network(io_host);
  look_and_move(io_host);
  make_scene(io_host);
  show_notices(io_host);
  play_sound(io_host);
  draw_and_show(io_host);
  if (io_host.wants_to_quit) leave_game(io_host);
  return !io_host.wants_to_quit;
}

void quit(Host& io_host) {
  io_host.wants_to_quit = true;
}

const FrameTimes& frame_times(const Host& host) {
  return host.timing.measured;
}

std::string find_played_level(const Host& host) {
  const Session& session = *host.game.session;
  if (!session.is_playing()) return "";
  const std::vector<std::string>& models = session.connection()->state().game().models;
  return models.size() > 1 ? std::filesystem::path(models[1]).stem().string() : "";
}

void append_commands(Host& io_host, std::string_view lines) {
  io_host.console.commands.append(lines);
}

}  // namespace temblor::host
