// Computes the effect of a player's input and of the water around it on its velocity in one tick.
// A server calls this before game code runs. A client that predicts its own moves calls it without any game
// code. Both must get the same numbers, so this folder depends on nothing but math, world and base.
//    Command --> apply_wishes() --> velocity --> walk() or slide() --> new origin
//               (this header)                   (walk.h, slide.h)
#pragma once

#include "base/function_ref.h"
#include "movement/player/velocity.h"
#include "movement/slide.h"
#include "world/level.h"

namespace temblor::movement {

// The box of every player of stock game code, around its origin.
constexpr math::Vec3 kPlayerMins{-16, -16, -24}, kPlayerMaxs{16, 16, 32};

// A crouching player, in Half-Life's levels: the height of their low hull, and the share of its pace.
constexpr math::Vec3 kCrouchedMaxs{16, 16, 12};
constexpr float kCrouchedPace = 1.0f / 3;

// How an entity moves, as far as its player's wishes matter.
enum class MoveMode : std::uint8_t { kStill, kWalk, kFly, kNoClip, kThrown };

struct Player {
  Body body;
  float mins_z = kPlayerMins.z;
  MoveMode move_mode = MoveMode::kWalk;
  bool is_alive = true;
  bool is_crouching = false;
  bool is_turned_by_game = false;  // the model does not follow the view in this tick (fixangle)
  math::Vec3 angles_deg{0.0f};     // of the model; wishes on foot go along its axes
  math::Vec3 punch_deg{0.0f};      // how far shots have kicked the view
  int water_level = 0;             // 0 to 3, see Water
  bool is_jumping_out_of_water = false;
  math::Vec3 water_jump_velocity{0.0f};  // along x and y, during that jump
  // Seconds until the entity's teleport_time. Until then a jump out of water lasts, and the player cannot
  // walk backward. Negative once it has passed.
  double teleport_time_s = 0;
};

// Whether a player crouches in its next tick in a Half-Life level, if it stands or crouches now: on foot and
// alive, while it wishes to go down, and after that until `can_stand_up` returns true.
bool is_crouching_next(const Player& player, float wish_up, base::FunctionRef<bool()> can_stand_up);

// A player's input for one tick.
struct Command {
  math::Vec3 view_angles_deg{0.0f};
  Wish wish{};
};

// Updates velocity, angles and punch for one tick of a player who is not kStill, and ends a jump out of water
// that is over. `is_edge` returns whether nothing is between the ends of a probe.
void apply_wishes(Player& io_player, const Command& command, const math::PhysicsSettings& settings,
                  float tick_s, base::FunctionRef<bool(const EdgeProbe&)> is_edge);

// How deep a player is in a liquid.
struct Water {
  int level = 0;                                      // 0: dry, 1: feet, 2: waist, 3: eyes
  world::Contents at_feet = world::Contents::kEmpty;  // kEmpty at level 0
};
// A player swims at this level and above.
constexpr int kSwimmingLevel = 2;
// Everything that is neither air nor rock; as in the original, that includes the sky.
constexpr bool is_liquid(world::Contents contents) {
  return contents <= world::Contents::kWater;
}
// Heights over the player's origin.
struct PlayerHeights {
  float mins = kPlayerMins.z, maxs = kPlayerMaxs.z, eyes = 22;
};
// Probes three heights: one unit above the feet, the middle of the box, and the eyes. `contents_at` returns
// the level's contents at a point.
Water find_water(const math::Vec3& origin, const PlayerHeights& heights,
                 base::FunctionRef<world::Contents(const math::Vec3&)> contents_at);

}  // namespace temblor::movement
