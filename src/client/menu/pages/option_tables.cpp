// Labels have at most 19 characters: the width of the left column in the smallest frame that shows labels
// whole, 320 pixels. Ranges are narrower than those of the variables where extreme values are of no use; the
// console still takes them.
#include "client/menu/pages/option_tables.h"

namespace temblor::client {

std::span<const OptionLook> picture_options() {
  static constexpr std::string_view kFilters[] = {"nearest", "bilinear", "trilinear", "anisotropic"};
  static constexpr std::string_view kRenderers[] = {"CPU", "OpenGL"};
  static constexpr std::string_view kColorModes[] = {"true color", "256 colors"};
  static constexpr OptionLook kLooks[] = {
      {.variable = "vid_vsync", .label = "Vertical sync"},
      {.variable = "vid_pauseunfocused", .label = "Pause in background"},
      {.variable = "host_maxfps", .label = "Frame rate limit", .high = 250, .step = 10, .zero = "none"},
      {.variable = "vid_render_scale_auto", .label = "Dynamic resolution"},
      {.variable = "vid_target_fps",
       .label = "Target frame rate",
       .low = 30,
       .high = 144,
       .step = 6,
       .unit = " fps"},
      {.variable = "vid_render_scale",
       .label = "Resolution scale",
       .low = 0.5,
       .high = 1,
       .step = 0.05,
       .shown_factor = 100,
       .unit = "%"},
      {.variable = "vid_renderer", .label = "Renderer", .names = kRenderers},
      {.variable = "r_filter", .label = "Texture filter", .names = kFilters},
      {.variable = "r_filter_sharp", .label = "Sharp texels"},
      {.variable = "vid_color", .label = "Color mode", .names = kColorModes},
      {.variable = "gamma", .label = "Gamma", .low = 0.5, .high = 2, .step = 0.05},
      {.variable = "contrast", .label = "Contrast", .low = 0.5, .high = 2, .step = 0.05},
      {.variable = "brightness", .label = "Brightness", .low = -0.5, .high = 0.5, .step = 0.05},
      {.variable = "fov", .label = "Field of view", .low = 60, .high = 130, .step = 5},
      {.variable = "scr_showfps", .label = "Show frame rate"},
      {.variable = "scr_showlatency", .label = "Show latency"},
      {.variable = "host_parallel", .label = "Multithreaded logic"},
  };
  return kLooks;
}

std::span<const OptionLook> screen_options() {
  static constexpr std::string_view kCrosshairs[] = {"off", "cross", "dot", "lines"};
  static constexpr std::string_view kLayouts[] = {"status bar", "corners", "minimal"};
  static constexpr std::string_view kMipRules[] = {"smooth", "classic"};
  static constexpr std::string_view kPerspectives[] = {"exact", "classic"};
  static constexpr OptionLook kLooks[] = {
      {.variable = "viewsize", .label = "View size", .low = 100, .high = 120, .step = 10},
      {.variable = "scr_hudstyle", .label = "HUD layout", .names = kLayouts},
      {.variable = "scr_scale", .label = "Status bar size", .high = 8, .step = 1, .zero = "auto"},
      {.variable = "scr_sbaralpha", .label = "Status bar opacity", .shown_factor = 100, .unit = "%"},
      {.variable = "scr_pickups", .label = "List of pickups"},
      {.variable = "scr_weaponlist", .label = "List of weapons"},
      {.variable = "scr_poweruptimers", .label = "Power-up timers"},
      {.variable = "scr_damagedirection", .label = "Damage direction"},
      {.variable = "crosshair", .label = "Crosshair", .names = kCrosshairs},
      {.variable = "r_drawviewmodel", .label = "Show weapon"},
      {.variable = "cl_nolerp", .label = "Classic animation"},
      {.variable = "r_marks", .label = "Bullet holes, blood"},
      {.variable = "r_dynamic_colors", .label = "Colored flashes"},
      {.variable = "r_caustics", .label = "Light under water"},
      {.variable = "r_particles_max", .label = "Particles", .high = 32768, .step = 2048, .zero = "none"},
      {.variable = "r_fog", .label = "Fog"},
      {.variable = "r_skybox", .label = "Skyboxes"},
      {.variable = "r_wateralpha", .label = "Water opacity", .shown_factor = 100, .unit = "%"},
      {.variable = "r_slimealpha", .label = "Slime opacity", .shown_factor = 100, .unit = "%"},
      {.variable = "r_lavaalpha", .label = "Lava opacity", .shown_factor = 100, .unit = "%"},
      {.variable = "r_telealpha", .label = "Teleporter opacity", .shown_factor = 100, .unit = "%"},
      {.variable = "r_colored_light", .label = "Colored light"},
      {.variable = "r_mip_rule", .label = "Mipmapping", .names = kMipRules},
      {.variable = "r_perspective", .label = "Texture perspective", .names = kPerspectives},
      {.variable = "r_alias_snap", .label = "Classic models"},
  };
  return kLooks;
}

std::span<const OptionLook> sound_options() {
  static constexpr OptionLook kLooks[] = {
      {.variable = "volume",
       .label = "Effects volume",
       .high = 1,
       .step = 0.05,
       .shown_factor = 100,
       .unit = "%"},
      {.variable = "bgmvolume",
       .label = "Music volume",
       .high = 1,
       .step = 0.05,
       .shown_factor = 100,
       .unit = "%"},
      {.variable = "bgm_layers", .label = "Combat music"},
      {.variable = "ambient_level",
       .label = "Ambient sounds",
       .high = 1,
       .step = 0.05,
       .shown_factor = 100,
       .unit = "%"},
      {.variable = "s_underwater",
       .label = "Underwater muffling",
       .high = 1,
       .step = 0.1,
       .shown_factor = 100,
       .unit = "%"},
      {.variable = "snd_focus", .label = "Focus on nearest"},
      {.variable = "snd_muteunfocused", .label = "Mute in background"},
  };
  return kLooks;
}

std::span<const OptionLook> control_options() {
  static constexpr OptionLook kLooks[] = {
      {.variable = "sensitivity", .label = "Mouse sensitivity", .low = 0.5, .high = 15, .step = 0.5},
      {.variable = "m_invert", .label = "Invert mouse"},
      {.variable = "freelook", .label = "Mouse look"},
      {.variable = "lookspring", .label = "Look spring"},
      {.variable = "lookstrafe", .label = "Look strafe"},
      {.variable = "cl_alwaysrun", .label = "Always run"},
      {.variable = "zoom_fov", .label = "Zoom field of view", .low = 10, .high = 80, .step = 5},
      {.variable = "joy_enable", .label = "Gamepad"},
      {.variable = "joy_sensitivity_yaw", .label = "Look sensitivity X", .low = 60, .high = 500, .step = 20},
      {.variable = "joy_sensitivity_pitch",
       .label = "Look sensitivity Y",
       .low = 30,
       .high = 400,
       .step = 10},
      {.variable = "joy_deadzone_look",
       .label = "Look dead zone",
       .high = 0.5,
       .step = 0.025,
       .shown_factor = 100,
       .unit = "%"},
      {.variable = "joy_deadzone_move",
       .label = "Move dead zone",
       .high = 0.5,
       .step = 0.025,
       .shown_factor = 100,
       .unit = "%"},
      {.variable = "joy_exponent", .label = "Look curve", .low = 1, .high = 4, .step = 0.25},
      {.variable = "joy_exponent_move", .label = "Move curve", .low = 1, .high = 4, .step = 0.25},
      {.variable = "joy_invert", .label = "Invert look stick"},
      {.variable = "joy_swapmovelook", .label = "Swap sticks"},
      {.variable = "joy_rumble", .label = "Rumble", .high = 1, .step = 0.1, .shown_factor = 100, .unit = "%"},
  };
  return kLooks;
}

std::span<const OptionLook> accessibility_options() {
  static constexpr std::string_view kLightStyles[] = {"flicker", "steady", "steady, bright"};
  static constexpr OptionLook kLooks[] = {
      {.variable = "scr_textsize",
       .label = "Text size",
       .low = 0.5,
       .high = 4,
       .step = 0.1,
       .shown_factor = 100,
       .unit = "%"},
      {.variable = "v_tint_damage", .label = "Damage flash", .shown_factor = 100, .unit = "%"},
      {.variable = "v_tint_bonus", .label = "Pickup flash", .shown_factor = 100, .unit = "%"},
      {.variable = "v_tint_powerup", .label = "Power-up tint", .shown_factor = 100, .unit = "%"},
      {.variable = "v_tint_liquid", .label = "Liquid tint", .shown_factor = 100, .unit = "%"},
      {.variable = "r_flatlightstyles", .label = "Lights", .names = kLightStyles},
      {.variable = "cl_noflash", .label = "No muzzle flashes"},
      {.variable = "v_kick", .label = "View kick", .high = 2, .step = 0.1, .shown_factor = 100, .unit = "%"},
      {.variable = "v_shake",
       .label = "Screen shake",
       .high = 2,
       .step = 0.1,
       .shown_factor = 100,
       .unit = "%"},
      {.variable = "v_bob", .label = "View bob", .high = 2, .step = 0.1, .shown_factor = 100, .unit = "%"},
      {.variable = "v_roll", .label = "View roll", .high = 2, .step = 0.1, .shown_factor = 100, .unit = "%"},
      {.variable = "con_highcontrast", .label = "High contrast"},
      {.variable = "scr_subtitles", .label = "Sound captions"},
      {.variable = "scr_safecolors", .label = "Colorblind markers"},
  };
  return kLooks;
}

std::span<const BoundAction> bound_actions() {
  static constexpr BoundAction kActions[] = {
      {"Movement", ""},
      {"Move forward", "+forward"},
      {"Move back", "+back"},
      {"Strafe left", "+moveleft"},
      {"Strafe right", "+moveright"},
      {"Jump or swim up", "+jump"},
      {"Swim up", "+moveup"},
      {"Swim down", "+movedown"},
      {"Run", "+speed"},
      {"Turn left", "+left"},
      {"Turn right", "+right"},
      {"Strafe modifier", "+strafe"},
      {"View", ""},
      {"Look up", "+lookup"},
      {"Look down", "+lookdown"},
      {"Center view", "centerview"},
      {"Mouse look", "+mlook"},
      {"Keyboard look", "+klook"},
      {"Zoom", "+zoom"},
      {"Weapons", ""},
      {"Attack", "+attack"},
      {"Next weapon", "impulse 10"},
      {"Previous weapon", "impulse 12"},
      {"Pickaxe", "impulse 1"},
      {"Shotgun", "impulse 2"},
      {"Double-barreled shotgun", "impulse 3"},
      {"Nailgun", "impulse 4"},
      {"Super nailgun", "impulse 5"},
      {"Grenade launcher", "impulse 6"},
      {"Rocket launcher", "impulse 7"},
      {"Thunderbolt", "impulse 8"},
      {kTremorLabel, "impulse 13"},
      {"Other", ""},
      {"Show scores", "+showscores"},
      {"Chat", "messagemode"},
      {"Team chat", "messagemode2"},
      {"Menu", "togglemenu"},
      {"Console", "toggleconsole"},
      {"Pause", "pause"},
      {"Quicksave", "save quick"},
      {"Quickload", "load quick"},
      {"Save game", "menu_save"},
      {"Load game", "menu_load"},
      {"Screenshot", "screenshot"},
      {"Larger view", "sizeup"},
      {"Smaller view", "sizedown"},
      {"Help", "help_menu"},
      {"Quit", "quit"},
  };
  return kActions;
}

}  // namespace temblor::client
