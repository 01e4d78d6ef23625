// Starts a game from a level's name: reads the files, loads the program, and chooses the protocol.
//    maps/NAME.bsp, progs.dat (+ progs.lno) --> Game in protocol 15 --> room for everything? --> LoadedGame
//                                                    ^                      | no
//                                                    +--- 666, then 999 <---+
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
  // How many entities a saved game contains. The protocol must have room for them.
  std::size_t min_entities = 0;
  // Without a protocol in the settings: the oldest one to use. Newer ones have finer positions and angles and
  // more entities, but stock clients may not speak them.
  net::Protocol oldest_protocol = net::Protocol::kNetQuake;
};

struct LoadedGame {
  std::unique_ptr<Game> game;
  std::vector<std::string> notes;  // for the host, one line each
  std::string entities_file;       // in messages
};

// Loads maps/MAP.bsp and progs.dat, and sets the game up. The protocol is the one in `settings`, or the
// oldest from GameRequest::oldest_protocol on that has room for all models, sounds, and entities, for
// translucent and scaled ones, and for places past +-4095 units. Errors name the file.
base::Result<LoadedGame> load_game(const GameRequest& request, const ServerVariables& settings,
                                   const GameServices& services);

}  // namespace temblor::server
