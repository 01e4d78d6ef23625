// The weapons that the player has, with their ammo: a row that appears for a second after a change of
// weapons.
#pragma once

#include <cstdint>

#include "assets/mission_pack.h"
#include "client/hud/panel.h"
#include "client/session/client_state.h"

namespace temblor::client {

class WeaponList {
 public:
  void begin_level();
  // `is_watched`: see PickupList.
  void advance(const Game& game, assets::MissionPack pack, double time_s, bool is_watched);
  bool is_shown(double time_s) const;
  // Draws the row above the panel's y 0, centered at its x 0. It is at most `max_width` wide: many weapons
  // overlap in a narrow frame.
  void draw(const Panel& panel, const Game& game, assets::MissionPack pack, int max_width,
            double time_s) const;

 private:
  double changed_s_ = 0;
  std::uint32_t weapon_ = 0;
};

constexpr int kWeaponListHeight = 26;

}  // namespace temblor::client
