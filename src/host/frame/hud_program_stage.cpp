#include "host/frame/hud_program_stage.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "client/hud/panel.h"
#include "command/text.h"
#include "host/frame/host_parts.h"

namespace temblor::host {
namespace {

// The state of the demo or the game that is shown; null if nothing is drawn of it.
const client::ClientState* find_drawn_state(const Host& host) {
  if (!has_view(host)) return nullptr;
  if (host.demos.session) return &host.demos.session->state();
  const client::Connection* const connection = host.game.session->connection();
  return connection != nullptr ? &connection->state() : nullptr;
}

client::HudMoment make_moment(const Host& host, const client::ClientState& state, int width, int height) {
  const client::PresentationSettings& settings = host.video.presentation_settings;
  client::HudMoment moment{.time_s = host.demos.session ? state.time_s() : host.game.session->time_s(),
                           .frame_time_s = host.timing.measured.frame_s,
                           .width = width,
                           .height = height,
                           .size = settings.hud.size,
                           .shows_scores = settings.hud.shows_scores,
                           .is_menu_open = host.game.menu->is_open(),
                           .is_demo = host.demos.session.has_value(),
                           .is_own_server = host.game.session->server() != nullptr,
                           .view_angles_deg = host.input.player.view_angles_deg(),
                           .fov_deg = host.input.fov_deg};
  if (const std::optional<render::Camera> camera = current_camera(host))
    moment.view_origin = camera->origin_world;
  return moment;
}

// Our own server is trusted, because its game code is installed on this machine.
void run_line_of_server(Host& io_host, std::string_view line) {
  io_host.stuffed_text.run(io_host, line, io_host.game.session->server() != nullptr);
}

// Alone, the ping is always 0. A server that answers in words of its own is asked rarely, because its answers
// reach the console.
void ask_for_pings(Host& io_host) {
  constexpr double kInterval_s = 3, kUnknownInterval_s = 60;
  double& asked_s = io_host.game.pings_asked_s;
  client::Connection* const connection = io_host.game.session->connection();
  if (connection == nullptr || io_host.demos.session || io_host.game.session->is_alone()) return;
  const std::vector<client::Player>& players = connection->state().game().players;
  const bool has_pings = std::any_of(players.begin(), players.end(),
                                     [](const client::Player& player) { return player.ping_ms > 0; });
  if (std::abs(io_host.timing.now_s - asked_s) < (has_pings ? kInterval_s : kUnknownInterval_s)) return;
  asked_s = io_host.timing.now_s;
  connection->state().expect_pings();
  connection->send_command("ping");
}

}  // namespace

client::HudProgramServices hud_program_services(Host& io_host) {
  GameData& data = *io_host.game.data;
  command::Console& console = io_host.console.commands;
  return {.library = data.library,
          .pictures = data.presentation.pictures(),
          .palette = data.look.palette,
          .variables = io_host.variables.variables(),
          .print = [&io_host](std::string_view text) { print_game_text(io_host, text); },
          .run_commands = [&console](std::string_view lines) { console.append(lines); },
          .run_stuffed =
              [&io_host](std::string_view lines) {
                while (!lines.empty()) {
                  const std::string_view line = lines.substr(0, lines.find('\n'));
                  lines.remove_prefix(std::min(line.size() + 1, lines.size()));
                  run_line_of_server(io_host, line);
                }
              },
          .has_command =
              [&console](std::string_view name) {
                const std::vector<std::string> names = console.complete(name);
                return std::find(names.begin(), names.end(), name) != names.end();
              },
          .binding = [&io_host](platform::Key key) { return io_host.input.bindings.commands(key); },
          .play_sound =
              [&data](std::string_view sample) {
                data.presentation.audio_scene().play_local(std::string(sample));
              }};
}

void draw_hud_program(Host& io_host, int width, int height) {
  client::HudProgram& program = *io_host.game.hud_program;
  const client::ClientState* const state = find_drawn_state(io_host);
  if (state == nullptr || io_host.console.ui.covers_frame() ||
      !io_host.video.presentation_settings.runs_hud_program)
    return program.rest();
  program.draw(state->game(), make_moment(io_host, *state, width, height));
  if (program.take_ping_request()) ask_for_pings(io_host);
}

void print_server_text(Host& io_host, std::string_view text) {
  const client::ClientState* const state = find_drawn_state(io_host);
  const bool is_offered = state != nullptr && io_host.video.presentation_settings.runs_hud_program;
  if (!is_offered || !io_host.game.hud_program->take_print(state->game(), text))
    print_game_text(io_host, text);
}

void run_server_line(Host& io_host, std::string_view line) {
  const client::ClientState* const state = find_drawn_state(io_host);
  const bool is_offered = state != nullptr && io_host.video.presentation_settings.runs_hud_program;
  if (!is_offered || !io_host.game.hud_program->take_stuffed(state->game(), line))
    run_line_of_server(io_host, line);
}

bool pass_event_to_hud_program(Host& io_host, const platform::InputEvent& event) {
  const client::ClientState* const state = find_drawn_state(io_host);
  if (state == nullptr || io_host.demos.session || !io_host.video.presentation_settings.runs_hud_program)
    return false;
  const auto* const key = std::get_if<platform::KeyChange>(&event.what);
  const bool is_consumed = io_host.game.hud_program->handle_event(state->game(), event);
  // Escape always opens the menu, so that no program can lock the player in.
  const bool may_consume = key == nullptr || (key->down && key->key != platform::Key::kEscape);
  return is_consumed && may_consume;
}

bool run_hud_program_command(Host& io_host, command::Console::Arguments arguments) {
  client::HudProgram& program = *io_host.game.hud_program;
  if (!io_host.video.presentation_settings.runs_hud_program) return false;
  std::string line = command::join_words(std::vector<std::string>(arguments.begin(), arguments.end()));
  if (const client::ClientState* const state = find_drawn_state(io_host))
    return program.run_command(state->game(), line);
  // A game that is starting: the program may know the command as soon as it is loaded.
  if (io_host.game.session->connection() == nullptr || !program.exists()) return false;
  io_host.options.commands_in_game.push_back(std::move(line));
  return true;
}

}  // namespace temblor::host
