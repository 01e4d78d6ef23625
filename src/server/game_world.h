// What physics and built-in functions act upon: the level, its entities and where they are.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "movement/settings.h"
#include "server/game/areas.h"
#include "server/game/edicts.h"
#include "server/game/game_calls.h"
#include "world/level.h"

namespace temblor::server {

// Console variables that physics reads.
using PhysicsSettings = movement::Settings;

// What a model number stands for: a box to stand in for it, and for brush models which of the level's.
struct ServerModel {
  std::string name;  // "maps/e1m1.bsp", "*1", "progs/ogre.mdl"
  math::Bounds box;
  std::optional<world::ModelIndex> brush_model{};
};

// Sounds that physics makes by itself (splashes, landings); the server sends them.
struct PhysicsSound {
  vm::EntityIndex entity{};
  std::string_view name;
};

// Room that is kept from tick to tick, so that a warm one asks the heap for nothing. Each list is a stack:
// whoever uses it appends, and cuts it back when done, for what QuakeC does in between may use it, too.
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
  Areas areas;
  GameCalls& calls;
  PhysicsSettings settings{};
  double time_s = 1;
  double tick_s = 1.0 / 72;  // frametime
  float ideal_pitch_scale =
      0.8f;  // degrees that players look down or up, a unit that each step of a stair rises
  // Fields that a program may define beside the system's.
  std::optional<Field<float>> gravity_field{};
  std::vector<PhysicsSound> sounds{};  // of this tick: whoever runs the tick takes and clears them
  Scratch scratch{};

  // The model of an entity's modelindex; none for a number that is none.
  const ServerModel* model_of(const Edict& edict) const;
};

// Whether the entity is neither freed nor past the last one.
bool is_there(const GameWorld& world, vm::EntityIndex entity);

enum class TouchTriggers { kNo, kYes };

// Brings absmin, absmax, its leaves and the areas up to date with an entity's origin and size: after every
// move. With kYes, calls touch of every trigger that its box meets, as the original does: those found before
// the first call, each only while it and the entity are still there.
base::Status link(GameWorld& io_world, vm::EntityIndex entity, TouchTriggers touch);
void unlink(GameWorld& io_world, vm::EntityIndex entity);
// Unlinks and frees; the world and players are only unlinked.
void remove(GameWorld& io_world, vm::EntityIndex entity);

}  // namespace temblor::server
