// The world that physics and QuakeC's built-in functions act on: the level, its entities, and where they are.
// An entity's fields say where it is; link() makes the rest of the world agree with them (areas for
// collisions, leaves for visibility). Whatever moves an entity must call it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "math/physics_settings.h"
#include "server/game/areas.h"
#include "server/game/edicts.h"
#include "server/game/game_calls.h"
#include "world/level.h"
#include "world/visibility.h"

namespace temblor::server {

// The meaning of a model number: a box, and for brush models the model of the level.
struct ServerModel {
  std::string name;  // "maps/e1m1.bsp", "*1", "progs/ogre.mdl"
  math::Bounds box;
  std::optional<world::ModelIndex> brush_model{};
};

// A sound that physics makes without QuakeC (a splash, a landing).
struct PhysicsSound {
  vm::EntityIndex entity{};
  std::string_view name;
};

// Memory that is kept from tick to tick, so that ticks allocate nothing once they have warmed up. Each list
// is a stack: its user appends, and truncates the list when done. QuakeC that runs in between may push onto
// the same list.
//    user A: [a a a]    A's touch function runs user B: [a a a b b]    B is done: [a a a]    A is done: []
struct Scratch {
  std::vector<vm::EntityIndex> found;
  struct Moved {
    vm::EntityIndex entity{};
    math::Vec3 from{0.0f};
  };
  std::vector<Moved> moved;
};

struct GameWorld {
  std::shared_ptr<const world::Level> level;
  std::vector<ServerModel> models;  // [0] is none; [1] is the level
  Edicts edicts;
  Areas areas;  // of linked entities, see link()
  GameCalls& calls;
  math::PhysicsSettings settings{};
  double time_s = 1;         // of the game; levels start at 1
  double tick_s = 1.0 / 72;  // frametime
  // Degrees that players on stairs look up or down, for each unit that a step rises.
  float ideal_pitch_scale = 0.8f;
  // Set if the program defines such a field.
  std::optional<Field<float>> gravity_field{};
  std::vector<PhysicsSound> sounds{};  // of this tick; the caller of the tick sends and clears them
  Scratch scratch{};
  std::vector<world::PlacedLiquid> liquids{};  // of a Half-Life level, where link() found them

  // The model of an entity's modelindex. Null: there is no such model.
  const ServerModel* find_model(const Edict& edict) const;
};

// Whether the entity exists and is not free.
bool is_there(const GameWorld& world, vm::EntityIndex entity);

enum class TouchTriggers { kNo, kYes };

// Updates absmin, absmax, leaves and areas from an entity's origin and size. Call it after every move. With
// kYes it also calls the touch functions of all triggers that the entity's box meets. The
// triggers are collected before the first call, as in stock Quake, and each is touched only if it and the
// entity still exist.
base::Status link(GameWorld& io_world, vm::EntityIndex entity, TouchTriggers touch);
// After this, traces and triggers do not find the entity. Its fields stay.
void unlink(GameWorld& io_world, vm::EntityIndex entity);
// Unlinks and frees the entity. The world and players are only unlinked.
void remove(GameWorld& io_world, vm::EntityIndex entity);

}  // namespace temblor::server
