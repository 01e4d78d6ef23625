// The power-ups that the player has, each with the seconds that are left. Temblor servers send when they end
// (net/protocol/powerup_end.h). With others, a power-up lasts 30 seconds from the frame in which its item
// appears; one that was there before (a saved game, a jump in a demo) is shown without a number, and so is
// one that lasts longer.
#pragma once

#include <array>
#include <cstdint>

#include "assets/mission_pack.h"
#include "client/hud/panel.h"
#include "client/session/client_state.h"

namespace temblor::client {

class PowerTimers {
 public:
  void begin_level();
  // `is_watched`: see PickupList.
  void advance(const Game& game, double time_s, bool is_watched);
  // Draws a column above the panel's y 0 that ends at its x 0.
  void draw(const Panel& panel, const Game& game, assets::MissionPack pack, double time_s) const;

 private:
  std::uint32_t items_ = 0;
  // By bit of net::ClientData::items; far in the past if unknown.
  std::array<double, 32> gained_s_{};
};

constexpr int kPowerTimerWidth = 34, kPowerTimerHeight = 18;

}  // namespace temblor::client
