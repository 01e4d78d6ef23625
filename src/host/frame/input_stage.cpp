// The start of a frame: the wait until it is due, then the window's events. Each event goes to the first part
// that consumes it:
//
//   event -> console (if open) -> menu (if open) -> demo controls -> HUD program -> bindings, mouse, gamepad,
//   window
#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "host/frame/frame_stages.h"
#include "host/frame/host_parts.h"
#include "host/frame/hud_program_stage.h"
#include "host/menus/menus.h"
#include "host/session/games.h"

namespace temblor::host {
namespace {

constexpr double kUnknownRefreshRate_hz = 60;  // if the display does not report its rate
constexpr double kHiddenRate_hz = 10;          // while the window cannot be seen

// In attract mode any key opens the menu, except keys with one of these bindings. A key that quits opens it,
// too: someone who presses any key to begin must not lose the game.
bool runs_while_attracting(std::string_view commands) {
  return commands == "toggleconsole" || commands == "screenshot" || commands == "help_menu" ||
         (commands.starts_with("menu_") && commands != "menu_quit");
}

// Whether the event is the console key while a menu is open. The game starts with a menu, so the key must
// work there, unless the menu is waiting for a key to bind.
bool opens_console_over_menu(const Host& host, const platform::InputEvent& event) {
  const auto* const key = std::get_if<platform::KeyChange>(&event.what);
  const client::Menu& menu = *host.game.menu;
  return key != nullptr && key->down && !key->repeated && menu.is_open() && !menu.is_waiting() &&
         host.input.bindings.commands(key->key) == "toggleconsole";
}

// Offers the event to the console, the menu and the demo controls. Returns whether one of them consumed it.
bool pass_to_overlays(Host& io_host, const platform::InputEvent& event) {
  client::Menu& menu = *io_host.game.menu;
  command::Console& commands = io_host.console.commands;
  if (opens_console_over_menu(io_host, event)) {
    menu.close();
    commands.append("toggleconsole");
    return true;
  }
  DemoPlayback& demos = io_host.demos;
  bool is_consumed = io_host.console.ui.handle(event);
  if (!is_consumed) is_consumed = menu.handle(event);
  if (!is_consumed && demos.session && !demos.is_attracting()) is_consumed = demos.controls.handle(event);
  for (const std::string& line : io_host.console.ui.take_commands()) commands.append(line);
  for (const std::string& line : menu.take_commands()) commands.append(line);
  return is_consumed;
}

// Runs the binding of a key. Escape always opens the menu, so that no binding can lock the player out.
// Repeated key events of a key that is held are ignored.
void handle_key(Host& io_host, const platform::KeyChange& key) {
  if (key.repeated) return;
  const std::string& commands = io_host.input.bindings.commands(key.key);
  const bool opens_menu =
      key.key == platform::Key::kEscape || (key.key == platform::Key::kPadStart && commands.empty()) ||
      (io_host.demos.is_attracting() && !io_host.game.menu->is_open() && !runs_while_attracting(commands));
  if (key.down && opens_menu) return toggle_menu(io_host);
  command::Console& console = io_host.console.commands;
  if (!key.down)
    console.append(io_host.input.held.release(key.key));
  else
    console.append(io_host.input.held.press(key.key, commands),
                   io_host.stuffed_text.has_bound(io_host.input.bindings, key.key)
                       ? command::Source::kServer
                       : command::Source::kPlayer);
  // Run them now, so that events within a frame keep their order and their times.
  console.run();
}

// Keeps the size of a window that the player has resized as a setting. In full screen the size belongs to the
// display.
void handle_resize(Host& io_host, const platform::WindowChanged& changed) {
  platform::WindowSettings& settings = io_host.video.window_settings;
  if (settings.mode != platform::WindowMode::kWindowed) return;
  settings.size = {std::max(1, changed.width), std::max(1, changed.height)};
  command::Variables& variables = io_host.variables.variables();
  for (const auto& [name, value] :
       {std::pair{"vid_width", settings.size.width}, std::pair{"vid_height", settings.size.height}})
    print_if_error(io_host, variables.set(name, std::to_string(value)));
}

// Returns whether the event is Enter while Alt is held. Another window may have seen Alt's release.
bool is_alt_enter(HostInput& io_input, const platform::InputEvent& event) {
  if (std::holds_alternative<platform::FocusChanged>(event.what)) io_input.is_alt_down = false;
  const auto* const key = std::get_if<platform::KeyChange>(&event.what);
  if (key == nullptr) return false;
  if (key->key == platform::Key::kAlt) io_input.is_alt_down = key->down;
  return key->key == platform::Key::kEnter && key->down && !key->repeated && io_input.is_alt_down;
}

// The player's own kind of full screen comes back, if the player has used one in this run.
void toggle_full_screen(Host& io_host) {
  constexpr const char *kMode = "vid_mode", *kWindow = "window";
  command::Variables& variables = io_host.variables.variables();
  const std::string mode = variables.find(kMode)->text;
  if (mode != kWindow) io_host.video.full_screen_mode = mode;
  print_if_error(io_host, variables.set(kMode, mode == kWindow ? io_host.video.full_screen_mode : kWindow));
}

void handle_close_request(Host& io_host) {
  // While a menu is open, which may be the question itself, the request quits without asking.
  if (find_unsaved_progress(io_host).empty() || io_host.game.menu->is_open())
    quit(io_host);
  else
    open_menu(io_host, client::MenuPage::kQuit);
}

// Returns from when an event counts. Some systems do not say when it happened, only when the window read it,
// in this frame: then it happened some time after the last frame, and counting from now would delay each by a
// frame.
double find_start_s(const FrameTiming& timing, const platform::InputEvent& event) {
  const double last_frame_s = timing.now_s - timing.measured.frame_s;
  return event.time_s < timing.now_s ? std::max(event.time_s, last_frame_s) : last_frame_s;
}

void handle_event(Host& io_host, const platform::InputEvent& event) {
  HostInput& input = io_host.input;
  input.oldest_event_s = std::min(input.oldest_event_s.value_or(event.time_s), event.time_s);
  input.event_time_s = find_start_s(io_host.timing, event);
  if (is_alt_enter(input, event)) return toggle_full_screen(io_host);
  const bool was_in_game = is_in_game(io_host);
  if (pass_to_overlays(io_host, event)) {
    // The game will not see the releases of the keys that were held when the overlay opened.
    if (was_in_game) release_held_keys(io_host);
    return;
  }
  if (pass_event_to_hud_program(io_host, event)) return;
  if (const auto* key = std::get_if<platform::KeyChange>(&event.what)) {
    handle_key(io_host, *key);
  } else if (const auto* mouse = std::get_if<platform::MouseMoved>(&event.what)) {
    input.player.add_mouse(mouse->right, mouse->down);
  } else if (const auto* axis = std::get_if<platform::PadAxisMoved>(&event.what)) {
    input.player.set_axis(axis->axis, axis->value);
  } else if (const auto* pad = std::get_if<platform::PadChanged>(&event.what)) {
    print_line(io_host, fmt::format("{} {}", pad->name, pad->connected ? "connected" : "disconnected"));
    if (!pad->connected) release_held_keys(io_host);
  } else if (const auto* focus = std::get_if<platform::FocusChanged>(&event.what)) {
    input.has_focus = focus->focused;
    if (!input.has_focus) release_held_keys(io_host);
  } else if (const auto* changed = std::get_if<platform::WindowChanged>(&event.what)) {
    handle_resize(io_host, *changed);
  } else if (std::holds_alternative<platform::CloseRequested>(event.what)) {
    handle_close_request(io_host);
  }
}

}  // namespace

void wait_for_frame(Host& io_host) {
  platform::Window& window = io_host.services.window;
  FrameTiming& timing = io_host.timing;
  const double rate_hz = io_host.variables.frames_per_second();
  const double display_hz = window.refresh_rate_hz();
  const double limit_hz = !window.is_visible() ? kHiddenRate_hz
                          : rate_hz > 0        ? rate_hz
                          : display_hz > 0     ? display_hz
                                               : kUnknownRefreshRate_hz;
  // A timed demo runs as fast as possible.
  timing.has_time_to_spare =
      !io_host.demos.timed && timing.limiter.wait(limit_hz, [&window] { return window.now_s(); });
  const double before_s = std::exchange(timing.now_s, window.now_s());
  timing.measured.frame_s = timing.now_s - before_s;
}

void read_input(Host& io_host) {
  HostInput& input = io_host.input;
  input.events.clear();
  io_host.services.window.poll(input.events);
  input.oldest_event_s.reset();
  for (const platform::InputEvent& event : input.events) handle_event(io_host, event);
  // For commands that are typed or come from files.
  input.event_time_s = io_host.timing.now_s - io_host.timing.measured.frame_s;
}

}  // namespace temblor::host
