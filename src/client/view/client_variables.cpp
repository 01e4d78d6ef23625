#include "client/view/client_variables.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

namespace temblor::client {
namespace {

// From these values of `viewsize` on, parts of the status bar are hidden, as in the original. Unlike there,
// smaller values do not shrink the view.
constexpr std::int64_t kSmallBarViewSize = 110, kNoBarViewSize = 120;

StatusBar to_status_bar(std::int64_t view_size) {
  if (view_size >= kNoBarViewSize) return StatusBar::kNone;
  return view_size >= kSmallBarViewSize ? StatusBar::kSmall : StatusBar::kFull;
}

// The original lifts the weapon by up to 2 units, so that the status bar does not cover it.
float choose_weapon_rise(const HudSettings& hud) {
  const StatusBar bar = hud.status_bar;
  if (bar == StatusBar::kNone || hud.layout != HudLayout::kClassic) return 0;
  return bar == StatusBar::kSmall ? 1 : 2;
}

// Drops empty parts.
std::vector<std::string> split_at_commas(std::string_view text) {
  std::vector<std::string> parts;
  while (!text.empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    if (comma > 0) parts.emplace_back(text.substr(0, comma));
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return parts;
}

}  // namespace

ClientVariables::ClientVariables(command::Variables& variables) : choices_(variables) {
  const PresentationSettings defaults;
  // A factor of 0 turns an effect off; a `max` above 1 allows more than the original's strength.
  const auto factor = [&](const char* name, float value, double max, const char* help) {
    return variables.add_float(name, static_cast<double>(value), 0, max, help);
  };
  no_lerp_ = variables.add_bool("cl_nolerp", !defaults.interpolate,
                                "Classic animation: entities jump with each server update. 0: smooth "
                                "movement.");
  predict_ = variables.add_bool("cl_predict", defaults.predict,
                                "Shows your own movement at once, without waiting for the server.");
  no_lerp_models_ =
      variables.add_text("r_nolerp_list", fmt::format("{}", fmt::join(defaults.no_lerp_models, ",")),
                         "Models whose animation is never smoothed, separated by commas.");
  max_particles_ =
      variables.add_int("r_particles_max", static_cast<std::int64_t>(defaults.effects.max_particles), 0,
                        1 << 20, "Maximum number of particles.");
  marks_ = variables.add_bool("r_marks", defaults.effects.marks,
                              "Shots leave bullet holes, scorches and blood on walls, doors and lifts.");
  bob_ = factor("v_bob", defaults.view.bob, 4, "View bob while walking. 1: original strength.");
  bob_cycle_ = variables.add_float("cl_bobcycle", defaults.view.bob_cycle_s, 0, 10,
                                   "Seconds for which a view bob lasts. 0: no bob.");
  bob_up_ = variables.add_float("cl_bobup", defaults.view.bob_up, 0, 1, "Share of a view bob that rises.");
  roll_ = factor("v_roll", defaults.view.roll, 4, "How far the view leans when strafing.");
  kick_ = factor("v_kick", defaults.view.kick, 4, "How hard damage shakes the view.");
  shake_ = factor("v_shake", defaults.view.shake, 4, "How hard recoil and explosions shake the view.");
  kick_time_ = variables.add_float("v_kicktime", static_cast<double>(defaults.view.kick_s), 0, 10,
                                   "How long damage shakes the view, in seconds. 0: not at all.");
  idle_sway_ = factor("v_idlescale", defaults.view.idle_sway, 100,
                      "How far the view sways all the time. 0: not at all.");
  damage_tint_ =
      factor("v_tint_damage", defaults.view.damage_tint, 1, "Strength of the flash when you take damage.");
  bonus_tint_ = factor("v_tint_bonus", defaults.view.bonus_tint, 1,
                       "Strength of the flash when you pick something up.");
  powerup_tint_ =
      factor("v_tint_powerup", defaults.view.powerup_tint, 1, "Strength of the tint of power-ups.");
  contents_tint_ =
      factor("v_tint_liquid", defaults.view.contents_tint, 1, "Strength of the tint in liquids.");
  natural_liquids_ = variables.add_bool("v_liquid_colors", defaults.view.natural_liquids,
                                        "Water tints the view blue and slime green. 0: as the original.");
  view_size_ = variables.add_int("viewsize", 100, 30, kNoBarViewSize,
                                 "110 hides the inventory row, 120 the whole status bar.");
  hud_layout_ = variables.add_int("scr_hudstyle", 0, 0, 2,
                                  "Layout of the HUD. 0: status bar, 1: in the corners, 2: health and ammo "
                                  "only.");
  pickups_ =
      variables.add_bool("scr_pickups", defaults.hud.notices.pickups, "Lists what you pick up, on the left.");
  weapon_list_ = variables.add_bool("scr_weaponlist", defaults.hud.notices.weapons,
                                    "Shows all weapons and their ammo for a second when you change weapons.");
  power_timers_ = variables.add_bool("scr_poweruptimers", defaults.hud.notices.power_timers,
                                     "Shows power-ups with the seconds that are left, on the right.");
  damage_arcs_ = variables.add_bool("scr_damagedirection", defaults.hud.notices.damage,
                                    "Arcs around the crosshair show where damage comes from.");
  hud_scale_ = variables.add_int("scr_scale", defaults.hud.size.scale, 0, 64,
                                 "Status bar size. 0 picks a size that fits the window.");
  hud_opacity_ = factor("scr_sbaralpha", defaults.hud.opacity, 1, "Opacity of the status bar's background.");
  crosshair_ = variables.add_int("crosshair", 0, 0, 3, "Crosshair. 0: off, 1: cross, 2: dot, 3: lines.");
  crosshair_color_ = variables.add_int("crosshair_color", defaults.hud.crosshair.color, 0, 255,
                                       "Palette color of the crosshair's dot or lines.");
  crosshair_scale_ = variables.add_float("scr_crosshairscale", defaults.hud.crosshair.scale, 0.25, 16,
                                         "Size of the crosshair's dot or lines. 1: normal size.");
  center_time_ = variables.add_float("scr_centertime", defaults.hud.center_text_s, 0, 60,
                                     "How long messages stay in the middle of the screen, in seconds.");
  print_speed_ = variables.add_float("scr_printspeed", defaults.hud.letters_per_second, 1, 1000,
                                     "How fast the text at the end of an episode appears, in letters per "
                                     "second.");
  colored_lights_ = variables.add_bool("r_dynamic_colors", defaults.effects.colored_lights,
                                       "Explosions and lightning light the level in their colors.");
  no_flash_ =
      variables.add_bool("cl_noflash", !defaults.effects.muzzle_flashes, "Shots do not light up the level.");
  casings_ = variables.add_bool("cl_casings", defaults.effects.casings,
                                "Guns throw out empty casings, in games with models of them.");
  smoke_ = variables.add_bool("cl_smoke", defaults.effects.smoke,
                              "Barrels and explosions smoke, in games with pictures of smoke.");
  impacts_ = variables.add_bool("cl_impacts", defaults.effects.impacts,
                                "Shots strike sparks from metal, dust from stone, and splinters from wood.");
  splashes_ = variables.add_bool("cl_splashes", defaults.effects.splashes,
                                 "Liquids splash, with rings and bubbles in games with pictures of them.");
  barrel_beams_ = variables.add_bool("cl_barrelbeam", defaults.effects.barrel_beams,
                                     "Your lightning starts at the barrel in your hand.");
  safe_colors_ = variables.add_bool("scr_safecolors", defaults.hud.safe_colors,
                                    "Marks low numbers, armor types and keys with symbols as well as "
                                    "colors.");
  variables.add_alias("crosshair_colour", "crosshair_color");  // old spelling
  variables.add_alias("scr_safecolours", "scr_safecolors");    // old spelling
  no_hud_program_ =
      variables.add_bool("cl_nocsqc", !defaults.runs_hud_program,
                         "Draws the built-in HUD even if the game brings its own (csprogs.dat).");
  show_weapon_ = variables.add_bool("r_drawviewmodel", defaults.show_weapon, "Shows your weapon.");
  weapon_fov_ = variables.add_float("r_viewmodel_fov", static_cast<double>(defaults.weapon_fov_deg), 0, 170,
                                    "Field of view of your weapon. 90: it looks the same with any fov; 0: "
                                    "that of the view.");
  water_alpha_ = factor("r_wateralpha", defaults.environment.liquid_alpha.water, 1,
                        "Opacity of water, unless the level sets it.");
  slime_alpha_ = factor("r_slimealpha", defaults.environment.liquid_alpha.slime, 1,
                        "Opacity of slime, unless the level sets it.");
  lava_alpha_ = factor("r_lavaalpha", defaults.environment.liquid_alpha.lava, 1,
                       "Opacity of lava, unless the level sets it.");
  teleport_alpha_ = factor("r_telealpha", defaults.environment.liquid_alpha.teleport, 1,
                           "Opacity of teleporters, unless the level sets it.");
  fog_ =
      variables.add_bool("r_fog", defaults.environment.fog, "Shows fog where the level or server wants it.");
  skybox_ = variables.add_bool("r_skybox", defaults.environment.skybox,
                               "Shows skyboxes where the level or server wants them.");
  external_textures_ = variables.add_bool("r_external_textures", defaults.level.external_textures,
                                          "Replaces textures by the pictures in textures/, from the next "
                                          "level on.");
  variables.add_alias("gl_load24bit", "r_external_textures");  // other engines' name
  subtitles_ = variables.add_bool("scr_subtitles", defaults.subtitles,
                                  "Shows captions for sounds from outside your view.");
  sound_volume_ = variables.add_float("volume", 0.7, 0, 1, "Volume of sound effects.");
  ambient_level_ = variables.add_float("ambient_level", 0.3, 0, 1, "Volume of water and wind.");
  music_volume_ = factor("bgmvolume", defaults.volumes.music, 1, "Volume of the music.");
  music_layers_ = variables.add_bool("bgm_layers", defaults.volumes.music_layers,
                                     "Adds the music's combat layer in fights.");
  muffled_underwater_ = factor("s_underwater", defaults.volumes.muffled_underwater, 1,
                               "How much sounds are muffled underwater. The original: 0.");
  focus_ = variables.add_bool(
      "snd_focus", defaults.volumes.focus,
      "Softens creatures that are farther away than the nearest one you hear. The original: 0.");
}

PresentationSettings ClientVariables::read(const command::Variables& variables) const {
  const auto factor = [&](command::VariableIndex index) {
    return static_cast<float>(variables.float_value(index));
  };
  PresentationSettings settings;
  settings.predict = variables.bool_value(predict_);
  settings.interpolate = !variables.bool_value(no_lerp_);
  settings.no_lerp_models = split_at_commas(variables.text_value(no_lerp_models_));
  settings.effects.max_particles = static_cast<std::size_t>(variables.int_value(max_particles_));
  settings.choices = choices_.read(variables);
  settings.effects.colored_lights = variables.bool_value(colored_lights_);
  settings.effects.muzzle_flashes = !variables.bool_value(no_flash_);
  settings.effects.casings = variables.bool_value(casings_);
  settings.effects.smoke = variables.bool_value(smoke_);
  settings.effects.impacts = variables.bool_value(impacts_);
  settings.effects.splashes = variables.bool_value(splashes_);
  settings.effects.barrel_beams = variables.bool_value(barrel_beams_);
  settings.effects.marks = variables.bool_value(marks_);
  settings.view.bob = factor(bob_);
  settings.view.bob_cycle_s = variables.float_value(bob_cycle_);
  settings.view.bob_up = variables.float_value(bob_up_);
  settings.view.roll = factor(roll_);
  settings.view.kick = factor(kick_);
  settings.view.shake = factor(shake_);
  settings.view.natural_liquids = variables.bool_value(natural_liquids_);
  settings.view.kick_s = variables.float_value(kick_time_);
  settings.view.idle_sway = factor(idle_sway_);
  settings.view.damage_tint = factor(damage_tint_);
  settings.view.bonus_tint = factor(bonus_tint_);
  settings.view.powerup_tint = factor(powerup_tint_);
  settings.view.contents_tint = factor(contents_tint_);
  settings.hud.status_bar = to_status_bar(variables.int_value(view_size_));
  settings.hud.layout = static_cast<HudLayout>(variables.int_value(hud_layout_));
  settings.view.weapon_rise = choose_weapon_rise(settings.hud);
  settings.hud.size.scale = static_cast<int>(variables.int_value(hud_scale_));
  settings.hud.opacity = factor(hud_opacity_);
  settings.hud.crosshair = {static_cast<Crosshair>(variables.int_value(crosshair_)),
                            static_cast<std::uint8_t>(variables.int_value(crosshair_color_)),
                            variables.float_value(crosshair_scale_)};
  settings.hud.center_text_s = variables.float_value(center_time_);
  settings.hud.letters_per_second = variables.float_value(print_speed_);
  settings.hud.notices = {variables.bool_value(pickups_), variables.bool_value(weapon_list_),
                          variables.bool_value(power_timers_), variables.bool_value(damage_arcs_)};
  settings.hud.safe_colors = variables.bool_value(safe_colors_);
  settings.runs_hud_program = !variables.bool_value(no_hud_program_);
  settings.show_weapon = variables.bool_value(show_weapon_);
  settings.weapon_fov_deg = factor(weapon_fov_);
  settings.environment.liquid_alpha = {factor(water_alpha_), factor(slime_alpha_), factor(lava_alpha_),
                                       factor(teleport_alpha_)};
  settings.environment.fog = variables.bool_value(fog_);
  settings.environment.skybox = variables.bool_value(skybox_);
  settings.level.external_textures = variables.bool_value(external_textures_);
  settings.subtitles = variables.bool_value(subtitles_);
  settings.volumes = {factor(sound_volume_),
                      factor(ambient_level_),
                      factor(music_volume_),
                      factor(muffled_underwater_),
                      variables.bool_value(music_layers_),
                      variables.bool_value(focus_)};
  return settings;
}

}  // namespace temblor::client
