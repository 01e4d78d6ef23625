// Built-in functions that move monsters and items. Physics does the work, mostly for `self`.
#include "server/builtins/families.h"
#include "server/physics/physics.h"

namespace temblor::server {
namespace {

// Stores the result last: touches during the move may have called other functions.
base::Status returned(Call& io_call, const base::Result<bool>& moved) {
  if (!moved.ok()) return moved.error();
  io_call.machine.return_float(*moved ? 1 : 0);
  return base::Ok{};
}

// walkmove(yaw, distance): takes a step, and returns whether it was possible.
base::Status walkmove(Call& io_call) {
  return returned(io_call, walk_move(io_call.world, io_call.self(), io_call.number(0), io_call.number(1)));
}

// droptofloor(): returns whether there was a floor.
base::Status droptofloor(Call& io_call) {
  return returned(io_call, drop_to_floor(io_call.world, io_call.self()));
}

// checkbottom(entity): whether there is floor under all four corners of its box.
base::Status checkbottom(Call& io_call) {
  TRY(const vm::EntityIndex entity, io_call.entity(0));
  return returned(io_call, check_bottom(io_call.world, entity));
}

// ChangeYaw(): turns `self` toward ideal_yaw.
base::Status change_yaw_of_self(Call& io_call) {
  change_yaw(io_call.world, io_call.self());
  return base::Ok{};
}

// movetogoal(distance): takes a step toward goalentity.
base::Status movetogoal(Call& io_call) {
  return move_to_goal(io_call.world, io_call.self(), io_call.number(0), io_call.game.random);
}

}  // namespace

std::span<const BuiltinEntry> movement_builtins() {
  static constexpr BuiltinEntry kEntries[] = {
      {32, "walkmove", walkmove},       {34, "droptofloor", droptofloor},
      {40, "checkbottom", checkbottom}, {49, "ChangeYaw", change_yaw_of_self},
      {67, "movetogoal", movetogoal},
  };
  return kEntries;
}

}  // namespace temblor::server
