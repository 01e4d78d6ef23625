// A level of the data played with a program, in process and without a network: entities spawned, players
// joined and moved, ticks run. What goes wrong in the program is kept, with its trace.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "assets/library.h"
#include "formats/entities.h"
#include "server/builtins.h"
#include "server/physics.h"
#include "server/system_globals.h"

namespace temblor::test {

struct PlayedSettings {
  float skill = 1, deathmatch = 0, coop = 0;
  std::uint32_t players = 1;
};

class PlayedLevel final : server::GameCalls {
 public:
  // Spawns everything; players are not in yet. CHECKs that the files are there.
  PlayedLevel(const std::filesystem::path& data, std::string_view map, const std::filesystem::path& progs,
              const PlayedSettings& settings = {});
  PlayedLevel(const PlayedLevel&) = delete;
  PlayedLevel& operator=(const PlayedLevel&) = delete;

  // Errors of the program so far, with traces; classes without a spawn function.
  const std::vector<std::string>& errors() const { return errors_; }
  // What the program printed on the server's console (dprint, and complaints about it).
  const std::string& printed() const { return printed_; }
  // What it told all clients, certainly: bprint, as the bytes lie.
  const std::string& said() const { return said_; }
  std::optional<std::string> change_level() const { return requests_.change_level; }
  const std::string& commands() const { return requests_.commands; }

  void join(std::uint32_t slot);
  server::PlayerCommand& command(std::uint32_t slot) { return commands_[slot]; }
  void tick();
  void run(double seconds);

  server::Edict player(std::uint32_t slot) { return world_.edicts[vm::EntityIndex{slot + 1}]; }
  server::Edict edict(std::uint32_t number) { return world_.edicts[vm::EntityIndex{number}]; }
  std::uint32_t edict_count() const { return world_.edicts.count(); }
  bool is_free(std::uint32_t number) { return world_.edicts.is_free(vm::EntityIndex{number}); }
  std::string text(vm::StringIndex index) const { return std::string(machine_.text(index)); }
  // Numbers of the entities of that class.
  std::vector<std::uint32_t> of_class(std::string_view name);
  float global(std::string_view name) const;
  // A field of the game's own.
  float edict_number(std::uint32_t number, std::string_view field_name);
  double variable(std::string_view name) const { return variables_.find(name)->number; }
  double time_s() const { return world_.time_s; }
  // To another place, linked, touching what is there.
  void put(server::Edict edict, const math::Vec3& origin);
  // An entity of that class, as if the level had it; it is there after its own first moments.
  std::uint32_t spawn(std::string_view name, const math::Vec3& origin, float yaw_deg);
  // Whether a box of that size has room at a place and floor below.
  bool has_room(const math::Vec3& origin, const math::Vec3& mins, const math::Vec3& maxs);
  // As the engine or another entity would.
  void call_function(std::string_view name, vm::EntityIndex self, vm::EntityIndex other = vm::kWorld);
  // The game's own hurt(): one loses health to another.
  void hurt(std::uint32_t number, std::uint32_t by, float damage);
  // As if a player or another entity had done it.
  void use(std::uint32_t number, std::uint32_t by);
  void touch(std::uint32_t number, std::uint32_t by);
  // Of all entities.
  std::vector<std::uint32_t> all_words();

 private:
  base::Status call(vm::FunctionIndex function, vm::EntityIndex self, vm::EntityIndex other,
                    double time_s) override;
  void add_variables(const PlayedSettings& settings);
  void spawn_entities(const PlayedSettings& settings);
  void spawn_entity(const formats::Entity& keys, vm::EntityIndex index);
  void set_key(server::Edict edict, std::string_view key, std::string_view value);
  void check(const base::Status& status, std::string_view doing);
  vm::FunctionIndex system_function(vm::GlobalIndex index) const { return machine_.global_function(index); }

  assets::Library library_;
  std::shared_ptr<const world::Level> level_;
  std::shared_ptr<const vm::Program> program_;
  vm::Machine machine_;
  server::GameWorld world_;
  server::Outbox outbox_;
  server::Precache precache_;
  server::Requests requests_;
  server::GameRandom random_;
  command::Variables variables_;
  server::BuiltinContext context_;
  std::vector<server::PlayerCommand> commands_;
  std::vector<char> active_;
  std::string printed_, said_;
  std::vector<std::string> errors_;
};

}  // namespace temblor::test
