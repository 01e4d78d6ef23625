// Plays a level from its start to its exit and reports what happened.
//
// A run starts a Session, builds the map of the level (navigation/level_map.h), gives every player a Brain,
// and then repeats: each brain turns the game's state into a move, the session plays one tick. It ends at an
// exit, at the time limit, or when all players have given up. A run is deterministic for a setup.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "scripted_player/decisions/brain.h"
#include "scripted_player/navigation/graph_cache.h"
#include "scripted_player/session/session.h"

namespace temblor::player {

struct RunSetup {
  SessionSetup session;
  // Players cannot be hurt. In games of several players, this needs SessionSetup::can_cheat.
  bool has_god = false;
  // Visit every trigger_secret before the exit.
  bool visits_secrets = false;
  // Visit the tour stops of the level, after the waypoints.
  bool visits_stops = false;
  bool fights = true;
  // Limit of game time.
  double limit_s = 600;
  // Places to visit first, in this order.
  std::vector<math::Vec3> waypoints{};
  // Take the exit to this level; empty: the cheapest to reach.
  std::string exit_map{};
  // Fill RunReport::place_list.
  bool lists_places = false;
  // Graphs of earlier runs, which may be the same; null: none.
  GraphCache* graphs = nullptr;
  // Called every few seconds of game time with each player's position and task; may be empty.
  std::function<void(std::string_view line)> on_status{};
  // Called before each tick with the level's time after it and the first player's place. The players see and
  // hear from the place that it returns. May be empty.
  std::function<std::optional<math::Vec3>(double time_s, const math::Vec3& player_world)> place_camera{};
};

struct RunReport {
  // A deathmatch has no exit; its run ends at the limit.
  bool is_deathmatch = false;
  bool reached_exit = false;
  // The level that the exit leads to.
  std::string exit;
  // Game time.
  double time_s = 0;
  int kills = 0, monsters = 0, found_secrets = 0, secrets = 0;
  // The first player's.
  int frags = 0;
  // Messages, one line each: killer and place of each death.
  std::vector<std::string> deaths;
  // Why it ended without an exit; secrets and stops that were not reached.
  std::vector<std::string> problems;
  // Monsters inside walls, and monsters that stood still in a fight.
  std::vector<std::string> stuck_monsters, idle_monsters;
  // Doors that no player opened.
  std::vector<std::string> closed_doors;
  // Items that no reachable place touches.
  std::vector<std::string> unreached_items;
  // Errors of the game code.
  std::vector<std::string> errors;
  // Size of the graph.
  std::size_t places = 0, links = 0;
  // One line per place: position, and what the player stands on.
  std::string place_list{};
  // Hash of the game's state at the end, to compare runs.
  std::uint64_t state_hash = 0;
  // A .dem file, if SessionSetup::records.
  base::ByteVector demo;
};

// Plays the level. A deathmatch (setup.session.bots > 0) has no exit; it is played until the limit, from item
// to item. Only problems with files are errors; a level that cannot be finished is a report.
base::Result<RunReport> play_level(const RunSetup& setup);

// A JSON object whose keys are the fields above.
std::string as_json(const RunReport& report);
// One line with the outcome and the counts, and then one indented line per message.
std::string as_text(const RunReport& report);

}  // namespace temblor::player
