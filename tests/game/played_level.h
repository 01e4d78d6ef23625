// A level of the data played by the server's own game, in process and without a network: players joined and
// moved, ticks run. What goes wrong in the program is kept, with its trace.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "server/game/game_loader.h"

namespace temblor::test {

inline const std::filesystem::path kProgs = std::filesystem::path(TEMBLOR_GAMES) / "id1/progs.dat";
constexpr std::uint8_t kAttack = 1, kJump = 2;  // PlayerInput::buttons

struct PlayedSettings {
  int skill = 1;
  server::GameKind kind = server::GameKind::kSingle;
  std::uint32_t players = 1;
};

class PlayedLevel {
 public:
  // Spawns everything; players are not in yet. CHECKs that the files are there and the program gets that far.
  PlayedLevel(const std::filesystem::path& data, std::string_view map, const std::filesystem::path& progs,
              const PlayedSettings& settings = {});

  // Errors of the program so far, with traces.
  const std::vector<std::string>& errors() const { return errors_; }
  // Keys and classes of the level that the program does not know.
  const std::vector<std::string>& notes() const { return game_->spawn_report().notes; }
  const std::vector<std::string>& unknown_classes() const { return game_->spawn_report().unknown_classes; }
  // What the program printed on the server's console (dprint, and complaints about it).
  const std::string& printed() const { return printed_; }
  // What it told all clients, certainly: bprint and others, as the bytes lie.
  const std::string& said() const { return said_; }
  std::optional<std::string> change_level() const { return game_->requests().change_level; }
  const std::string& commands() const { return game_->requests().commands; }

  void join(std::uint32_t slot);
  // A variable of the server, from now on.
  void set(std::string_view variable, std::string_view value);
  bool is_bot(std::uint32_t slot) const { return game_->is_bot(slot); }
  server::PlayerInput& input(std::uint32_t slot) { return inputs_[slot]; }
  void tick();
  void run(double seconds);

  server::Edict player(std::uint32_t slot) { return game_->player(slot); }
  server::Edict edict(std::uint32_t number) { return world().edicts[vm::EntityIndex{number}]; }
  std::uint32_t edict_count() const { return game_->world().edicts.count(); }
  bool is_free(std::uint32_t number) { return world().edicts.is_free(vm::EntityIndex{number}); }
  std::string text(vm::StringIndex index) const { return std::string(game_->machine().text(index)); }
  // Numbers of the entities of that class.
  std::vector<std::uint32_t> of_class(std::string_view name);
  float global(std::string_view name) const;
  // A field of the game's own.
  float edict_number(std::uint32_t number, std::string_view field_name);
  double variable(std::string_view name) const { return variables_.find(name)->number; }
  double time_s() const { return game_->time_s(); }
  std::uint64_t state_hash() const { return game_->state_hash(); }

  // To another place, linked, touching what is there.
  void put(server::Edict edict, const math::Vec3& origin);
  // An entity of that class, as if the level had it; it is there after its own first moments.
  std::uint32_t spawn(std::string_view name, const math::Vec3& origin, float yaw_deg);
  // Whether a box of that size has room at a place and floor below.
  bool has_room(const math::Vec3& origin, const math::Vec3& mins, const math::Vec3& maxs);
  // As the engine would.
  void call_function(std::string_view name, vm::EntityIndex self, vm::EntityIndex other = vm::kWorld);
  // The game's own hurt(): one loses health to another.
  void hurt(std::uint32_t number, std::uint32_t by, float damage);
  // As if a player or another entity had done it.
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
  std::vector<std::string> errors_;
};

}  // namespace temblor::test
