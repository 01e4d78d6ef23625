// The server's console variables, under their stock names. The getters return them in the units that the
// server uses (seconds, for example, where players type minutes), so that no other part reads variables by
// name. Values are clamped to the ranges of registration by command::Variables.
#pragma once

#include <string>

#include "command/variables.h"
#include "server/game.h"
#include "server/game/game_world.h"

namespace temblor::server {

class ServerVariables {
 public:
  // Registers the variables. `io_variables` must outlive this object.
  explicit ServerVariables(command::Variables& io_variables);

  math::PhysicsSettings physics() const;
  GameKind kind(std::size_t max_clients) const;
  // Sets coop and deathmatch to match the running game, which may come from a save.
  void set_kind(GameKind kind) const;
  bool is_pausable() const;
  int skill() const;            // 0 to 3, rounded
  double tick_s() const;        // time of the clock from one tick to the next
  double world_tick_s() const;  // game time that passes in each tick
  float ideal_pitch_scale() const;
  // sv_reliableupdates: snapshots are sent as reliable messages. Only for demonstrations.
  bool has_reliable_updates() const;
  double max_rate_bytes_per_second() const;  // 0: no limit
  double autosave_s() const;                 // 0: never
  // sv_autoload: a dead player who fires continues from the last save.
  bool autoloads() const;
  // The protocol that the host has chosen. Empty: the one that the level needs.
  std::optional<net::Protocol> protocol() const;
  // The language of localized texts, from the next level on.
  const std::string& language() const;
  std::string host_name() const;
  // Seconds after which a silent client is dropped.
  float timeout_s() const;
  const std::string& rcon_password() const;
  bool cheats_allowed() const;
  // Tells game code whether the data is that of the registered game.
  void set_registered(bool is_registered) const;
  // sv_reload: program and level files are watched, and reloaded when they change on disk.
  bool reloads() const;

  command::Variables& variables() const { return *variables_; }
  // Names and values of the rules, as server browsers show them.
  std::vector<std::pair<std::string, std::string>> rules() const;
  // The running level's rules that were set since `version` of variables().
  std::vector<std::pair<std::string, std::string>> rules_changed_since(std::uint64_t version) const;

 private:
  command::Variables* variables_;
  command::VariableIndex gravity_, max_velocity_, friction_, edge_friction_, stop_speed_, accelerate_,
      max_speed_, no_step_;
  command::VariableIndex skill_, deathmatch_, coop_, tick_rate_, autosave_, autoload_, protocol_, host_name_,
      language_, timeout_, rcon_password_, cheats_, reload_, pausable_, frame_time_, ideal_pitch_scale_,
      reliable_updates_, max_rate_;
};

}  // namespace temblor::server
