// The facts about a level that a player with perfect knowledge has: its moving parts, what activates them,
// and where its exits, teleporters, secrets, and tour stops are.
//
// Everything is read once from the edicts of a running game, so it works for any level and for the values
// that game code has computed, such as the open position of a door. It relies on names of the shipped game
// code: classnames like "func_door" and fields like "place_open".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "math/vec.h"
#include "server/game.h"

namespace temblor::player {

// Bits of a player's `items` field.
constexpr int kSilverKey = 131072, kGoldKey = 262144;

// Reads fields that the game code defines in addition to the engine's fields, by name. A field that the
// program does not have reads as 0, "", or the world.
class GameFields {
 public:
  // `program` must outlive it.
  explicit GameFields(const vm::Program& program) : program_(&program) {}
  float number(const server::Edict& edict, std::string_view name) const;
  math::Vec3 vector(const server::Edict& edict, std::string_view name) const;
  vm::EntityIndex entity(const server::Edict& edict, std::string_view name) const;
  vm::StringIndex string(const server::Edict& edict, std::string_view name) const;
  vm::FunctionIndex function(const server::Edict& edict, std::string_view name) const;
  bool has(std::string_view name) const;

 private:
  // Offset of the field in an edict, in 32-bit words.
  std::optional<std::uint32_t> word(std::string_view name) const;
  const vm::Program* program_;
};

// kWall is a brush model that game code can remove: a func_breakable or a named func_wall.
enum class MoverKind { kDoor, kSecretDoor, kLift, kTrain, kWall };

// One brush model of a mover.
struct MoverPart {
  vm::EntityIndex entity{};
  world::ModelIndex model{};
  // The model's bounds for origin 0.
  math::Bounds box;
  // The entity's origin in each of the mover's states.
  std::vector<math::Vec3> places;
};

// Something that moves as one: linked doors, a lift, or a train. Its position is one of a few states:
//
//   kind         state 0   state 1    state 2 ...
//   kDoor        closed    open
//   kSecretDoor  closed    sideways   open
//   kLift        low       high
//   kTrain       the path corners in order, the first one where the train stands
//   kWall        solid     gone
struct Mover {
  MoverKind kind = MoverKind::kDoor;
  // At least one. The first part is the leader; its position tells the state.
  std::vector<MoverPart> parts{};
  int states = 2;
  std::string target_name{};
  // Opens or starts when a player touches it, comes near, or stands on it.
  bool opens_automatically = false;
  // Opens when it is shot.
  bool is_shot = false;
  bool stays_open = false;
  // Closes only when it is activated again.
  bool toggles = false;
  // The item bit of the key that it needs; 0: none.
  int key = 0;
  // Classname and position for messages: "func_door at 10 20 30".
  std::string description{};
};

enum class TriggerKind { kTouch, kSecret, kTeleport, kExit, kHurt, kPush };

// A volume that does something to a player who touches it.
struct Trigger {
  TriggerKind kind = TriggerKind::kTouch;
  vm::EntityIndex entity{};
  math::Bounds box{};
  // Where a teleporter leads: the player's origin.
  math::Vec3 destination{0.0f};
  // The velocity that a push sets, in units/s.
  math::Vec3 velocity{0.0f};
  // A player must face this direction to activate it; 0: any.
  math::Vec3 look{0.0f};
  // Health that one touch costs; negative if it heals.
  float damage = 0;
  // A teleporter that works only while another entity activates it.
  bool needs_use = false;
  // The level that an exit leads to.
  std::string map{};
};

enum class ActivatorKind { kPress, kShoot, kTouch, kTake, kKill, kOpen };

// An entity that fires its targets when a player presses, shoots, touches, takes, kills, or opens it.
struct Activator {
  ActivatorKind kind = ActivatorKind::kPress;
  vm::EntityIndex entity{};
  std::string target{}, kill_target{}, target_name{};
  math::Bounds box{};
  // The same as Trigger::look.
  math::Vec3 look{0.0f};
  std::string description{};
};

// An entity that fires its targets when something else fires it, such as a trigger_relay.
struct Relay {
  std::string target{}, kill_target{}, target_name{};
};

// A tour stop: an info_notnull named stop1, stop2, ... Game code ignores it; README.md lists its keys.
struct Stop {
  int number = 0;
  math::Vec3 at{0.0f};
  // Pitch (positive down) and yaw.
  math::Vec3 look_deg{0.0f};
  double stay_s = 0;
  // Selects the weapon that is fired there; 0: does not fire.
  int impulse = 0;
  // The player first presses the button with this target; empty: none.
  std::string presses{};
};

// A brush model that never moves, such as a func_wall or a button.
struct StaticModel {
  world::ModelIndex model{};
  math::Vec3 origin{0.0f};
};

struct LevelFacts {
  std::vector<Mover> movers;
  std::vector<Trigger> triggers;
  std::vector<Activator> activators;
  std::vector<Relay> relays;
  std::vector<StaticModel> static_models;
  // Boxes that block players, such as explosive boxes.
  std::vector<math::Bounds> static_boxes;
  // Entities of the trigger_secrets.
  std::vector<vm::EntityIndex> secrets;
  // In order of their numbers.
  std::vector<Stop> stops;

  // Returns the mover that this entity is a part of; -1 if there is none.
  int find_mover(vm::EntityIndex entity) const;
};

// Reads the level of a game. Call at least a few tenths of a second after its start, because doors are linked
// in a think function 0.1 s after they spawn.
LevelFacts read_level_facts(server::Game& io_game);

std::string class_name(server::Game& io_game, vm::EntityIndex entity);
// Returns classname and center, for messages: "monster_dog at 10 20 30".
std::string describe(server::Game& io_game, vm::EntityIndex entity);
math::Vec3 box_center(const math::Bounds& box);
// Returns an entity's box in the world: its mins and maxs at its origin.
math::Bounds entity_box(const server::Edict& edict);
// Returns whether two boxes overlap or touch.
bool boxes_overlap(const math::Bounds& a, const math::Bounds& b);

}  // namespace temblor::player
