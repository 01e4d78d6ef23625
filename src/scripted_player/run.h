// A level played from its start to its exit, and what is said of it.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "scripted_player/decisions/brain.h"
#include "scripted_player/session.h"

namespace temblor::player {

struct RunSetup {
  SessionSetup session;
  bool has_god = false;
  bool visits_secrets = false;
  bool visits_stops = false;  // that the level names for visitors, first
  bool fights = true;
  bool records = false;
  double limit_s = 600;  // of the game's time
  std::vector<math::Vec3> waypoints{};
  std::string exit_map{};
  bool lists_places = false;
  std::function<void(std::string_view line)> tell{};  // once a few seconds; may be empty
};

struct RunReport {
  bool is_deathmatch = false;  // which has no exit
  bool reached_exit = false;
  std::string exit;  // the level that it leads to
  double time_s = 0;
  int kills = 0, monsters = 0, found_secrets = 0, secrets = 0;
  int frags = 0;  // the first player's
  std::vector<std::string> deaths;
  std::vector<std::string> complaints;       // why it ended without an exit; secrets that were not reached
  std::vector<std::string> stuck_monsters;   // in walls
  std::vector<std::string> idle_monsters;    // stood still in a fight
  std::vector<std::string> closed_doors;     // never opened
  std::vector<std::string> unreached_items;  // that no way leads to
  std::vector<std::string> errors;           // of the game's code
  std::size_t places = 0, ways = 0;
  std::string place_list{};      // a line each: where a player can get, and what he stands on
  std::uint64_t state_hash = 0;  // of the game's end
  base::ByteVector recording;
};

// A deathmatch (setup.session.bots) has no exit: it is played until the limit, from item to item.
// Errors are those of files; a level that cannot be played to its end is a report.
base::Result<RunReport> play_level(const RunSetup& setup);

std::string as_json(const RunReport& report);
std::string as_text(const RunReport& report);

}  // namespace temblor::player
