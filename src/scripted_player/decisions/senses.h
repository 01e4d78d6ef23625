// Reads a player's own state and probes the surroundings, in the running game.
#pragma once

#include "math/vec.h"
#include "server/game.h"

namespace temblor::player {

constexpr math::Vec3 kEyeHeight{0, 0, 22};

// A player's own state in this tick, from its edict.
struct Self {
  vm::EntityIndex entity{};
  math::Vec3 origin{0.0f}, velocity{0.0f};
  bool on_ground = false;
  vm::EntityIndex ground{};
  // 0 dry, 1 feet, 2 waist, 3 eyes.
  int water_level = 0;
  float health = 0, armor = 0;
  // Bits of what the player carries, and the bit of the current weapon.
  int items = 0, weapon = 0;
  float shells = 0, nails = 0, rockets = 0, cells = 0;
  bool is_alive() const { return health > 0; }
  bool swims() const { return water_level >= 2; }
  math::Vec3 eye() const { return origin + kEyeHeight; }
};

// Reads the player in that slot.
Self read_self(server::Game& io_game, std::size_t slot);

// Returns whether a player can walk there in a straight line, over steps, without a drop, lava, or slime.
// Ignores monsters and other players.
bool can_walk(server::GameWorld& io_world, vm::EntityIndex player, const math::Vec3& from,
              const math::Vec3& to);
// Returns whether a player can swim there in a straight line.
bool can_swim(server::GameWorld& io_world, vm::EntityIndex player, const math::Vec3& from,
              const math::Vec3& to);
// Returns whether a player that walks there and drops down ends in lava or slime.
bool leads_into_lava(server::GameWorld& io_world, vm::EntityIndex player, const math::Vec3& from,
                     const math::Vec3& to);
// Returns whether a line of sight is free. Only the level and its doors block it.
bool can_see(server::GameWorld& io_world, vm::EntityIndex player, const math::Vec3& from,
             const math::Vec3& to);

// Returns pitch and yaw of the direction between two points.
math::Vec3 angles_toward(const math::Vec3& from, const math::Vec3& to);
// Returns the shortest turn, -180 to 180.
float angle_difference_deg(float from_deg, float to_deg);

}  // namespace temblor::player
