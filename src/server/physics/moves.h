// The ways of moving, one function each: a tick of one entity.
#pragma once

#include "server/game_world.h"
#include "server/physics/physics.h"

namespace temblor::server {

base::Status run_walker(GameWorld& io_world, vm::EntityIndex entity);    // who walks and is no player
base::Status run_still(GameWorld& io_world, vm::EntityIndex entity);     // MoveType::kNone
base::Status run_ghost(GameWorld& io_world, vm::EntityIndex entity);     // kNoClip
base::Status run_follower(GameWorld& io_world, vm::EntityIndex entity);  // kFollow
base::Status run_thrown(GameWorld& io_world, vm::EntityIndex entity);    // kToss, kBounce, kFly, kFlyMissile
base::Status run_monster(GameWorld& io_world, vm::EntityIndex entity);   // kStep
base::Status run_pusher(GameWorld& io_world, vm::EntityIndex entity);    // kPush

}  // namespace temblor::server
