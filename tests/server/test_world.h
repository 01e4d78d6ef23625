// A world for tests: a level from map text, entities made by hand, and a program whose functions are C++.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "server/move_trace.h"
#include "server/physics/physics.h"
#include "support/levels/room_map.h"

namespace temblor::server {

constexpr math::Bounds kPlayerBox{{-16, -16, -24}, {16, 16, 32}};
constexpr math::Bounds kLargeBox{{-32, -32, -24}, {32, 32, 64}};
constexpr math::Bounds kNoBox{{0, 0, 0}, {0, 0, 0}};
constexpr float kGap = 1.0f / 32;

class FakeCalls : public GameCalls {
 public:
  struct Call {
    vm::FunctionIndex function{};
    vm::EntityIndex self{}, other{};
    double time_s = 0;
  };
  using Function = std::function<void(const Call& call)>;

  vm::FunctionIndex add(Function function);
  // A function that does nothing; its calls are recorded.
  vm::FunctionIndex add() {
    return add([](const Call&) {});
  }
  base::Status call(vm::FunctionIndex function, vm::EntityIndex self, vm::EntityIndex other,
                    double time_s) override;
  int count(vm::FunctionIndex function) const;

  std::vector<Call> log;
  bool keeps_log = true;
  vm::FunctionIndex failing{};  // calling it ends the game

 private:
  std::vector<Function> functions_{{}};
};

class TestWorld {
 public:
  // Models 2 and up of the world are the brush entities of `map_text`.
  explicit TestWorld(const std::string& map_text, std::uint32_t players = 1);
  explicit TestWorld(std::shared_ptr<const world::Level> level, std::uint32_t players = 1);

  // Makes a linked entity.
  Edict spawn(const math::Vec3& origin, const math::Bounds& box, Solid solid, MoveType type);
  // Makes an entity from brush entity `number` (from 1) of the map: solid, at its place in the map.
  Edict spawn_pusher(int number, const math::Vec3& velocity = math::Vec3(0.0f));
  // Player 1, standing.
  Edict player(const math::Vec3& origin);
  // Plays ticks. CHECKs that nothing fails.
  void tick(int count = 1);
  void command_and_tick(const PlayerCommand& command, int count = 1);
  base::Status try_tick();
  Edict operator[](vm::EntityIndex index) { return world.edicts[index]; }

  vm::Machine machine;
  FakeCalls calls;
  GameWorld world;
  TickFunctions functions;
  std::uint32_t force_retouch = 0;
};

// A hall of 1024 by 1024 by 512 units on a floor at 0, with additional brushes and entities in it.
std::string hall_text(const std::string& world_brushes = {}, const std::string& entities = {});
// The same hall with the part below `height` filled with water.
std::string flooded_hall_text(double height);
std::string door_text(const math::Vec3d& mins, const math::Vec3d& maxs);

// A hash of all entities: words, numbers in use, time.
std::uint64_t compute_hash(GameWorld& io_world);

}  // namespace temblor::server
