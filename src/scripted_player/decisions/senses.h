// What a player feels of himself and of the ground around him, on the server that runs.
#pragma once

#include "math/vec.h"
#include "server/game.h"

namespace temblor::player {

constexpr math::Vec3 kEyeHeight{0, 0, 22};

struct Self {
  vm::EntityIndex entity{};
  math::Vec3 origin{0.0f}, velocity{0.0f};
  bool on_ground = false;
  vm::EntityIndex ground{};
  int water_level = 0;
  float health = 0, armor = 0;
  int items = 0, weapon = 0;
  float shells = 0, nails = 0, rockets = 0, cells = 0;
  bool is_alive() const { return health > 0; }
  bool swims() const { return water_level >= 2; }
  math::Vec3 eye() const { return origin + kEyeHeight; }
};

Self feel_self(server::Game& io_game, std::size_t slot);

// Whether one can walk straight there, over steps, without falling, swimming or burning; nobody else is
// asked.
bool can_walk(server::GameWorld& io_world, vm::EntityIndex player, const math::Vec3& from,
              const math::Vec3& to);
// Straight through water.
bool can_swim(server::GameWorld& io_world, vm::EntityIndex player, const math::Vec3& from,
              const math::Vec3& to);
// Whether who walks there, and off it, comes down in lava or slime.
bool ends_in_fire(server::GameWorld& io_world, vm::EntityIndex player, const math::Vec3& from,
                  const math::Vec3& to);
// A line without width that only the level and its doors stop.
bool sees(server::GameWorld& io_world, vm::EntityIndex player, const math::Vec3& from, const math::Vec3& to);

// Pitch and yaw from there to there.
math::Vec3 angles_towards(const math::Vec3& from, const math::Vec3& to);
// -180 to 180
float turn_between_deg(float from_deg, float to_deg);

}  // namespace temblor::player
