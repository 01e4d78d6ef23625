// One level being played: its program's machine, its entities, and all that they say. A change of level is a
// new Game; what is carried over (players' parameters, server flags) is given to it.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "assets/library.h"
#include "base/result.h"
#include "command/variables.h"
#include "net/protocol/protocol.h"
#include "server/builtins/builtins.h"
#include "server/game/spawn_entities.h"
#include "server/game_world.h"
#include "server/physics/physics.h"
#include "server/session/baselines.h"
#include "server/session/outbox.h"
#include "server/system_globals.h"
#include "vm/machine.h"

namespace temblor::server {

using SpawnParameters = std::array<float, global::kParmCount>;

enum class GameKind { kSingle, kCooperative, kDeathmatch };

struct GameSetup {
  std::shared_ptr<const vm::Program> program;
  std::shared_ptr<const world::Level> level;
  std::uint64_t level_hash = 0;  // of its file: whether two are the same
  std::string map_name;          // "e1m1"
  net::Dialect dialect{};
  std::uint32_t max_clients = 1;
  GameKind kind = GameKind::kSingle;
  int skill = 1;
  float server_flags = 0;
  std::uint64_t seed = 1;  // of the game's dice
  double tick_s = 1.0 / 72;
  PhysicsSettings settings{};
  vm::Limits limits{};
};

// What a game uses of the server around it; all of it must outlive the game.
struct GameServices {
  const assets::Library& library;
  command::Variables& io_variables;
  std::function<void(std::string_view text)> print;
  std::filesystem::path data_folder{};
  // Whether a client has this place or is on its way to it. None: those that are active have.
  std::function<bool(std::size_t slot)> has_client{};
};

// What a player's client asked for since the last tick.
struct PlayerInput {
  bool is_active = false;  // is in the game
  PlayerCommand command{};
  std::uint8_t buttons = 0;  // 1 attack, 2 jump
  std::uint8_t impulse = 0;  // 0: none
};

class Game {
 public:
  // Sets the level up: entities spawned, two ticks of 0.1 s played, baselines taken. Fails where QuakeC fails
  // or the program is not for Quake.
  static base::Result<std::unique_ptr<Game>> start(GameSetup setup, GameServices services);
  // The same up to the spawning of entities, which a saved game brings with it.
  static base::Result<std::unique_ptr<Game>> prepare(GameSetup setup, GameServices services);

  ~Game();
  Game(const Game&) = delete;
  Game& operator=(const Game&) = delete;

  // One tick: players' input, then physics. `inputs`: one for each client slot.
  base::Status tick(std::span<const PlayerInput> inputs);
  // A tick of this player alone, before the next one of all: he has something to catch up on.
  base::Status play_move(std::size_t slot, const PlayerInput& input);

  // --- Players, by slot (0 to max_clients - 1)
  Edict player(std::size_t slot) { return world_.edicts[player_index(slot)]; }
  static vm::EntityIndex player_index(std::size_t slot) { return base::to_index<vm::EntityIndex>(slot + 1); }
  // SetNewParms: what a player has who comes from nowhere.
  base::Result<SpawnParameters> new_parameters();
  // SetChangeParms: what this player takes along to the next level.
  base::Result<SpawnParameters> parameters_to_carry(std::size_t slot);
  // Puts a player into the level: ClientConnect and PutClientInServer, on an entity that is cleared first.
  base::Status put_in(std::size_t slot, const SpawnParameters& parameters, std::string_view name,
                      std::uint8_t colors);
  // ClientDisconnect; a bot is none afterwards.
  base::Status take_out(std::size_t slot);
  // Clients that the program plays (spawnclient), by slot: it writes their movement, v_angle, buttons and
  // impulse; name and colors are those of their netname and clientcolors.
  bool is_bot(std::size_t slot) const { return bots_[slot]; }
  std::uint8_t bot_colors(std::size_t slot);
  // That play on in this game, of one that it goes on from.
  void take_over_bots(const Game& from) { bots_ = from.bots_; }
  // ClientKill
  base::Status kill(std::size_t slot);
  // colors: shirt << 4 | pants; the pants are the team.
  base::Status set_player_look(std::size_t slot, std::string_view name, std::uint8_t colors);

  GameWorld& world() { return world_; }
  const GameWorld& world() const { return world_; }
  vm::Machine& machine() { return machine_; }
  const vm::Machine& machine() const { return machine_; }
  Outbox& outbox() { return outbox_; }
  const Outbox& outbox() const { return outbox_; }
  Precache& precache() { return precache_; }
  Requests& requests() { return requests_; }
  BuiltinContext& context() { return context_; }
  const GameSetup& setup() const { return setup_; }
  const SpawnReport& spawn_report() const { return spawn_report_; }
  double time_s() const { return world_.time_s; }
  float server_flags() const { return machine_.global_float(global::kServerFlags); }
  // Where signon bytes may be cut: ends of whole messages, rising; the last is the end of all.
  const std::vector<std::size_t>& signon_ends() const { return signon_ends_; }
  // What a player came into the level with.
  const SpawnParameters& spawn_parameters(std::size_t slot) const { return context_.spawn_parameters[slot]; }
  const world::LightStylePatterns& light_styles() const { return context_.light_styles; }
  // From a saved game: the first player's.
  void restore_environment(const world::LightStylePatterns& styles, const SpawnParameters& parameters);
  std::optional<Field<float>> items2_field() const { return items2_field_; }
  // After a failure: the player on whose behalf QuakeC ran, if it was one's.
  std::optional<std::size_t> blamed_player() const;
  const LookFields& look_fields() const { return look_fields_; }
  // Of everything that the game goes on from: the same inputs give the same.
  std::uint64_t state_hash() const;

 private:
  class Calls;
  Game(GameSetup setup, GameServices services);

  base::Status set_up_world();
  base::Status spawn_level();
  void take_input(std::size_t slot, const PlayerInput& input);
  void take_bot_input(std::size_t slot);
  PlayerPlaces player_places();
  base::Result<vm::EntityIndex> spawn_bot();
  base::Status drop_player(std::size_t slot);
  PlayerType type_of_player(std::size_t slot) const;
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
  std::optional<Field<float>> items2_field_;
  LookFields look_fields_;
  SpawnReport spawn_report_;
  std::vector<std::size_t> signon_ends_;
  std::optional<Field<math::Vec3>> movement_field_;  // of bots
  std::optional<Field<float>> client_colors_field_;
  std::array<bool, net::kMaxClients> active_players_{}, bots_{};
};

}  // namespace temblor::server
