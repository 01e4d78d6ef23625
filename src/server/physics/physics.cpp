#include "server/physics/physics.h"

#include <bit>

#include "server/physics/moves.h"

namespace temblor::server {
namespace {

// Players are not handled here: whatever their move type, run_player() moves them.
base::Status run_entity(GameWorld& io_world, vm::EntityIndex entity) {
  switch (io_world.edicts[entity].move_type()) {
    case MoveType::kWalk:
      return run_walker(io_world, entity);
    case MoveType::kStep:
      return run_monster(io_world, entity);
    case MoveType::kFly:
    case MoveType::kToss:
    case MoveType::kFlyMissile:
    case MoveType::kBounce:
      return run_thrown(io_world, entity);
    case MoveType::kPush:
      return run_pusher(io_world, entity);
    case MoveType::kNoClip:
      return run_ghost(io_world, entity);
    case MoveType::kFollow:
      return run_follower(io_world, entity);
    case MoveType::kNone:
      break;
  }
  // An unknown number stands still, too. The original ended the game.
  return run_still(io_world, entity);
}

// The global is a QuakeC float that is passed around as its word.
bool is_above_zero(std::uint32_t float_word) {
  return std::bit_cast<float>(float_word) > 0;
}

}  // namespace

base::Status run_physics(GameWorld& io_world, const TickFunctions& functions,
                         std::span<const bool> active_players, std::uint32_t& io_force_retouch) {
  TRY_STATUS(io_world.calls.call(functions.start_frame, vm::kWorld, vm::kWorld, io_world.time_s));
  for (std::uint32_t i = 0; i < io_world.edicts.count(); ++i) {
    const vm::EntityIndex entity{i};
    if (io_world.edicts.is_free(entity)) continue;
    if (is_above_zero(io_force_retouch)) {
      TRY_STATUS(link(io_world, entity, TouchTriggers::kYes));
      if (!is_there(io_world, entity)) continue;
    }
    if (!io_world.edicts.is_client(entity)) {
      TRY_STATUS(run_entity(io_world, entity));
    } else if (i - 1 < active_players.size() && active_players[i - 1]) {
      TRY_STATUS(run_player(io_world, entity, functions));
    }
  }
  if (is_above_zero(io_force_retouch))
    io_force_retouch = std::bit_cast<std::uint32_t>(std::bit_cast<float>(io_force_retouch) - 1);
  io_world.time_s += io_world.tick_s;
  return base::Ok{};
}

}  // namespace temblor::server
