// Short notices that stock Quake does not have, for any layout of the HUD: pickups on the left, a row of
// weapons in the middle, power-ups on the right, arcs around the crosshair.
#pragma once

#include <optional>

#include "assets/mission_pack.h"
#include "client/hud/notices/damage_arcs.h"
#include "client/hud/notices/pickups.h"
#include "client/hud/notices/power_timers.h"
#include "client/hud/notices/weapon_list.h"
#include "client/hud/panel.h"
#include "client/session/client_state.h"
#include "render/scene.h"

namespace temblor::client {

// The notices to show.
struct NoticeSettings {
  bool pickups = false, weapons = false, power_timers = false, damage = false;
};

// How much of the frame the layout takes on each side and in the middle, in the panel's pixels above the
// frame's bottom.
struct LayoutHeights {
  int left = 0, middle = 0, right = 0;
};

class Notices {
 public:
  explicit Notices(assets::MissionPack pack) : pack_(pack) { begin_level(); }

  void begin_level();
  // A player that has just entered the game or has died is not watched: its first items are no pickups.
  void advance(const Game& game, const Events& events, double time_s);
  // Draws above the layout. `camera`: the player's view; without it there are no arcs.
  void draw(const Panel& panel, const Game& game, double time_s, const NoticeSettings& settings,
            const LayoutHeights& heights, const std::optional<render::Camera>& camera) const;
  bool shows_weapons(double time_s) const { return weapons_.is_shown(time_s); }

 private:
  assets::MissionPack pack_;
  PickupList pickups_;
  WeaponList weapons_;
  PowerTimers timers_;
  DamageArcs arcs_;
  bool was_in_game_ = false;
};

// The distances of the notices from the frame's edge and from the layout, in the original's pixels.
constexpr int kNoticeMargin = 2, kNoticeGap = 3;

}  // namespace temblor::client
