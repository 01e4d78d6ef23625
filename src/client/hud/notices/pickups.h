// The list of pickups: icons with amounts, which fade after three seconds. Servers do not report pickups, so
// they are found by comparing items and stats with those of the frame before.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "assets/mission_pack.h"
#include "client/hud/panel.h"
#include "client/session/client_state.h"

namespace temblor::client {

class PickupList {
 public:
  void begin_level() { lines_.clear(); }
  // Adds the gains since the last call. A further gain of the same kind adds to its line. `is_watched`: the
  // player was in the game at the last call too; otherwise, everything it has counts as old.
  void advance(const Game& game, const Events& events, assets::MissionPack pack, double time_s,
               bool is_watched);
  // Draws the lines on the left side of the frame, the newest at the bottom, at the panel's y 0. `max_lines`:
  // how many there is room for.
  void draw(const Panel& panel, int max_lines, double time_s) const;

 private:
  struct Line {
    std::string picture;
    int amount;  // 0: not shown
    double since_s;
  };
  struct Holdings {
    std::uint32_t items = 0, weapon = 0;
    int health = 0, armor = 0;
    std::array<int, 4> ammo{};
  };
  void add(std::string picture, int amount, double time_s);
  void add_items(std::uint32_t gained, assets::MissionPack pack, double time_s);
  void add_amounts(const Holdings& now, bool has_flashed, assets::MissionPack pack, double time_s);

  std::vector<Line> lines_;  // oldest first
  Holdings before_;
};

// The size of a line, in the original's pixels, and the longest list.
constexpr int kPickupWidth = 58, kPickupHeight = 25, kMaxPickups = 3;

}  // namespace temblor::client
