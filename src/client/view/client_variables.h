// The client's console variables: how a game looks and sounds. Most names are stock Quake's or those that
// other engines have established; v_bob, v_roll, v_kick and v_tint_... are factors of this engine, 1 for the
// original's strength.
#pragma once

#include "client/view/presentation.h"
#include "command/variables.h"

namespace temblor::client {

class ClientVariables {
 public:
  // Registers the variables. Their defaults are those of PresentationSettings.
  explicit ClientVariables(command::Variables& variables);

  // The current settings; read them once a frame. `variables` is the table that the constructor received.
  PresentationSettings read(const command::Variables& variables) const;

 private:
  SceneChoiceVariables choices_;
  command::VariableIndex predict_, no_lerp_, no_lerp_models_, max_particles_, marks_, bob_, bob_cycle_,
      bob_up_, roll_, kick_, shake_, damage_tint_, bonus_tint_, powerup_tint_, contents_tint_,
      natural_liquids_, view_size_, hud_layout_, pickups_, weapon_list_, power_timers_, damage_arcs_,
      hud_scale_, hud_opacity_, show_weapon_, weapon_fov_, water_alpha_, slime_alpha_, lava_alpha_,
      teleport_alpha_, fog_, skybox_, external_textures_, subtitles_, crosshair_, crosshair_color_,
      crosshair_scale_, safe_colors_, no_hud_program_, idle_sway_, kick_time_, center_time_, print_speed_,
      no_flash_, colored_lights_, casings_, smoke_, impacts_, splashes_, barrel_beams_, sound_volume_,
      ambient_level_, music_volume_, muffled_underwater_, music_layers_, focus_;
};

}  // namespace temblor::client
