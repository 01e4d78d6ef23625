// The stages between input and scene: commands, settings, network, and the player's moves.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "command/text.h"
#include "host/frame/frame_stages.h"
#include "host/frame/host_parts.h"
#include "host/frame/hud_program_stage.h"
#include "host/frame/time_scale.h"
#include "host/lockstep/lockstep_games.h"
#include "host/menus/menus.h"
#include "host/session/configure.h"
#include "host/session/demos.h"
#include "host/session/games.h"

namespace temblor::host {
namespace {

// The server repeats a set_angles message in case it is lost. Equal angles within this time are taken for a
// repetition: turning the view again would undo the player's own mouse movement since then.
constexpr double kSameTurn_s = 0.1;

bool is_busy(const Host& host) {
  return host.demos.session || host.game.session->connection() != nullptr || host.wants_to_quit;
}

// Plays the demos of the start behind an open menu, now and after each game. If none can be played, this is
// not tried again.
void play_behind_menu(Host& io_host) {
  std::vector<std::string>& demos = io_host.game.startup.demos;
  if (demos.empty() || is_busy(io_host) || !io_host.game.menu->is_open()) return;
  if (!io_host.variables.plays_start_demos()) return;
  attract(io_host, demos);
  if (!io_host.demos.session) demos.clear();
}

// Sends the player's name and colors to the server if they have changed.
void send_player_settings(Host& io_host) {
  client::PlayerSettings player = io_host.variables.player();
  client::PlayerSettings& sent = io_host.sent_player;
  if (client::Connection* const connection = io_host.game.session->connection(); connection != nullptr) {
    if (player.name != sent.name) connection->send_command(command::join_words({"name", player.name}));
    if (player.shirt != sent.shirt || player.pants != sent.pants)
      connection->send_command(fmt::format("color {} {}", player.shirt, player.pants));
  }
  sent = std::move(player);
}

// Requests a picture for an autosave, as save_game() does for a save that the player made.
void note_autosave(Host& io_host) {
  if (io_host.game.session->server() == nullptr) return;
  std::string name = server::take_autosave_name(*io_host.game.session->server());
  if (name.empty()) return;
  io_host.saves = {.saved_s = io_host.timing.now_s, .picture_request = std::move(name)};
}

// Shakes the gamepad, harder and longer for more damage: up to 0.3 s. Armor counts as well as health.
void rumble(Host& io_host, const client::Events& events) {
  constexpr float kFullStrengthDamage = 50;
  float damage = 0;
  for (const net::Damage& hit : events.damages)
    damage += static_cast<float>(hit.armor) + static_cast<float>(hit.blood);
  const float strength = std::min(damage / kFullStrengthDamage, 1.0f) * io_host.variables.rumble();
  if (strength > 0)
    io_host.services.window.rumble(strength, strength / 2, 0.1 + 0.2 * static_cast<double>(strength));
}

// Moves the zoom towards its target and computes this frame's field of view.
void update_zoom(Host& io_host, const ZoomSettings& settings) {
  HostInput& input = io_host.input;
  const bool zooms = input.player.buttons()[client::Button::kZoom].is_down();
  const auto step = static_cast<float>(settings.speed * io_host.timing.measured.frame_s);
  input.zoom = std::clamp(input.zoom + (zooms ? step : -step), 0.0f, 1.0f);
  input.fov_deg = settings.fov_deg + (settings.zoom_fov_deg - settings.fov_deg) * input.zoom;
}

// Turns the view if the server has set its angles, for example after a teleport.
void follow_server_turn(HostInput& io_input, const client::Game& game, double now_s) {
  auto& turn = io_input.server_turn;
  const bool is_repeated = game.set_angles_deg == turn.angles_deg && now_s - turn.time_s < kSameTurn_s;
  if (game.turns != turn.count && !is_repeated) {
    io_input.player.set_view_angles(game.set_angles_deg);
    turn.angles_deg = game.set_angles_deg;
    turn.time_s = now_s;
  }
  turn.count = game.turns;
}

// Sends the moves that are due and predicts the player up to this frame. While no move is due, the prediction
// uses a preview of the next one, so that the view follows the input at any frame rate.
void send_moves(Host& io_host, const client::InputSettings& settings) {
  if (is_halted(io_host)) return;
  HostInput& input = io_host.input;
  Session& session = *io_host.game.session;
  const double now_s = io_host.timing.now_s;
  net::Move move = input.player.peek_move(now_s, settings);
  int due = session.count_due_moves(move, now_s);
  if (due > 0) move = input.player.take_move(now_s, settings);
  // A slow frame covers several ticks. All of them get the same move, but its impulse only once.
  for (; due > 0; --due) {
    session.send_move(move, now_s);
    move.impulse = 0;
  }
  input.prediction.begin_frame(*session.connection(), move, session.move_clock_s(now_s));
}

}  // namespace

void run_commands(Host& io_host) {
  LoadedGame& game = io_host.game;
  if (has_view(io_host))
    for (const std::string& line : std::exchange(io_host.options.commands_in_game, {}))
      io_host.console.commands.append(line);
  io_host.console.commands.run();
  game.startup.has_stuffed = false;
  report_unknown_names(io_host);
  if (!std::exchange(game.has_begun, true)) {
    if (!is_busy(io_host)) game.menu->open();
    if (std::exchange(io_host.options.asks_for_source, false) && game.menu->is_open())
      open_menu(io_host, client::MenuPage::kGameData);
  }
  if (std::optional<std::vector<std::string>> games = std::exchange(game.requested_games, std::nullopt))
    print_if_error(io_host, change_games(io_host, std::move(*games)));
  if (const std::optional<GameSource> source = std::exchange(game.requested_source, std::nullopt))
    print_if_error(io_host, change_source(io_host, *source));
  play_behind_menu(io_host);
}

void apply_variables(Host& io_host) {
  platform::Window& window = io_host.services.window;
  const platform::WindowSettings settings = io_host.variables.window();
  if (settings != io_host.video.window_settings) {
    print_if_error(io_host, window.apply(settings));
    io_host.video.window_settings = settings;
  }
  send_player_settings(io_host);
  load_game_texts(io_host);
  const DemoPlayback& demos = io_host.demos;
  // Capture the mouse only while it turns a view: a menu or an inactive window must leave it to the desktop.
  const bool needs_mouse =
      io_host.game.session->is_playing() || (demos.session && demos.controls.is_flying());
  window.capture_mouse(io_host.input.has_focus && is_in_game(io_host) && needs_mouse);
  const bool takes_text = io_host.console.ui.takes_text() || io_host.game.menu->wants_text();
  if (takes_text != io_host.input.takes_text) window.take_text(takes_text);
  io_host.input.takes_text = takes_text;
  update_server_search(io_host);
}

void read_network(Host& io_host) {
  Session& session = *io_host.game.session;
  io_host.timing.time_scale = choose_time_scale(io_host);
  session.set_time_scale(io_host.timing.time_scale);
  const bool was_playing = session.is_playing(), was_own = session.server() != nullptr;
  if (const std::optional<std::string> reason = session.read(io_host.timing.now_s)) {
    print_line(io_host, *reason);
    print_if_error(io_host, finish_recording(io_host));
    client::Notice notice{was_playing || was_own ? "Disconnected" : "Connection failed", *reason};
    if (!was_own) notice.pages = {{"Find servers", client::MenuPage::kJoin}};
    io_host.notices.push_back(std::move(notice));
  }
  if (client::Connection* const connection = session.connection()) {
    // Take the prints here: nothing else does before the level has begun, and they would be printed twice.
    client::Events& events = connection->state().events();
    for (const std::string& text : std::exchange(events.prints, {})) print_server_text(io_host, text);
    if (session.is_playing()) rumble(io_host, events);
    note_autosave(io_host);
    for (const std::string& line : connection->take_commands()) run_server_line(io_host, line);
  } else {
    io_host.stuffed_text.restore(io_host);
  }
  print_if_error(io_host, save_replay(io_host));
  print_game_text(io_host, session.take_server_output());
}

void look_and_move(Host& io_host) {
  const ZoomSettings zoom = io_host.variables.zoom();
  update_zoom(io_host, zoom);
  const client::InputSettings settings = io_host.variables.input();
  HostInput& input = io_host.input;
  if (!io_host.game.session->is_playing()) {
    input.server_turn = {};  // so that the first turn of the next game counts
    return;
  }
  const client::Game& game = io_host.game.session->connection()->state().game();
  follow_server_turn(input, game, io_host.timing.now_s);
  // Half the width of the picture at distance 1: tan(fov / 2), with pi / 360 to convert degrees. The ratio
  // keeps the mouse's speed on the screen the same while the view is zoomed.
  const auto half_width = [](float fov_deg) { return std::tan(fov_deg * 0.00872665f); };
  input.player.look({.time_s = io_host.timing.now_s,
                     .zoom = half_width(zoom.fov_deg) / half_width(input.fov_deg),
                     .ideal_pitch_deg = game.data.ideal_pitch_deg,
                     .may_drift = game.data.on_ground},
                    settings);
  send_moves(io_host, settings);
}

}  // namespace temblor::host
