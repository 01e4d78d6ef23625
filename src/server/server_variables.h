// The server's console variables, by their stock names.
#pragma once

#include <string>

#include "command/variables.h"
#include "server/game.h"
#include "server/game_world.h"

namespace temblor::server {

class ServerVariables {
 public:
  // Registers them. `io_variables` must outlive this.
  explicit ServerVariables(command::Variables& io_variables);

  PhysicsSettings physics() const;
  GameKind kind(std::size_t max_clients) const;
  // Sets coop and deathmatch to what a game is.
  void set_kind(GameKind kind) const;
  bool is_pausable() const;
  int skill() const;            // 0 to 3
  double tick_s() const;        // of the clock, from one step to the next
  double world_tick_s() const;  // that a step moves the world on
  float ideal_pitch_scale() const;
  bool has_reliable_updates() const;
  double max_rate_bytes_per_second() const;  // 0: no limit
  double autosave_s() const;                 // 0: never
  bool autoloads() const;
  // Nothing: chosen by what the level needs.
  std::optional<net::Protocol> protocol() const;
  std::string host_name() const;
  float timeout_s() const;
  const std::string& rcon_password() const;
  bool cheats_allowed() const;
  bool reloads() const;

  command::Variables& variables() const { return *variables_; }
  // Names and values that the server tells who asks for its rules.
  std::vector<std::pair<std::string, std::string>> rules() const;
  // Those of the level that is played which were set since `version` of variables().
  std::vector<std::pair<std::string, std::string>> rules_changed_since(std::uint64_t version) const;

 private:
  command::Variables* variables_;
  command::VariableIndex gravity_, max_velocity_, friction_, edge_friction_, stop_speed_, accelerate_,
      max_speed_, no_step_;
  command::VariableIndex skill_, deathmatch_, coop_, tick_rate_, autosave_, autoload_, protocol_, host_name_,
      timeout_, rcon_password_, cheats_, reload_, pausable_, frame_time_, ideal_pitch_scale_,
      reliable_updates_, max_rate_;
};

}  // namespace temblor::server
