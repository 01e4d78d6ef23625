// Brush entities of Half-Life's levels (version 30) in a game whose code was written for Quake. Its classes
// are often unknown, and such entities would be removed: walls, windows, and machines would be missing.
//
//   a class that the game code knows    spawned by it
//   func_illusionary, func_water,       drawn, not solid (world::BrushEntity)
//   doors that turn
//   func_ladder and other volumes       left out
//   other func_..., momentary_...,      drawn and solid, never moving
//   button_target
//   all other classes                   left out
#pragma once

#include "base/result.h"
#include "formats/levels/entities.h"
#include "server/game/game_world.h"

namespace temblor::server {

// Shows an entity whose class has no spawn function, by the rules above. Returns false if it is left out;
// then nothing has changed.
base::Result<bool> show_half_life_entity(GameWorld& io_world, const formats::Entity& entity,
                                         vm::EntityIndex index);

}  // namespace temblor::server
