#include "host/host_variables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "client/console/console_variables.h"
#include "client/input/input_variables.h"
#include "client/session/connection.h"
#include "client/view/client_variables.h"
#include "command/text.h"
#include "host/frame/corner_readouts.h"
#include "host/session/overrides.h"
#include "host/session/stuffed_text.h"
#include "host/video/render_settings.h"
#include "host/video/screen.h"
#include "lab/registry.h"
#include "platform/window.h"
#include "server/server_variables.h"

namespace temblor::host {
namespace {

// Names in the order of platform::WindowMode. The first one is the default.
constexpr std::array<std::string_view, 3> kModes = {"window", "borderless", "fullscreen"};
// The first one is true color, the default.
constexpr std::array<std::string_view, 2> kRenderers = {"cpu", "gl"};
constexpr std::array<std::string_view, 3> kGlWindowUses = {"auto", "on", "off"};  // GlWindowUse
constexpr std::array<std::string_view, 2> kColors = {"rgb", "indexed"};

// Settings that would confuse a player who finds them again the next day.
constexpr auto kDebugging = std::to_array<std::string_view>(
    {"r_show", "r_speeds", "r_drawworld", "r_drawentities", "r_fullbright", "r_lightmap", "r_lockpvs",
     "r_showbboxes", "r_technique", "host_timescale", "chase_active", "maxplayers"});

std::vector<std::string_view> list_technique_names() {
  std::vector<std::string_view> names;
  for (const lab::Technique& technique : lab::list_techniques()) names.push_back(technique.name);
  return names;
}

std::vector<std::string> list_names(const command::Variables& variables) {
  std::vector<std::string> names;
  for (const command::Variable* variable : variables.all()) names.push_back(variable->name);
  return names;
}

}  // namespace

struct HostVariables::Registered {
  explicit Registered(command::Variables& variables);

  RenderSettings render;
  client::ClientVariables client;
  client::InputVariables input;
  client::ConsoleVariables console;
  server::ServerVariables server;
  command::VariableIndex width, height, mode, display, vsync, color, scale, automatic_scale, target_fps,
      max_fps, time_scale, gamma, contrast, brightness, fov, zoom_fov, zoom_speed, name, shirt, pants, rumble,
      parallel, show_speed, show_latency, show_clock, show_player_speed, show_renderer, technique, renderer,
      gl_window, stuffed_text, max_players, port, start_demos, pause_unfocused, mute_unfocused;
  std::vector<std::string> saved;  // the names of the player's own variables
};

HostVariables::Registered::Registered(command::Variables& variables)
    : render(variables), client(variables), input(variables), console(variables), server(variables) {
  const platform::WindowSettings defaults;
  width = variables.add_int("vid_width", defaults.size.width, 1, 16384, "Width of the window, in pixels.");
  height =
      variables.add_int("vid_height", defaults.size.height, 1, 16384, "Height of the window, in pixels.");
  mode = variables.add_choice("vid_mode", kModes,
                              "Display mode: a window, borderless at the desktop's size, or full screen.");
  display = variables.add_int("vid_display", 0, 0, 63, "Display for the game; 0: the first one.");
  vsync = variables.add_bool("vid_vsync", defaults.vsync, "Synchronizes frames with the display.");
  pause_unfocused = variables.add_bool("vid_pauseunfocused", true,
                                       "Pauses a single-player game while another window is in use.");
  mute_unfocused =
      variables.add_bool("snd_muteunfocused", true, "Mutes all sound while another window is in use.");
  renderer =
      variables.add_choice("vid_renderer", kRenderers, "Renderer of the view: the CPU, or OpenGL (gl).");
  gl_window =
      variables.add_choice("vid_gl_window", kGlWindowUses,
                           "OpenGL draws into the window (on), or its picture is copied to the window "
                           "(off); auto: copied if the driver is software.");
  color = variables.add_choice(
      "vid_color", kColors,
      "Color mode: true color (rgb), or the 256 colors of the game's palette (indexed).");
  scale = variables.add_float(
      "vid_render_scale", 1, AutomaticScale::kMinScale, 1,
      "Resolution scale: the part of the window's width and height that is drawn, then scaled up.");
  automatic_scale = variables.add_bool("vid_render_scale_auto", false,
                                       "Dynamic resolution: lowers the resolution to hold vid_target_fps.");
  target_fps =
      variables.add_float("vid_target_fps", 60, 10, 1000, "Target frame rate of the dynamic resolution.");
  max_fps =
      variables.add_float("host_maxfps", 0, 0, 10000, "Maximum frame rate; 0: the display's refresh rate.");
  time_scale = variables.add_float("host_timescale", 0, 0, 10,
                                   "Speed of a local game or a demo: 0.5 is half speed; 0: normal. Not with "
                                   "other players.");
  gamma = variables.add_float("gamma", 1, 0.3, 2, "Gamma; below 1 brightens dark areas.");
  contrast = variables.add_float("contrast", 1, 0.5, 2, "Contrast: multiplies each color.");
  brightness =
      variables.add_float("brightness", 0, -0.5, 0.5, "Brightness, added to each color; 1 would be white.");
  fov = variables.add_float("fov", 90, 10, 170, "Horizontal field of view in degrees, for a 4:3 picture.");
  zoom_fov = variables.add_float("zoom_fov", 30, 10, 170, "Field of view while +zoom is held, in degrees.");
  zoom_speed =
      variables.add_float("zoom_speed", 8, 0.1, 1000, "Zoom speed; 1: a full zoom takes one second.");
  name = variables.add_text("name", "player", "Your name, as other players see it.");
  shirt = variables.add_int("topcolor", 0, 0, 13, "Shirt color.");
  pants = variables.add_int("bottomcolor", 0, 0, 13, "Pants color.");
  rumble =
      variables.add_float("joy_rumble", 1, 0, 1, "Strength of gamepad rumble when you are hurt; 0: off.");
  max_players =
      variables.add_int("maxplayers", 1, 1, 16, "Maximum number of players in the next game that you start.");
  port = variables.add_int("port", 26000, 0, 65535,
                           "UDP port for games that others may join; 0: any free port.");
  parallel = variables.add_bool(
      "host_parallel", true,
      "Multithreaded game logic: runs the game on another core while a frame is drawn, if there is no "
      "time to spare.");
  show_speed = variables.add_bool("scr_showfps", false, "Shows the frame rate.");
  show_latency = variables.add_bool("scr_showlatency", false, "Shows input-to-screen latency.");
  show_clock = variables.add_bool("scr_clock", false, "Shows how long the level has been running.");
  show_player_speed =
      variables.add_bool("scr_showspeed", false, "Shows your horizontal speed, in units per second.");
  show_renderer = variables.add_int("r_speeds", 0, 0, 2,
                                    "Shows what the renderer draws in a frame; 2: and how long it takes.");
  technique = variables.add_choice("r_technique", list_technique_names(),
                                   "Draws the level by another method of the laboratory.");

  start_demos = variables.add_bool("cl_startdemos", true, "Plays demos behind the menu at the start.");
  stuffed_text = variables.add_int("cl_stufftext", 1, 0, 2,
                                   "Commands that servers on other machines may run here. 0: none; 1: "
                                   "harmless ones; 2: all.");

  // Everything is saved except the server's rules, debug views, and the number of players of the next game.
  // A second table that holds only the server's variables supplies the names of the rules.
  command::Variables rules;
  const server::ServerVariables server_rules(rules);
  const std::vector<std::string> not_saved = list_names(rules);
  for (std::string& variable : list_names(variables))
    if (std::find(not_saved.begin(), not_saved.end(), variable) == not_saved.end() &&
        std::find(kDebugging.begin(), kDebugging.end(), variable) == kDebugging.end())
      saved.push_back(std::move(variable));
}

HostVariables::HostVariables(command::Variables& variables)
    : variables_(&variables), registered_(std::make_unique<const Registered>(variables)) {}

HostVariables::~HostVariables() = default;

const server::ServerVariables& HostVariables::server() const {
  return registered_->server;
}

render::Settings HostVariables::render() const {
  return registered_->render.read(*variables_);
}

client::PresentationSettings HostVariables::presentation() const {
  return registered_->client.read(*variables_);
}

client::InputSettings HostVariables::input() const {
  return registered_->input.read(*variables_);
}

client::ConsoleSettings HostVariables::console() const {
  return registered_->console.read(*variables_);
}

float HostVariables::rumble() const {
  return static_cast<float>(variables_->float_value(registered_->rumble));
}

std::uint32_t HostVariables::max_players() const {
  return static_cast<std::uint32_t>(variables_->int_value(registered_->max_players));
}

std::uint16_t HostVariables::port() const {
  return static_cast<std::uint16_t>(variables_->int_value(registered_->port));
}

bool HostVariables::is_parallel() const {
  return variables_->bool_value(registered_->parallel);
}

bool HostVariables::plays_start_demos() const {
  return variables_->bool_value(registered_->start_demos);
}

bool HostVariables::pauses_unfocused() const {
  return variables_->bool_value(registered_->pause_unfocused);
}

bool HostVariables::mutes_unfocused() const {
  return variables_->bool_value(registered_->mute_unfocused);
}

double HostVariables::time_scale() const {
  const double scale = variables_->float_value(registered_->time_scale);
  return scale > 0 ? scale : 1;
}

ReadoutSettings HostVariables::readouts() const {
  return {.frame_rate = variables_->bool_value(registered_->show_speed),
          .latency = variables_->bool_value(registered_->show_latency),
          .clock = variables_->bool_value(registered_->show_clock),
          .player_speed = variables_->bool_value(registered_->show_player_speed),
          .renderer = static_cast<int>(variables_->int_value(registered_->show_renderer)),
          .technique = technique()};
}

bool HostVariables::uses_gl() const {
  return variables_->choice_value(registered_->renderer) == 1;
}

GlWindowUse HostVariables::gl_window() const {
  return static_cast<GlWindowUse>(variables_->choice_value(registered_->gl_window));
}

std::size_t HostVariables::technique() const {
  return variables_->choice_value(registered_->technique);
}

StuffedTextRule HostVariables::stuffed_text() const {
  return static_cast<StuffedTextRule>(variables_->int_value(registered_->stuffed_text));
}

platform::WindowSettings HostVariables::window() const {
  return {.size = {static_cast<int>(variables_->int_value(registered_->width)),
                   static_cast<int>(variables_->int_value(registered_->height))},
          .mode = static_cast<platform::WindowMode>(variables_->choice_value(registered_->mode)),
          .display = static_cast<int>(variables_->int_value(registered_->display)),
          .vsync = variables_->bool_value(registered_->vsync)};
}

ScreenSettings HostVariables::screen() const {
  const auto number = [&](command::VariableIndex index) {
    return static_cast<float>(variables_->float_value(index));
  };
  return {
      .format = variables_->choice_value(registered_->color) == 0 ? render::PixelFormat::kRgb
                                                                  : render::PixelFormat::kIndexed,
      .scale = number(registered_->scale),
      .automatic_scale = variables_->bool_value(registered_->automatic_scale),
      .target_s = 1 / variables_->float_value(registered_->target_fps),
      .tone = {number(registered_->gamma), number(registered_->contrast), number(registered_->brightness)}};
}

ZoomSettings HostVariables::zoom() const {
  const auto number = [&](command::VariableIndex index) {
    return static_cast<float>(variables_->float_value(index));
  };
  return {number(registered_->fov), number(registered_->zoom_fov), number(registered_->zoom_speed)};
}

client::PlayerSettings HostVariables::player() const {
  return {.name = variables_->text_value(registered_->name),
          .shirt = static_cast<std::uint8_t>(variables_->int_value(registered_->shirt)),
          .pants = static_cast<std::uint8_t>(variables_->int_value(registered_->pants))};
}

double HostVariables::frames_per_second() const {
  return variables_->float_value(registered_->max_fps);
}

void HostVariables::reset() const {
  for (const std::string& name : list_names(*variables_)) {
    const base::Status set = variables_->restore(name);
    CHECK(set.ok(), "a default value is valid");
  }
}

void HostVariables::adopt_game_defaults() const {
  for (const std::string& name : registered_->saved) {
    const base::Status adopted = variables_->adopt_as_default(name);
    CHECK(adopted.ok(), "{} is registered", name);
  }
}

std::string HostVariables::to_text(const command::Variables& own_values, const Overrides& overrides) const {
  std::string text;
  for (const std::string& name : registered_->saved) {
    const command::Variable& variable = *own_values.find(name);
    const std::string& value = overrides.own_text(variable);
    if (value != variable.default_text)
      text += fmt::format("{}\n", command::join_words({variable.name, value}));
  }
  for (const command::Variable* variable : own_values.all())
    if (variable->is_kept && variable->text != variable->default_text)
      text += fmt::format("{}\n", command::join_words({"seta", variable->name, variable->text}));
  return text;
}

}  // namespace temblor::host
