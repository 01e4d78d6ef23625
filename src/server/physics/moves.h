// One tick of one entity, for each way of moving. Players who are in the game have run_player() instead. All
// of these fail only if QuakeC does.
#pragma once

#include "server/game/game_world.h"
#include "server/physics/physics.h"

namespace temblor::server {

base::Status run_walker(GameWorld& io_world, vm::EntityIndex entity);    // kWalk, but not a player
base::Status run_still(GameWorld& io_world, vm::EntityIndex entity);     // MoveType::kNone
base::Status run_ghost(GameWorld& io_world, vm::EntityIndex entity);     // kNoClip
base::Status run_follower(GameWorld& io_world, vm::EntityIndex entity);  // kFollow
base::Status run_thrown(GameWorld& io_world, vm::EntityIndex entity);    // kToss, kBounce, kFly, kFlyMissile
base::Status run_monster(GameWorld& io_world, vm::EntityIndex entity);   // kStep
base::Status run_pusher(GameWorld& io_world, vm::EntityIndex entity);    // kPush

}  // namespace temblor::server
