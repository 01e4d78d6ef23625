// What a player with a perfect map knows of a level: its moving parts, what sets them off, where its exits,
// teleporters, secrets and items are. Read from the entities of a game that runs.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "math/vec.h"
#include "server/game.h"

namespace temblor::player {

// Bits of `items`.
constexpr int kSilverKey = 131072, kGoldKey = 262144;

// Fields that the game's program has beside the system's; without one, reading gives 0.
class GameFields {
 public:
  explicit GameFields(const vm::Program& program) : program_(&program) {}
  float number(const server::Edict& edict, std::string_view name) const;
  math::Vec3 vector(const server::Edict& edict, std::string_view name) const;
  vm::EntityIndex entity(const server::Edict& edict, std::string_view name) const;
  vm::StringIndex string(const server::Edict& edict, std::string_view name) const;
  vm::FunctionIndex function(const server::Edict& edict, std::string_view name) const;
  bool has(std::string_view name) const;

 private:
  std::optional<std::uint32_t> word(std::string_view name) const;
  const vm::Program* program_;
};

enum class MoverKind { kDoor, kSecretDoor, kLift, kTrain, kWall };

// One brush model of a moving part.
struct MoverPart {
  vm::EntityIndex entity{};
  world::ModelIndex model{};
  math::Bounds box;                // of the model, where it was made
  std::vector<math::Vec3> places;  // its origin in each of the mover's states
};

// Doors that move as one, a lift, a train. States: doors 0 closed, 1 open (secret doors 1 half way, 2 open);
// lifts 0 below, 1 above; trains their corners in order; walls that can vanish 0 there, 1 gone.
struct Mover {
  MoverKind kind = MoverKind::kDoor;
  std::vector<MoverPart> parts{};
  int states = 2;
  std::string target_name{};     // who fires it
  bool opens_by_itself = false;  // for whoever comes near, or stands on it
  bool is_shot = false;
  bool stays_open = false;
  bool toggles = false;
  int key = 0;             // item bit
  std::string describe{};  // "func_door at 10 20 30"

  bool can_be(int state) const { return state >= 0 && state < states; }
};

enum class TriggerKind { kTouch, kSecret, kTeleport, kExit, kHurt, kPush };

struct Trigger {
  TriggerKind kind = TriggerKind::kTouch;
  vm::EntityIndex entity{};
  math::Bounds box{};
  math::Vec3 destination{0.0f};  // of a teleporter
  math::Vec3 velocity{0.0f};     // of a push
  math::Vec3 look{0.0f};         // who touches it has to look there; 0: anywhere
  float damage = 0;
  bool needs_use = false;  // a teleporter that sleeps
  std::string map{};       // of an exit
};

enum class ActivatorKind { kPress, kShoot, kTouch, kTake, kKill, kOpen };

// Something that fires its targets when a player does something to it.
struct Activator {
  ActivatorKind kind = ActivatorKind::kPress;
  vm::EntityIndex entity{};
  std::string target{}, kill_target{}, target_name{};
  math::Bounds box{};
  math::Vec3 look{0.0f};
  std::string describe{};
};

// Hands on: fires its targets when it is fired.
struct Relay {
  std::string target{}, kill_target{}, target_name{};
};

// Where a visitor stops, in order of the numbers: info_notnull named stop1, stop2, ...
struct Stop {
  int number = 0;
  math::Vec3 at{0.0f};
  math::Vec3 look_deg{0.0f};  // pitch (down is positive) and yaw: its mangle, or its angle
  double stay_s = 0;          // its wait
  int impulse = 0;            // of the weapon that is fired there; 0: none
  std::string presses{};      // its target: the button with the same target is pressed first
};

// What stands in the way and never moves.
struct StillModel {
  world::ModelIndex model{};
  math::Vec3 origin{0.0f};
};

struct LevelFacts {
  std::vector<Mover> movers;
  std::vector<Trigger> triggers;
  std::vector<Activator> activators;
  std::vector<Relay> relays;
  std::vector<StillModel> still_models;
  std::vector<math::Bounds> still_boxes;
  std::vector<vm::EntityIndex> secrets;  // the triggers' entities
  std::vector<Stop> stops;

  // The mover that has this entity among its parts; -1: none.
  int mover_of(vm::EntityIndex entity) const;
};

LevelFacts read_level_facts(server::Game& io_game);

std::string class_name(server::Game& io_game, vm::EntityIndex entity);
// "monster_dog at 10 20 30"
std::string describe(server::Game& io_game, vm::EntityIndex entity);
math::Vec3 middle_of(const math::Bounds& box);
math::Bounds box_of(const server::Edict& edict);
bool boxes_meet(const math::Bounds& a, const math::Bounds& b);

}  // namespace temblor::player
