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

#include <optional>
#include <string>

#include "base/result.h"
#include "formats/levels/entities.h"
#include "server/game/game_world.h"

namespace temblor::server {

// Shows an entity whose class has no spawn function, by the rules above. Returns false if it is left out;
// then nothing has changed.
base::Result<bool> show_half_life_entity(GameWorld& io_world, const formats::Entity& entity,
                                         vm::EntityIndex index);

// The value of the field "alpha" (GameWorld: 0 is the default, below 0 invisible) for an entity's keys
// "rendermode" and "renderamt". Nothing for entities that are drawn as usual: modes 0 (normal) and 4 (only
// alpha-tested). Modes 1 (color), 2 (texture), 3 (glow), and 5 (additive) get the same; world::BrushEntity
// has the rest of modes 1 and 5.
std::optional<std::string> find_half_life_alpha(const formats::Entity& entity);

}  // namespace temblor::server
