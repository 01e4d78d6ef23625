// The picture of a frame: the view, the overlay, the window.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "client/demo/demo_bar.h"
#include "client/hud/connection_warning.h"
#include "client/hud/corner_text.h"
#include "host/frame/corner_readouts.h"
#include "host/frame/debug_shapes.h"
#include "host/frame/entity_boxes.h"
#include "host/frame/frame_painter.h"
#include "host/frame/frame_stages.h"
#include "host/frame/host_parts.h"
#include "host/frame/hud_program_stage.h"
#include "host/frame/presentation_settings.h"
#include "host/session/games.h"

namespace temblor::host {
namespace {

// The state of the demo or the game that is shown; null if there is none.
const client::ClientState* find_shown_state(const Host& host) {
  if (host.demos.session) return &host.demos.session->state();
  const client::Connection* const connection = host.game.session->connection();
  return connection != nullptr ? &connection->state() : nullptr;
}

constexpr double kDemoBarVisible_s = 3;

// The variables that drawing needs. They are read before a server tick starts in parallel, because the game's
// code may set variables.
struct DrawSettings {
  render::Settings render;
  client::ConsoleSettings console;
  ReadoutSettings readouts;
  client::HudSize size{};
};

// How a dead player continues, for the center of the screen. Empty for a demo. The keys are up to the game's
// code; the shipped games and the stock game agree on them.
std::string_view choose_death_hint(const Host& host) {
  if (host.demos.session) return {};
  if (!host.game.session->is_alone()) return "Press FIRE to respawn";
  return server::can_resume_from_save(*host.game.session->server())
             ? "Press FIRE to load the last save\nPress JUMP to restart the level"
             : "Press FIRE to restart the level";
}

// Settings that show more of a level than other players see are for games alone and demos.
void forbid_cheats(const Host& host, render::Settings& io_settings) {
  if (host.demos.session || host.game.session->is_alone()) return;
  io_settings.draw_world = true;
  io_settings.light_view = render::LightView::kLit;
}

void add_readouts(Host& io_host, const DrawSettings& settings, const render::FrameStats& stats, int width,
                  int height) {
  SpeedMeter& meter = io_host.video.meter;
  update_meter(meter, io_host.timing.measured);
  const client::ClientState* const state = find_shown_state(io_host);
  const std::vector<std::string> lines =
      list_readouts(settings.readouts, {.meter = meter,
                                        .game = state != nullptr ? &state->game() : nullptr,
                                        .time_s = state != nullptr ? state->time_s() : 0,
                                        .stats = stats});
  int number = 0;
  for (const std::string& line : lines)
    client::draw_corner_text(io_host.game.data->presentation.pictures(), line, number++, settings.size.text,
                             width, height, io_host.video.overlay);
}

// Adds the demo bar, the console, the menu and the readouts to the overlay, from back to front.
void add_overlays(Host& io_host, const DrawSettings& settings, const render::FrameStats& stats, int width,
                  int height) {
  const assets::Pictures& pictures = io_host.game.data->presentation.pictures();
  render::DrawList& overlay = io_host.video.overlay;
  DemoPlayback& demos = io_host.demos;
  const client::ConsoleView view{.pictures = pictures,
                                 .time_s = io_host.timing.now_s,
                                 .game_runs = has_view(io_host) || io_host.game.menu->is_open(),
                                 .version = io_host.options.version,
                                 .settings = settings.console};
  if (demos.session && !demos.timed && !demos.is_attracting() &&
      (demos.session->is_paused() || demos.controls.idle_s() < kDemoBarVisible_s))
    client::draw_demo_bar(*demos.session, pictures, width, height, settings.size, overlay);
  if (demos.session && demos.controls.is_flying() && is_in_game(io_host))
    client::draw_free_camera_hint(pictures, width, height, settings.size, overlay);
  const client::Connection* const connection = io_host.game.session->connection();
  if (connection != nullptr)
    if (const std::optional<net::ServerSilence> silence = connection->server_silence())
      client::draw_connection_warning(pictures, *silence, settings.size, width, height, overlay);
  io_host.console.ui.draw(view, width, height, overlay);
  io_host.game.menu->draw(width, height, io_host.timing.now_s, overlay);
  add_readouts(io_host, settings, stats, width, height);
}

// Draws the view and the overlay on top, or a black background if there is no view or the console covers it.
void draw_frame(Host& io_host, const DrawSettings& settings, render::FrameBuffer& io_frame) {
  render::DrawList& overlay = io_host.video.overlay;
  render::FrameStats stats;
  overlay.clear();
  if (has_view(io_host) && !io_host.console.ui.covers_frame()) {
    stats = paint_view(io_host, settings.render, io_frame);
    // Before the overlay is drawn, so that the picture shows neither the menu nor the status bar.
    if (!io_host.saves.picture_request.empty()) {
      // If the card has failed, the CPU draws the next frame.
      if (read_view(io_host, io_frame)) write_save_picture(io_host, io_frame);
    }
    overlay = io_host.game.data->presentation.draw_list(
        *find_shown_state(io_host), io_frame.width(), io_frame.height(), io_host.video.presentation_settings);
  } else {
    paint_nothing(io_host, io_frame);
  }
  add_overlays(io_host, settings, stats, io_frame.width(), io_frame.height());
  paint_overlay(io_host, overlay, io_frame, stats);
}

}  // namespace

void update_presentation_settings(Host& io_host) {
  client::PresentationSettings& settings = io_host.video.presentation_settings;
  settings = io_host.variables.presentation();
  settings.view.fov_deg = io_host.input.fov_deg;
  settings.view.open_tint = io_host.video.server_tint;
  update_entity_boxes(io_host, settings);
  update_debug_shapes(io_host, settings);
  settings.sound = io_host.sound.output.has_value();
  settings.subtitles = settings.subtitles && is_in_game(io_host);  // they would cover a menu
  settings.hud.size.text = io_host.variables.console().text_size;
  settings.hud.teamplay = static_cast<int>(io_host.variables.variables().find("teamplay")->number);
  settings.hud.death_hint = choose_death_hint(io_host);
  settings.hud.shows_scores = io_host.input.player.buttons()[client::Button::kScores].is_down();
}

void draw_and_show(Host& io_host) {
  platform::Window& window = io_host.services.window;
  const HostVariables& variables = io_host.variables;
  Session& session = *io_host.game.session;
  FrameTimes& times = io_host.timing.measured;
  const double start_s = window.now_s();
  update_technique(io_host);
  update_renderer(io_host);
  const ScreenSettings screen_settings = variables.screen();
  render::FrameBuffer& frame = io_host.video.screen.begin(window.size(), screen_settings);
  const auto step = [&io_host, &session, halted = is_halted(io_host)] {
    session.step_server(io_host.timing.now_s, halted);
  };
  DrawSettings settings{variables.render(), variables.console(), variables.readouts(),
                        io_host.video.presentation_settings.hud.size};
  forbid_cheats(io_host, settings.render);
  // Run the tick in parallel only if the frame rate needs it. With time to spare, the tick can follow the
  // frame, and drawing is done sooner with all cores to itself. The menus and the console read variables,
  // which the game's code may set meanwhile, so no tick runs while they are open.
  const bool is_parallel = variables.is_parallel() && !io_host.timing.has_time_to_spare &&
                           session.server() != nullptr && is_in_game(io_host);
  draw_hud_program(io_host, frame.width(), frame.height());
  if (is_parallel) io_host.worker.begin(step);
  draw_frame(io_host, settings, frame);
  times.drawing_s = window.now_s() - start_s;
  if (const std::optional<double> drawing_s = find_drawing_time_s(io_host, times.drawing_s))
    io_host.video.screen.update_scale(screen_settings, *drawing_s);
  const base::Status shown = show_frame(io_host, screen_settings);
  const double shown_s = window.now_s();
  times.present_s = shown_s - start_s - times.drawing_s;
  times.latency_s = io_host.input.oldest_event_s ? shown_s - *io_host.input.oldest_event_s : 0;
  if (is_parallel)
    io_host.worker.wait();
  else
    step();
  // A window may stay lost for many frames. Report it once.
  if (const bool was_shown = std::exchange(io_host.video.was_shown, shown.ok()); was_shown)
    print_if_error(io_host, shown);
}

}  // namespace temblor::host
