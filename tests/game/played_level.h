// A level of the data, played by the server's Game in process and without a network: tests make players join
// and move, and run ticks. Errors of game code are kept with their traces.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "server/game/game_loader.h"

namespace temblor::test {

inline const std::filesystem::path kProgs = std::filesystem::path(TEMBLOR_GAMES) / "id1/progs.dat";
constexpr std::uint8_t kAttack = 1, kJump = 2;  // PlayerInput::buttons

struct PlayedSettings {
  int skill = 1;
  server::GameKind kind = server::GameKind::kSingle;
  std::uint32_t players = 1;
  // Variables that the level reads when it begins.
  std::vector<std::pair<std::string, std::string>> rules = {};
};

class PlayedLevel {
 public:
  // Spawns all entities, but no players. CHECKs that the files exist and that game code does not fail.
  PlayedLevel(const std::filesystem::path& data, std::string_view map, const std::filesystem::path& progs,
              const PlayedSettings& settings = {});

  // Errors of game code so far, with traces.
  const std::vector<std::string>& errors() const { return errors_; }
  // Keys and classes of the level that game code does not know.
  const std::vector<std::string>& notes() const { return game_->spawn_report().notes; }
  const std::vector<std::string>& unknown_classes() const { return game_->spawn_report().unknown_classes; }
  // Text on the server's console: dprint, and warnings about game code.
  const std::string& printed() const { return printed_; }
  // Reliable messages to all clients (bprint and others), as raw bytes.
  const std::string& said() const { return said_; }
  // Reliable messages to one player (sprint, stuffcmd and others), as raw bytes.
  const std::string& sent_to(std::uint32_t slot) { return sent_[slot]; }
  std::optional<std::string> change_level() const { return game_->requests().change_level; }
  const std::string& commands() const { return game_->requests().commands; }

  void join(std::uint32_t slot);
  // Sets a variable of the server.
  void set(std::string_view variable, std::string_view value);
  // Whether clients are sent this sound before the level begins.
  bool has_sound(std::string_view name) const;
  bool is_bot(std::uint32_t slot) const { return game_->is_bot(slot); }
  server::PlayerInput& input(std::uint32_t slot) { return inputs_[slot]; }
  void tick();
  void run(double seconds);

  server::Edict player(std::uint32_t slot) { return game_->player(slot); }
  server::Edict edict(std::uint32_t number) { return world().edicts[vm::EntityIndex{number}]; }
  std::uint32_t edict_count() const { return game_->world().edicts.count(); }
  bool is_free(std::uint32_t number) { return world().edicts.is_free(vm::EntityIndex{number}); }
  std::string text(vm::StringIndex index) const { return std::string(game_->machine().text(index)); }
  // Numbers of the entities of this class.
  std::vector<std::uint32_t> of_class(std::string_view name);
  float global(std::string_view name) const;
  // A field that only this program declares.
  float edict_number(std::uint32_t number, std::string_view field_name);
  // The name of the function in such a field.
  std::string edict_function(std::uint32_t number, std::string_view field_name);
  double variable(std::string_view name) const { return variables_.find(name)->number; }
  double time_s() const { return game_->time_s(); }
  std::uint64_t state_hash() const { return game_->state_hash(); }

  // Moves an entity to another place, links it, and touches the triggers there.
  void put(server::Edict edict, const math::Vec3& origin);
  // Spawns an entity of this class as if it were part of the level, and runs until it has settled.
  std::uint32_t spawn(std::string_view name, const math::Vec3& origin, float yaw_deg);
  // Whether nothing solid is between the eyes of two entities.
  bool sees(std::uint32_t watcher, std::uint32_t other);
  // Whether a box of this size has room at a place, and floor below it.
  bool has_room(const math::Vec3& origin, const math::Vec3& mins, const math::Vec3& maxs);
  // Calls a function of the program as the engine would.
  void call_function(std::string_view name, vm::EntityIndex self, vm::EntityIndex other = vm::kWorld);
  // Calls game code's hurt(): one entity damages another.
  void hurt(std::uint32_t number, std::uint32_t by, float damage);
  // Uses an entity, as if a player or another entity had done it.
  void use(std::uint32_t number, std::uint32_t by);
  void touch(std::uint32_t number, std::uint32_t by);

 private:
  server::GameWorld& world() { return game_->world(); }
  void call(vm::FunctionIndex function, vm::EntityIndex self, vm::EntityIndex other, std::string_view doing);
  void check(const base::Status& status, std::string_view doing);

  assets::Library library_;
  command::Variables variables_;
  server::ServerVariables settings_;
  std::unique_ptr<server::Game> game_;
  std::vector<server::PlayerInput> inputs_;
  std::string printed_, said_;
  std::map<std::uint32_t, std::string> sent_;
  std::vector<std::string> errors_;
};

}  // namespace temblor::test
