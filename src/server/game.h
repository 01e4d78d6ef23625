// One level that is being played: a QuakeC machine, its entities, and everything that they send to clients.
// Another level is another Game. Players' parameters and the server flags are carried over from one to the
// next. A Game knows no network: it gets players' input in tick(), and leaves messages in its outbox and
// wishes to the server in requests(). After QuakeC has failed, a Game can only be looked at and destroyed.
//    server ticks:   tick(inputs) -> StartFrame, think and move of every entity -> outbox(), requests()
// A game is deterministic: the same setup, seed and inputs give the same state_hash().
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "assets/library.h"
#include "assets/mission_pack.h"
#include "base/result.h"
#include "command/variables.h"
#include "net/protocol/protocol.h"
#include "server/builtins/builtins.h"
#include "server/game/baselines.h"
#include "server/game/game_world.h"
#include "server/game/outbox.h"
#include "server/game/spawn_entities.h"
#include "server/physics/physics.h"
#include "server/system_globals.h"
#include "vm/machine.h"

namespace temblor::server {

using SpawnParameters = std::array<float, global::kParmCount>;

enum class GameKind { kSingle, kCooperative, kDeathmatch };

struct GameSetup {
  std::shared_ptr<const vm::Program> program;
  std::shared_ptr<const world::Level> level;
  std::uint64_t level_hash = 0;  // of what a running game depends on, to see whether it has changed
  std::string map_name;          // "e1m1"
  net::Dialect dialect{};
  std::uint32_t max_clients = 1;
  GameKind kind = GameKind::kSingle;
  int skill = 1;
  float server_flags = 0;
  std::uint64_t seed = 1;  // of the game's random numbers
  double tick_s = 1.0 / 72;
  math::PhysicsSettings settings{};
  vm::Limits limits{};
  std::shared_ptr<const formats::Localization> localization{};  // null: there are no localized texts
};

// The services of the server that runs a game. All of them must outlive the game.
struct GameServices {
  const assets::Library& library;
  command::Variables& io_variables;
  std::function<void(std::string_view text)> print;  // to the host's console
  std::filesystem::path data_folder{};               // of files that QuakeC writes; empty: it may not write
  // Whether a client has this slot or is about to join in it. Without the function, active players have.
  std::function<bool(std::size_t slot)> has_client{};
};

// A player's input for one tick.
struct PlayerInput {
  bool is_active = false;  // the player is in the game, and moves in this tick
  PlayerCommand command{};
  std::uint8_t buttons = 0;  // 1 attack, 2 jump
  std::uint8_t impulse = 0;  // 0: none
};

class Game {
 public:
  // Sets the level up: spawns its entities, plays two ticks of 0.1 s, and takes baselines. Fails if QuakeC
  // does, or if the program was not compiled for Quake.
  static base::Result<std::unique_ptr<Game>> start(GameSetup setup, GameServices services);
  // The same without the entities, which a saved game brings along.
  static base::Result<std::unique_ptr<Game>> prepare(GameSetup setup, GameServices services);

  ~Game();
  Game(const Game&) = delete;
  Game& operator=(const Game&) = delete;

  // Plays one tick: applies players' input, then runs physics. `inputs`: one per client slot. Fails if QuakeC
  // does.
  base::Status tick(std::span<const PlayerInput> inputs);
  // Plays one move of this player alone, before the next tick: it has moves to catch up on. Other entities do
  // not move, and time does not pass for them.
  base::Status play_move(std::size_t slot, const PlayerInput& input);

  // --- Players, by slot (0 to max_clients - 1).
  // A view of the player's entity; valid until the number of entities changes.
  Edict player(std::size_t slot) { return world_.edicts[player_index(slot)]; }
  static vm::EntityIndex player_index(std::size_t slot) { return base::to_index<vm::EntityIndex>(slot + 1); }
  // The parameters that a new player starts with (SetNewParms).
  base::Result<SpawnParameters> new_parameters();
  // The parameters that this player takes along to the next level (SetChangeParms).
  base::Result<SpawnParameters> parameters_to_carry(std::size_t slot);
  // Puts a player into the level: clears its entity, and calls ClientConnect and PutClientInServer.
  base::Status spawn_client(std::size_t slot, const SpawnParameters& parameters, std::string_view name,
                            std::uint8_t colors);
  // Calls ClientDisconnect. A bot's slot is free afterward.
  base::Status disconnect_client(std::size_t slot);
  // Bots are clients that QuakeC plays (spawnclient). It writes their movement, v_angle, buttons and impulse.
  // Their names and colors are in their netname and clientcolors fields.
  bool is_bot(std::size_t slot) const { return bots_[slot]; }
  std::uint8_t bot_colors(std::size_t slot);
  // Keeps the bots of a game that this one continues.
  void adopt_bots(const Game& from) { bots_ = from.bots_; }
  // Calls ClientKill: the player asked to die.
  base::Status kill(std::size_t slot);
  // `colors`: shirt << 4 | pants. The pants are the team.
  base::Status set_player_look(std::size_t slot, std::string_view name, std::uint8_t colors);

  GameWorld& world() { return world_; }
  const GameWorld& world() const { return world_; }
  vm::Machine& machine() { return machine_; }
  const vm::Machine& machine() const { return machine_; }
  Outbox& outbox() { return outbox_; }
  const Outbox& outbox() const { return outbox_; }
  // Names of sounds, by number. Models are in world().
  Precache& precache() { return precache_; }
  Requests& requests() { return requests_; }
  BuiltinContext& context() { return context_; }
  const GameSetup& setup() const { return setup_; }
  // The result of spawning the level's entities; empty in a game from prepare().
  const SpawnReport& spawn_report() const { return spawn_report_; }
  double time_s() const { return world_.time_s; }
  float server_flags() const { return machine_.global_float(global::kServerFlags); }
  // Where the signon (Outbox::signon) may be split: ends of whole messages, in rising order.
  const std::vector<std::size_t>& signon_ends() const { return signon_ends_; }
  // The parameters with which this player entered the level.
  const SpawnParameters& spawn_parameters(std::size_t slot) const { return context_.spawn_parameters[slot]; }
  const world::LightStylePatterns& light_styles() const { return context_.light_styles; }
  // Restores light styles and the first player's parameters from a saved game.
  void restore_environment(const world::LightStylePatterns& styles, const SpawnParameters& parameters);
  // The mission packs' second set of items, if the program declares it.
  std::optional<Field<float>> items2_field() const { return items2_field_; }
  // By the game folders.
  assets::MissionPack mission_pack() const { return mission_pack_; }
  // After a failure: the player on whose behalf QuakeC ran, if there was one.
  std::optional<std::size_t> blamed_player() const;
  // Replaces the key of a localized text ("$map_start") by the text.
  std::string localize(std::string_view text) const;
  // Fields with which the program changes how entities look (alpha, scale).
  const LookFields& look_fields() const { return look_fields_; }
  // A hash of the whole state. Equal seeds and inputs give equal hashes. `out_entities`: if not null, the
  // hashes of all entities, by number.
  std::uint64_t state_hash(std::vector<std::uint32_t>* out_entities = nullptr) const;

 private:
  class Calls;
  Game(GameSetup setup, GameServices services);

  base::Status set_up_world();
  base::Status spawn_level();
  void apply_input(std::size_t slot, const PlayerInput& input);
  void apply_bot_input(std::size_t slot);
  BotServices bot_services();
  base::Result<vm::EntityIndex> spawn_bot();
  base::Status drop_player(std::size_t slot);
  PlayerType player_type(std::size_t slot) const;
  TickFunctions tick_functions() const;
  void send_sounds();
  void send_sound(const PhysicsSound& sound);
  void mark_signon_end();
  SpawnParameters parameters() const;
  base::Status call(vm::GlobalIndex function, vm::EntityIndex self);

  GameSetup setup_;
  GameServices services_;
  vm::Machine machine_;
  std::unique_ptr<Calls> calls_;
  GameWorld world_;
  Outbox outbox_;
  Precache precache_;
  Requests requests_;
  GameRandom random_;
  BuiltinContext context_;
  assets::MissionPack mission_pack_;
  std::optional<Field<float>> items2_field_;
  LookFields look_fields_;
  SpawnReport spawn_report_;
  std::vector<std::size_t> signon_ends_;
  std::optional<Field<math::Vec3>> movement_field_;  // bots' wishes to move
  std::optional<Field<float>> client_colors_field_;
  std::array<bool, net::kMaxClients> active_players_{}, bots_{};
};

}  // namespace temblor::server
