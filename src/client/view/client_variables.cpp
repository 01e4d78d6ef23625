#include "client/view/client_variables.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

namespace temblor::client {
namespace {

// As the original's viewsize: what of the status bar is left.
constexpr std::int64_t kSmallBarViewSize = 110, kNoBarViewSize = 120;

StatusBar status_bar_of(std::int64_t view_size) {
  if (view_size >= kNoBarViewSize) return StatusBar::kNone;
  return view_size >= kSmallBarViewSize ? StatusBar::kSmall : StatusBar::kFull;
}

float weapon_rise_above(StatusBar bar) {
  if (bar == StatusBar::kNone) return 0;
  return bar == StatusBar::kSmall ? 1 : 2;
}

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

ClientVariables::ClientVariables(command::Variables& variables) {
  const PresentationSettings defaults;
  const auto factor = [&](const char* name, float value, double most, const char* help) {
    return variables.add_float(name, static_cast<double>(value), 0, most, help);
  };
  no_lerp_ = variables.add_bool("cl_nolerp", !defaults.interpolate,
                                "Entities stand where the server's last word put them, as in the original's "
                                "recordings; 0: they move smoothly.");
  predict_ = variables.add_bool("cl_predict", defaults.predict,
                                "Shows the player's own movement at once, where the server takes part.");
  no_lerp_models_ =
      variables.add_text("r_nolerp_list", fmt::format("{}", fmt::join(defaults.no_lerp_models, ",")),
                         "Models that jump from frame to frame, with commas between.");
  max_particles_ =
      variables.add_int("r_particles_max", static_cast<std::int64_t>(defaults.effects.max_particles), 0,
                        1 << 20, "Particles at a time; further ones are left out.");
  marks_ = variables.add_bool("r_marks", defaults.effects.marks,
                              "Shots leave holes and scorches on walls, which the original does not have.");
  bob_ = factor("v_bob", defaults.view.bob, 4, "How much the view sways while walking; 1: as the original.");
  roll_ = factor("v_roll", defaults.view.roll, 4, "How much the view leans in sideways movement.");
  kick_ = factor("v_kick", defaults.view.kick, 4, "How much damage and recoil shake the view.");
  damage_tint_ = factor("v_tint_damage", defaults.view.damage_tint, 1, "Strength of the flash when hurt.");
  bonus_tint_ = factor("v_tint_bonus", defaults.view.bonus_tint, 1, "Strength of the flash of pick-ups.");
  powerup_tint_ = factor("v_tint_powerup", defaults.view.powerup_tint, 1, "Strength of power-ups' colors.");
  contents_tint_ = factor("v_tint_liquid", defaults.view.contents_tint, 1, "Strength of liquids' colors.");
  view_size_ = variables.add_int("viewsize", 100, 30, kNoBarViewSize,
                                 "110: the status bar without the row above it; 120: no status bar.");
  hud_scale_ = variables.add_int("scr_scale", defaults.hud.scale, 0, 64,
                                 "Pixels for each of the 2-D pictures'; 0: chosen from the frame's size.");
  hud_opacity_ = factor("scr_sbaralpha", defaults.hud.opacity, 1, "Opacity of the status bar.");
  crosshair_ = variables.add_int(
      "crosshair", 0, 0, 3, "A mark where shots go: 1: a cross of the game's letters; 2: a dot; 3: lines.");
  crosshair_color_ = variables.add_int("crosshair_color", defaults.hud.crosshair.color, 0, 255,
                                       "Color of its dot or lines, of the game's palette.");
  safe_colors_ = variables.add_bool("scr_safecolors", defaults.hud.safe_colors,
                                    "The status bar tells by marks too what it tells by colors: low numbers, "
                                    "kinds of armor and of keys.");
  show_weapon_ = variables.add_bool("r_drawviewmodel", defaults.show_weapon, "Draws the weapon in hand.");
  water_alpha_ = factor("r_wateralpha", defaults.liquid_alpha.water, 1,
                        "Opacity of water, where the level does not say.");
  slime_alpha_ = factor("r_slimealpha", defaults.liquid_alpha.slime, 1, "Opacity of slime, alike.");
  lava_alpha_ = factor("r_lavaalpha", defaults.liquid_alpha.lava, 1, "Opacity of lava, alike.");
  teleport_alpha_ =
      factor("r_telealpha", defaults.liquid_alpha.teleport, 1, "Opacity of teleporters, alike.");
  fog_ = variables.add_bool("r_fog", defaults.fog, "Draws the fog that a level or server asks for.");
  skybox_ =
      variables.add_bool("r_skybox", defaults.skybox, "Draws the skybox that a level or server asks for.");
  subtitles_ = variables.add_bool("scr_subtitles", defaults.subtitles,
                                  "Names sounds that come from where the player does not look.");
  sound_volume_ = variables.add_float("volume", 0.7, 0, 1, "How loud sounds are.");
  ambient_level_ =
      variables.add_float("ambient_level", 0.3, 0, 1, "How loud water and wind are, of what the level says.");
  music_volume_ = factor("bgmvolume", defaults.volumes.music, 1, "How loud music is.");
  muffled_underwater_ = factor("s_underwater", defaults.volumes.muffled_underwater, 1,
                               "How much sounds are muffled while the head is under water; the original: 0.");
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
  settings.effects.marks = variables.bool_value(marks_);
  settings.view.bob = factor(bob_);
  settings.view.roll = factor(roll_);
  settings.view.kick = factor(kick_);
  settings.view.damage_tint = factor(damage_tint_);
  settings.view.bonus_tint = factor(bonus_tint_);
  settings.view.powerup_tint = factor(powerup_tint_);
  settings.view.contents_tint = factor(contents_tint_);
  settings.hud.status_bar = status_bar_of(variables.int_value(view_size_));
  settings.view.weapon_rise = weapon_rise_above(settings.hud.status_bar);
  settings.hud.scale = static_cast<int>(variables.int_value(hud_scale_));
  settings.hud.opacity = factor(hud_opacity_);
  settings.hud.crosshair = {static_cast<Crosshair>(variables.int_value(crosshair_)),
                            static_cast<std::uint8_t>(variables.int_value(crosshair_color_))};
  settings.hud.safe_colors = variables.bool_value(safe_colors_);
  settings.show_weapon = variables.bool_value(show_weapon_);
  settings.liquid_alpha = {factor(water_alpha_), factor(slime_alpha_), factor(lava_alpha_),
                           factor(teleport_alpha_)};
  settings.fog = variables.bool_value(fog_);
  settings.skybox = variables.bool_value(skybox_);
  settings.subtitles = variables.bool_value(subtitles_);
  settings.volumes = {factor(sound_volume_), factor(ambient_level_), factor(music_volume_),
                      factor(muffled_underwater_)};
  return settings;
}

}  // namespace temblor::client
