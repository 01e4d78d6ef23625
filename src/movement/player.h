// What a player's wishes and the water around him do to his velocity in one tick: on a server before the
// program is asked, and in a client's prediction, which asks none.
#pragma once

#include "base/function_ref.h"
#include "movement/slide.h"
#include "movement/velocity.h"
#include "world/level.h"

namespace temblor::movement {

// The box of every player of stock programs, and where his eyes are.
constexpr math::Vec3 kPlayerMins{-16, -16, -24}, kPlayerMaxs{16, 16, 32};

enum class MoveMode : std::uint8_t { kStill, kWalk, kFly, kNoClip, kThrown };

struct Player {
  Body body;
  float mins_z = kPlayerMins.z;
  MoveMode move_mode = MoveMode::kWalk;
  bool is_alive = true;
  bool is_turned_by_game = false;  // his model does not follow the view (fixangle)
  math::Vec3 angles_deg{0.0f};     // of his model; the directions of wishes on foot are its own
  math::Vec3 punch_deg{0.0f};      // of the view, by shots
  int water_level = 0;             // 0 to 3, see water_around()
  bool is_jumping_out_of_water = false;
  math::Vec3 water_jump_velocity{0.0f};  // along x and y, meanwhile
  // Until then (teleport_time) a jump out of water lasts, and nobody walks backwards. Negative: since then.
  double teleport_time_s = 0;
};

// Where he looks, and where he wishes to go.
struct Command {
  math::Vec3 view_angles_deg{0.0f};
  Wish wish{};
};

// Velocity, angles and punch of one tick of a player that is not kStill; a jump out of water that is over
// ends. `is_edge` is asked whether nothing is between the ends of a probe.
void apply_wishes(Player& io_player, const Command& command, const Settings& settings, float tick_s,
                  base::FunctionRef<bool(const EdgeProbe&)> is_edge);

// 1: feet, 2: middle, 3: eyes; he swims at 2 and above. `at_feet` is kEmpty at level 0.
struct WaterAround {
  int level = 0;
  world::Contents at_feet = world::Contents::kEmpty;
};
constexpr int kSwimmingLevel = 2;
// All that is neither air nor rock, the sky, too, as in the original.
constexpr bool is_liquid(world::Contents contents) {
  return contents <= world::Contents::kWater;
}
struct PlayerHeights {
  float mins = kPlayerMins.z, maxs = kPlayerMaxs.z, eyes = 22;
};
WaterAround water_around(const math::Vec3& origin, const PlayerHeights& heights,
                         base::FunctionRef<world::Contents(const math::Vec3&)> contents_at);

}  // namespace temblor::movement
