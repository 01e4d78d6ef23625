#include "client/menu/pages/option_tables.h"

namespace temblor::client {

std::span<const OptionLook> picture_options() {
  static constexpr OptionLook kLooks[] = {
      {.variable = "vid_vsync", .label = "Vertical sync"},
      {.variable = "host_maxfps", .label = "Frame limit", .high = 250, .step = 10, .zero = "none"},
      {.variable = "vid_render_scale_auto", .label = "Automatic scale"},
      {.variable = "vid_target_fps",
       .label = "Scale aims at",
       .low = 30,
       .high = 144,
       .step = 6,
       .unit = "fps"},
      {.variable = "vid_render_scale",
       .label = "Render scale",
       .low = 0.5,
       .high = 1,
       .step = 0.05,
       .shown_factor = 100,
       .unit = "%"},
      {.variable = "vid_color", .label = "Colors"},
      {.variable = "gamma", .label = "Gamma", .low = 0.5, .high = 2, .step = 0.05},
      {.variable = "contrast", .label = "Contrast", .low = 0.5, .high = 2, .step = 0.05},
      {.variable = "brightness", .label = "Brightness", .low = -0.5, .high = 0.5, .step = 0.05},
      {.variable = "fov", .label = "Field of view", .low = 60, .high = 130, .step = 5},
      {.variable = "scr_showfps", .label = "Show frame rate"},
      {.variable = "scr_showlatency", .label = "Show latency"},
      {.variable = "host_parallel", .label = "Two cores"},
  };
  return kLooks;
}

std::span<const OptionLook> screen_options() {
  static constexpr std::string_view kCrosshairs[] = {"off", "cross", "dot", "lines"};
  static constexpr OptionLook kLooks[] = {
      {.variable = "viewsize", .label = "View size", .low = 100, .high = 120, .step = 10},
      {.variable = "scr_scale", .label = "Status bar size", .high = 8, .step = 1, .zero = "auto"},
      {.variable = "scr_sbaralpha", .label = "Bar opacity", .shown_factor = 100, .unit = "%"},
      {.variable = "crosshair", .label = "Crosshair", .names = kCrosshairs},
      {.variable = "r_drawviewmodel", .label = "Weapon in hand"},
      {.variable = "cl_nolerp", .label = "Jerky movement"},
      {.variable = "r_marks", .label = "Marks of shots"},
      {.variable = "r_particles_max", .label = "Particles", .high = 32768, .step = 2048, .zero = "none"},
      {.variable = "r_fog", .label = "Fog"},
      {.variable = "r_skybox", .label = "Sky boxes"},
      {.variable = "r_wateralpha", .label = "Water opacity", .shown_factor = 100, .unit = "%"},
      {.variable = "r_slimealpha", .label = "Slime opacity", .shown_factor = 100, .unit = "%"},
      {.variable = "r_lavaalpha", .label = "Lava opacity", .shown_factor = 100, .unit = "%"},
      {.variable = "r_telealpha", .label = "Teleport opacity", .shown_factor = 100, .unit = "%"},
      {.variable = "r_colored_light", .label = "Colored light"},
      {.variable = "r_mip_rule", .label = "Texture detail"},
      {.variable = "r_perspective", .label = "Perspective"},
      {.variable = "r_alias_snap", .label = "Models as stock"},
  };
  return kLooks;
}

std::span<const OptionLook> sound_options() {
  static constexpr OptionLook kLooks[] = {
      {.variable = "volume", .label = "Sounds", .high = 1, .step = 0.05, .shown_factor = 100, .unit = "%"},
      {.variable = "bgmvolume", .label = "Music", .high = 1, .step = 0.05, .shown_factor = 100, .unit = "%"},
      {.variable = "ambient_level",
       .label = "Surroundings",
       .high = 1,
       .step = 0.05,
       .shown_factor = 100,
       .unit = "%"},
      {.variable = "s_underwater",
       .label = "Muffled in water",
       .high = 1,
       .step = 0.1,
       .shown_factor = 100,
       .unit = "%"},
  };
  return kLooks;
}

std::span<const OptionLook> control_options() {
  static constexpr OptionLook kLooks[] = {
      {.variable = "sensitivity", .label = "Mouse speed", .low = 0.5, .high = 15, .step = 0.5},
      {.variable = "m_invert", .label = "Invert mouse"},
      {.variable = "freelook", .label = "Mouse looks"},
      {.variable = "lookspring", .label = "Look spring"},
      {.variable = "lookstrafe", .label = "Look strafe"},
      {.variable = "cl_alwaysrun", .label = "Always run"},
      {.variable = "zoom_fov", .label = "Zoom", .low = 10, .high = 80, .step = 5},
      {.variable = "joy_enable", .label = "Gamepad"},
      {.variable = "joy_sensitivity_yaw", .label = "Stick turns", .low = 60, .high = 500, .step = 20},
      {.variable = "joy_sensitivity_pitch", .label = "Stick looks", .low = 30, .high = 400, .step = 10},
      {.variable = "joy_deadzone_look",
       .label = "Looking dead zone",
       .high = 0.5,
       .step = 0.025,
       .shown_factor = 100,
       .unit = "%"},
      {.variable = "joy_deadzone_move",
       .label = "Walking dead zone",
       .high = 0.5,
       .step = 0.025,
       .shown_factor = 100,
       .unit = "%"},
      {.variable = "joy_exponent", .label = "Looking curve", .low = 1, .high = 4, .step = 0.25},
      {.variable = "joy_exponent_move", .label = "Walking curve", .low = 1, .high = 4, .step = 0.25},
      {.variable = "joy_invert", .label = "Invert stick"},
      {.variable = "joy_swapmovelook", .label = "Swap sticks"},
      {.variable = "joy_rumble", .label = "Rumble", .high = 1, .step = 0.1, .shown_factor = 100, .unit = "%"},
  };
  return kLooks;
}

std::span<const OptionLook> accessibility_options() {
  static constexpr OptionLook kLooks[] = {
      {.variable = "scr_textsize",
       .label = "Text size",
       .low = 0.5,
       .high = 4,
       .step = 0.1,
       .shown_factor = 100,
       .unit = "%"},
      {.variable = "v_tint_damage", .label = "Flash of damage", .shown_factor = 100, .unit = "%"},
      {.variable = "v_tint_bonus", .label = "Flash of pick-ups", .shown_factor = 100, .unit = "%"},
      {.variable = "v_tint_powerup", .label = "Power-up colors", .shown_factor = 100, .unit = "%"},
      {.variable = "v_tint_liquid", .label = "Liquid colors", .shown_factor = 100, .unit = "%"},
      {.variable = "v_kick", .label = "View kick", .high = 2, .step = 0.1, .shown_factor = 100, .unit = "%"},
      {.variable = "v_bob", .label = "View bob", .high = 2, .step = 0.1, .shown_factor = 100, .unit = "%"},
      {.variable = "v_roll", .label = "View roll", .high = 2, .step = 0.1, .shown_factor = 100, .unit = "%"},
      {.variable = "con_highcontrast", .label = "High contrast"},
      {.variable = "scr_subtitles", .label = "Sound subtitles"},
      {.variable = "scr_safecolors", .label = "Safe colors"},
  };
  return kLooks;
}

std::span<const BoundAction> bound_actions() {
  static constexpr BoundAction kActions[] = {
      {"Moving", ""},
      {"Forward", "+forward"},
      {"Back", "+back"},
      {"Step left", "+moveleft"},
      {"Step right", "+moveright"},
      {"Jump, swim up", "+jump"},
      {"Swim up", "+moveup"},
      {"Swim down", "+movedown"},
      {"Run", "+speed"},
      {"Turn left", "+left"},
      {"Turn right", "+right"},
      {"Sidestep", "+strafe"},
      {"Looking", ""},
      {"Look up", "+lookup"},
      {"Look down", "+lookdown"},
      {"Look ahead", "centerview"},
      {"Mouse look", "+mlook"},
      {"Keyboard look", "+klook"},
      {"Zoom", "+zoom"},
      {"Weapons", ""},
      {"Attack", "+attack"},
      {"Next weapon", "impulse 10"},
      {"Previous weapon", "impulse 12"},
      {"Axe", "impulse 1"},
      {"Shotgun", "impulse 2"},
      {"Double shotgun", "impulse 3"},
      {"Nailgun", "impulse 4"},
      {"Super nailgun", "impulse 5"},
      {"Grenades", "impulse 6"},
      {"Rockets", "impulse 7"},
      {"Lightning", "impulse 8"},
      {"The rest", ""},
      {"Scores", "+showscores"},
      {"Say", "messagemode"},
      {"Say to team", "messagemode2"},
      {"Menu", "togglemenu"},
      {"Console", "toggleconsole"},
      {"Pause", "pause"},
      {"Quick save", "save quick"},
      {"Quick load", "load quick"},
      {"Save", "menu_save"},
      {"Load", "menu_load"},
      {"Screenshot", "screenshot"},
      {"Larger view", "sizeup"},
      {"Smaller view", "sizedown"},
      {"Help", "help_menu"},
      {"Quit", "quit"},
  };
  return kActions;
}

}  // namespace temblor::client
