#include "movement/player.h"

namespace temblor::movement {
namespace {

// A model shows a third of its player's pitch, and leans four times as much as the view.
constexpr float kModelPitch = -1.0f / 3, kModelRoll = 4;

// A jump out of the water onto a ledge keeps its velocity until its time is over, or the player is dry.
void jump_out_of_water(Player& io_player) {
  if (io_player.teleport_time_s < 0 || io_player.water_level == 0) io_player.is_jumping_out_of_water = false;
  io_player.body.velocity.x = io_player.water_jump_velocity.x;
  io_player.body.velocity.y = io_player.water_jump_velocity.y;
}

// The roll is computed from the model's old angles, as in the original; it always follows the velocity, even
// if game code has set the other angles (fixangle).
void turn_model(Player& io_player, const math::Vec3& view_deg) {
  math::Vec3& angles = io_player.angles_deg;
  angles.z = find_roll_deg(angles, io_player.body.velocity) * kModelRoll;
  if (io_player.is_turned_by_game) return;
  angles.x = view_deg.x * kModelPitch;
  angles.y = view_deg.y;
}

// A player who does not move along the ground has no direction to probe, and is never at an edge.
bool is_at_edge(const Player& player, base::FunctionRef<bool(const EdgeProbe&)> is_edge) {
  const math::Vec3& velocity = player.body.velocity;
  if (velocity.x == 0 && velocity.y == 0) return false;
  return is_edge(make_edge_probe(player.body.origin, player.mins_z, velocity));
}

// The new velocity on foot, in the air, or through walls. Only a walking player ignores its wish to go up: a
// flying or thrown one may still change its height.
math::Vec3 find_velocity_out_of_water(const Player& player, Wish wish, const math::PhysicsSettings& settings,
                                      float tick_s, base::FunctionRef<bool(const EdgeProbe&)> is_edge) {
  // Right after a teleport the player cannot back into the teleporter again by accident.
  if (player.teleport_time_s > 0 && wish.forward < 0) wish.forward = 0;
  if (player.is_crouching) wish = {wish.forward * kCrouchedPace, wish.side * kCrouchedPace, wish.up};
  math::Vec3 wished = find_wish_velocity(player.angles_deg, wish);
  wished.z = player.move_mode == MoveMode::kWalk ? 0 : wish.up;
  wished = limit_speed(wished, settings.max_speed);

  if (player.move_mode == MoveMode::kNoClip) return wished;
  const math::Vec3& velocity = player.body.velocity;
  if (!player.body.on_ground) return accelerate_in_air(velocity, wished, settings, tick_s);
  const math::Vec3 slowed = apply_ground_friction(velocity, settings, tick_s, is_at_edge(player, is_edge));
  return accelerate_on_ground(slowed, wished, settings, tick_s);
}

}  // namespace

bool is_crouching_next(const Player& player, float wish_up, base::FunctionRef<bool()> can_stand_up) {
  if (player.move_mode != MoveMode::kWalk || !player.is_alive) return player.is_crouching;
  return wish_up < 0 || (player.is_crouching && !can_stand_up());
}

void apply_wishes(Player& io_player, const Command& command, const math::PhysicsSettings& settings,
                  float tick_s, base::FunctionRef<bool(const EdgeProbe&)> is_edge) {
  io_player.punch_deg = fade_punch(io_player.punch_deg, tick_s);
  if (!io_player.is_alive) return;
  turn_model(io_player, command.view_angles_deg + io_player.punch_deg);
  math::Vec3& velocity = io_player.body.velocity;
  if (io_player.is_jumping_out_of_water)
    jump_out_of_water(io_player);
  else if (io_player.water_level >= kSwimmingLevel && io_player.move_mode != MoveMode::kNoClip)
    velocity = accelerate_in_water(velocity, command.view_angles_deg, command.wish, settings, tick_s);
  else
    velocity = find_velocity_out_of_water(io_player, command.wish, settings, tick_s, is_edge);
}

Water find_water(const math::Vec3& origin, const PlayerHeights& heights,
                 base::FunctionRef<world::Contents(const math::Vec3&)> contents_at) {
  const auto contents_above = [&](float height) {
    return contents_at({origin.x, origin.y, origin.z + height});
  };
  const world::Contents at_feet = contents_above(heights.mins + 1);
  if (!is_liquid(at_feet)) return {};
  if (!is_liquid(contents_above((heights.mins + heights.maxs) * 0.5f))) return {1, at_feet};
  return {is_liquid(contents_above(heights.eyes)) ? 3 : 2, at_feet};
}

}  // namespace temblor::movement
