// Crouching in Half-Life's levels. Their low passages are made for players of 36 units, whom hull 3 of such a
// level serves. Quake's game code does not know this, so the engine changes the player's box and eyes.
#pragma once

#include "server/game/game_world.h"

namespace temblor::server {

// Crouches a living, walking player with the stock box while it wishes to go down (`wish_up` < 0), and lets
// it stand up when there is space above it. The feet stay in place; the eyes move within a fifth of a second.
// Does nothing in other levels.
void crouch(GameWorld& io_world, vm::EntityIndex player, float wish_up);

// Whether crouch() has made the player's box low.
bool is_crouching(const GameWorld& world, const Edict& player);

// By how many units others see the player lower: models of Quake's players cannot crouch, and their heads
// would be in the ceilings of low passages. The legs are in the floor instead. Zero for players who stand.
float find_crouched_drop(const GameWorld& world, const Edict& player);

}  // namespace temblor::server
