#include "server/session/move_parameters.h"

#include <algorithm>
#include <cmath>

#include "server/game/baselines.h"

namespace temblor::server {
namespace {

float finite_or_zero(float value) {
  return std::isfinite(value) ? value : 0;
}

// Finds the moving brush model that the player stands on, if any: a client predicts that the player rides
// along.
std::optional<net::MoveAcknowledgment::Ride> find_ride(const Edict& ground) {
  if (ground.solid() != Solid::kBsp || ground.move_type() != MoveType::kPush) return std::nullopt;
  const float left_s = ground[field::kNextThink] - ground[field::kLocalTime];
  return net::MoveAcknowledgment::Ride{.origin = finite(ground[field::kOrigin]),
                                       .velocity = finite(ground[field::kVelocity]),
                                       .left_s = std::max(finite_or_zero(left_s), 0.0f)};
}

}  // namespace

net::MoveParameters make_move_parameters(const GameWorld& world, std::size_t slot, double clock_tick_s) {
  return {.entity = static_cast<std::uint16_t>(slot + 1),
          .tick_s = clock_tick_s,
          .world_tick_s = world.tick_s,
          .physics = world.settings};
}

net::MoveAcknowledgment make_acknowledgment(Game& io_game, std::size_t slot, std::uint32_t number) {
  const Edict edict = io_game.player(slot);
  const GameWorld& world = io_game.world();
  const movement::Player player = make_player(world, edict);
  const auto water_type = static_cast<world::Contents>(edict.whole(field::kWaterType));
  const float own_gravity = world.gravity_field ? edict[*world.gravity_field] : 1;
  net::MoveAcknowledgment acknowledgment{
      .number = number,
      .origin = finite(player.body.origin),
      .velocity = finite(player.body.velocity),
      .angles_deg = finite(player.angles_deg),
      .punch_deg = finite(player.punch_deg),
      .move_type = sent_u8(edict[field::kMoveType]),
      .water_level = static_cast<std::uint8_t>(std::clamp(player.water_level, 0, 3)),
      .is_in_slime = water_type == world::Contents::kSlime,
      .is_in_lava = water_type == world::Contents::kLava,
      .is_alive = player.is_alive,
      .on_ground = player.body.on_ground,
      .is_jump_released = edict.has_flag(flag::kJumpReleased),
      .is_jumping_out_of_water = player.is_jumping_out_of_water,
      .is_turned_by_game = player.is_turned_by_game,
      .is_crouching = player.is_crouching,
      .water_jump_velocity = math::Vec2(finite(player.water_jump_velocity)),
      .teleport_time_s = std::max(finite_or_zero(static_cast<float>(player.teleport_time_s)), 0.0f),
      .own_gravity = own_gravity != 0 && std::isfinite(own_gravity) ? own_gravity : 1};
  if (player.body.ground > 0 && player.body.ground < world.edicts.count() &&
      !world.edicts.is_free(vm::EntityIndex{player.body.ground})) {
    acknowledgment.ground = static_cast<std::uint16_t>(player.body.ground);
    acknowledgment.ride = find_ride(io_game.world().edicts[vm::EntityIndex{player.body.ground}]);
  }
  return acknowledgment;
}

}  // namespace temblor::server
