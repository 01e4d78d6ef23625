#include "host/host_variables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "command/text.h"

namespace temblor::host {
namespace {

// In the order of platform::WindowMode, and of true color before the palette; the first is the default.
constexpr std::array<std::string_view, 3> kModes = {"window", "borderless", "fullscreen"};
constexpr std::array<std::string_view, 2> kColors = {"rgb", "indexed"};

std::vector<std::string> names_of(const command::Variables& variables) {
  std::vector<std::string> names;
  for (const command::Variable* variable : variables.all()) names.push_back(variable->name);
  return names;
}

}  // namespace

HostVariables::HostVariables(command::Variables& variables)
    : variables_(&variables),
      render_(variables),
      client_(variables),
      input_(variables),
      console_(variables),
      server_(variables) {
  const platform::WindowSettings window;
  width_ = variables.add_int("vid_width", window.size.width, 1, 16384, "Width of the window, pixels.");
  height_ = variables.add_int("vid_height", window.size.height, 1, 16384, "Height of the window, pixels.");
  mode_ = variables.add_choice("vid_mode", kModes,
                               "A window, all of the desktop, or a mode of the display's own.");
  display_ = variables.add_int("vid_display", 0, 0, 63, "Which display, counted from 0.");
  vsync_ = variables.add_bool("vid_vsync", window.vsync, "Waits for the display, where that is offered.");
  color_ =
      variables.add_choice("vid_color", kColors, "True color, or the 256 colors of the original's palette.");
  scale_ = variables.add_float("vid_render_scale", 1, AutomaticScale::kSmallest, 1,
                               "Part of the window's width and height that is drawn, and scaled up.");
  automatic_scale_ = variables.add_bool("vid_render_scale_auto", false,
                                        "Draws less where vid_target_fps would not be held.");
  target_fps_ = variables.add_float("vid_target_fps", 60, 10, 1000,
                                    "Frames a second that the automatic render scale is to hold.");
  max_fps_ = variables.add_float("host_maxfps", 0, 0, 10000,
                                 "Frames a second at most; 0: as many as the display shows.");
  gamma_ = variables.add_float("gamma", 1, 0.3, 2, "Below 1 dark places are brighter.");
  contrast_ = variables.add_float("contrast", 1, 0.5, 2, "Factor of all brightness.");
  brightness_ = variables.add_float("brightness", 0, -0.5, 0.5, "Added to all brightness; 1 would be white.");
  fov_ = variables.add_float("fov", 90, 10, 170, "Field of view, degrees across a picture of 4:3.");
  zoom_fov_ = variables.add_float("zoom_fov", 30, 10, 170, "Field of view while +zoom is held.");
  zoom_speed_ = variables.add_float("zoom_speed", 8, 0.1, 1000, "How fast the view narrows.");
  name_ = variables.add_text("name", "player", "What other players see.");
  shirt_ = variables.add_int("topcolor", 0, 0, 13, "Color of the shirt.");
  pants_ = variables.add_int("bottomcolor", 0, 0, 13, "Color of the trousers.");
  rumble_ =
      variables.add_float("joy_rumble", 1, 0, 1, "How strongly the gamepad shakes when the player is hurt.");
  max_players_ = variables.add_int("maxplayers", 1, 1, 16, "Players in the next game that begins here.");
  port_ = variables.add_int("port", 26000, 0, 65535, "UDP port of games that others may join; 0: any.");
  parallel_ = variables.add_bool(
      "host_parallel", true,
      "The game goes on beside the drawing of the picture, on another core, where frames leave "
      "no time to wait.");
  show_speed_ = variables.add_bool("scr_showfps", false, "Shows frames a second.");
  show_latency_ =
      variables.add_bool("scr_showlatency", false, "Shows how long input takes to the presented frame.");

  command::Variables rules;
  const server::ServerVariables of_servers(rules);
  const std::vector<std::string> not_kept = names_of(rules);
  for (std::string& name : names_of(variables))
    if (std::find(not_kept.begin(), not_kept.end(), name) == not_kept.end() && name != "r_show" &&
        name != "maxplayers")
      kept_.push_back(std::move(name));
}

platform::WindowSettings HostVariables::window() const {
  return {.size = {static_cast<int>(variables_->int_value(width_)),
                   static_cast<int>(variables_->int_value(height_))},
          .mode = static_cast<platform::WindowMode>(variables_->choice_value(mode_)),
          .display = static_cast<int>(variables_->int_value(display_)),
          .vsync = variables_->bool_value(vsync_)};
}

ScreenSettings HostVariables::screen() const {
  const auto number = [&](command::VariableIndex index) {
    return static_cast<float>(variables_->float_value(index));
  };
  return {.format = variables_->choice_value(color_) == 0 ? render::PixelFormat::kRgb
                                                          : render::PixelFormat::kIndexed,
          .scale = number(scale_),
          .automatic_scale = variables_->bool_value(automatic_scale_),
          .target_s = 1 / variables_->float_value(target_fps_),
          .tone = {number(gamma_), number(contrast_), number(brightness_)}};
}

ZoomSettings HostVariables::zoom() const {
  const auto number = [&](command::VariableIndex index) {
    return static_cast<float>(variables_->float_value(index));
  };
  return {number(fov_), number(zoom_fov_), number(zoom_speed_)};
}

client::PlayerSettings HostVariables::player() const {
  return {.name = variables_->text_value(name_),
          .shirt = static_cast<std::uint8_t>(variables_->int_value(shirt_)),
          .pants = static_cast<std::uint8_t>(variables_->int_value(pants_))};
}

double HostVariables::frames_per_second() const {
  return variables_->float_value(max_fps_);
}

void HostVariables::reset() const {
  for (const std::string& name : names_of(*variables_)) {
    const base::Status set = variables_->reset(name);
    CHECK(set.ok(), "a default fits");
  }
}

std::string HostVariables::to_text(const Overrides& overrides) const {
  std::string text;
  for (const std::string& name : kept_) {
    const command::Variable& variable = *variables_->find(name);
    const std::string& own = overrides.own_text(variable);
    if (own != variable.default_text) text += fmt::format("{}\n", command::join_words({variable.name, own}));
  }
  return text;
}

}  // namespace temblor::host
