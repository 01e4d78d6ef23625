// Each variable of the client sets its own field and no other.
#include "client/view/client_variables.h"

#include <gtest/gtest.h>

#include <functional>

namespace temblor::client {
namespace {

struct Case {
  const char* assignment;
  std::function<double(const PresentationSettings&)> field;
  double usual, set;
};

std::vector<Case> cases() {
  const auto bar = [](StatusBar status_bar) { return static_cast<double>(status_bar); };
  return {
      {"cl_predict=0", [](const auto& s) { return s.predict; }, 1, 0},
      {"cl_nolerp=1", [](const auto& s) { return s.interpolate; }, 1, 0},
      {"r_particles_max=7", [](const auto& s) { return static_cast<double>(s.effects.max_particles); }, 16384,
       7},
      {"r_marks=1", [](const auto& s) { return s.effects.marks; }, 0, 1},
      {"cl_casings=1", [](const auto& s) { return s.effects.casings; }, 0, 1},
      {"cl_smoke=1", [](const auto& s) { return s.effects.smoke; }, 0, 1},
      {"cl_impacts=1", [](const auto& s) { return s.effects.impacts; }, 0, 1},
      {"cl_splashes=1", [](const auto& s) { return s.effects.splashes; }, 0, 1},
      {"cl_barrelbeam=1", [](const auto& s) { return s.effects.barrel_beams; }, 0, 1},
      {"v_shake=0.5", [](const auto& s) { return s.view.shake; }, 1, 0.5},
      {"v_liquid_colors=1", [](const auto& s) { return s.view.natural_liquids; }, 0, 1},
      {"v_bob=0.5", [](const auto& s) { return s.view.bob; }, 1, 0.5},
      {"v_roll=0.5", [](const auto& s) { return s.view.roll; }, 1, 0.5},
      {"v_kick=0.5", [](const auto& s) { return s.view.kick; }, 1, 0.5},
      {"v_tint_damage=0.5", [](const auto& s) { return s.view.damage_tint; }, 1, 0.5},
      {"v_tint_bonus=0.5", [](const auto& s) { return s.view.bonus_tint; }, 1, 0.5},
      {"v_tint_powerup=0.5", [](const auto& s) { return s.view.powerup_tint; }, 1, 0.5},
      {"v_tint_liquid=0.5", [](const auto& s) { return s.view.contents_tint; }, 1, 0.5},
      {"viewsize=120", [bar](const auto& s) { return bar(s.hud.status_bar); }, bar(StatusBar::kFull),
       bar(StatusBar::kNone)},
      {"scr_hudstyle=2", [](const auto& s) { return static_cast<double>(s.hud.layout); }, 0, 2},
      {"scr_pickups=1", [](const auto& s) { return s.hud.notices.pickups; }, 0, 1},
      {"scr_weaponlist=1", [](const auto& s) { return s.hud.notices.weapons; }, 0, 1},
      {"scr_poweruptimers=1", [](const auto& s) { return s.hud.notices.power_timers; }, 0, 1},
      {"scr_damagedirection=1", [](const auto& s) { return s.hud.notices.damage; }, 0, 1},
      {"scr_scale=3", [](const auto& s) { return s.hud.size.scale; }, 0, 3},
      {"crosshair=2", [](const auto& s) { return static_cast<double>(s.hud.crosshair.shape); }, 0, 2},
      {"crosshair_color=251", [](const auto& s) { return s.hud.crosshair.color; }, 15, 251},
      {"scr_safecolors=1", [](const auto& s) { return s.hud.safe_colors; }, 0, 1},
      {"scr_sbaralpha=0.5", [](const auto& s) { return s.hud.opacity; }, 1, 0.5},
      {"r_drawviewmodel=0", [](const auto& s) { return s.show_weapon; }, 1, 0},
      {"r_wateralpha=0.5", [](const auto& s) { return s.environment.liquid_alpha.water; }, 1, 0.5},
      {"r_slimealpha=0.5", [](const auto& s) { return s.environment.liquid_alpha.slime; }, 1, 0.5},
      {"r_lavaalpha=0.5", [](const auto& s) { return s.environment.liquid_alpha.lava; }, 1, 0.5},
      {"r_telealpha=0.5", [](const auto& s) { return s.environment.liquid_alpha.teleport; }, 1, 0.5},
      {"scr_subtitles=1", [](const auto& s) { return s.subtitles; }, 0, 1},
      {"r_fog=0", [](const auto& s) { return s.environment.fog; }, 1, 0},
      {"r_skybox=0", [](const auto& s) { return s.environment.skybox; }, 1, 0},
      {"volume=0.5", [](const auto& s) { return s.volumes.sounds; }, double{0.7f}, 0.5},
      {"ambient_level=0.5", [](const auto& s) { return s.volumes.ambient; }, double{0.3f}, 0.5},
      {"bgm_layers=0", [](const auto& s) { return s.volumes.music_layers ? 1.0f : 0.0f; }, 1, 0},
      {"snd_focus=0", [](const auto& s) { return s.volumes.focus ? 1.0f : 0.0f; }, 1, 0},
      {"bgmvolume=0.5", [](const auto& s) { return s.volumes.music; }, 1, 0.5},
      {"s_underwater=0.5", [](const auto& s) { return s.volumes.muffled_underwater; }, 0, 0.5},
      {"r_nolerp_list=a,,b", [](const auto& s) { return static_cast<double>(s.no_lerp_models.size()); }, 3,
       2},
  };
}

TEST(ClientVariables, EachSetsItsOwnField) {
  const std::vector<Case> all = cases();
  for (const Case& assigned : all) {
    command::Variables variables;
    const ClientVariables client_variables(variables);
    ASSERT_TRUE(variables.set_assignment(assigned.assignment).ok()) << assigned.assignment;
    const PresentationSettings settings = client_variables.read(variables);
    for (const Case& looked_at : all)
      EXPECT_EQ(looked_at.field(settings), &looked_at == &assigned ? looked_at.set : looked_at.usual)
          << looked_at.assignment << " after " << assigned.assignment;
  }
}

TEST(ClientVariables, TheWeaponIsRaisedAboveTheStatusBar) {
  const auto rise = [](const char* assignment) {
    command::Variables variables;
    const ClientVariables client_variables(variables);
    EXPECT_TRUE(variables.set_assignment(assignment).ok());
    return client_variables.read(variables).view.weapon_rise;
  };
  EXPECT_EQ(rise("viewsize=100"), 2);
  EXPECT_EQ(rise("viewsize=109"), 2);
  EXPECT_EQ(rise("viewsize=110"), 1);
  EXPECT_EQ(rise("viewsize=120"), 0);
  EXPECT_EQ(rise("scr_hudstyle=1"), 0) << "the corners leave the middle free";
}

}  // namespace
}  // namespace temblor::client
