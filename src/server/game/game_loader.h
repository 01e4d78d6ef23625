// From a level's name to a game that runs: files, program, protocol.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "server/game.h"
#include "server/server_variables.h"

namespace temblor::server {

struct GameRequest {
  std::string map;  // "e1m1"
  GameKind kind = GameKind::kSingle;
  int skill = 1;
  float server_flags = 0;
  std::filesystem::path program_file{};  // empty: the game folders' progs.dat
  std::uint32_t max_clients = 1;
  std::uint64_t seed = 1;
  // Numbers of entities that a saved game will bring along; the protocol must have so many at least.
  std::size_t entities_to_come = 0;
};

struct LoadedGame {
  std::unique_ptr<Game> game;
  std::vector<std::string> notes;  // for the host's eyes, a line each
};

// maps/MAP.bsp with progs.dat, set up. The protocol is the one that `settings` ask for, or the oldest that
// can say everything: number of models, sounds and entities, places past +-4096 units. Errors name the file.
base::Result<LoadedGame> load_game(const GameRequest& request, const ServerVariables& settings,
                                   const GameServices& services);

}  // namespace temblor::server
