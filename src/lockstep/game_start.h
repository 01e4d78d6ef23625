// Everything that decides how a lockstep game begins. Peers with equal starts and equal inputs play the same
// game. The host of a game makes the start and sends it to the others; a replay contains it, too.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "assets/library.h"
#include "base/bytes.h"
#include "base/result.h"
#include "command/variables.h"

namespace temblor::lockstep {

constexpr std::size_t kMaxPlayers = 4;

struct GameStart {
  std::string program_version;  // of the engine: others may simulate differently
  std::string map;              // "e1m1"
  std::uint64_t seed = 1;
  std::uint8_t players = 1;  // 1 to kMaxPlayers
  std::uint8_t slots = 1;    // for players and bots; at least `players`
  // An input takes effect this many ticks after the client gave it, so that it has time to reach all peers.
  std::uint8_t delay_ticks = 0;
  std::uint64_t code_hash = 0, level_hash = 0;  // of progs.dat and the first level's file
  // The server's variables that differ from their defaults.
  std::vector<std::pair<std::string, std::string>> variables{};
};

// Fills in the hashes. `program_file`: see server::ServerSetup. Fails if there is no such level or code.
base::Status hash_files(const assets::Library& library, const std::filesystem::path& program_file,
                        GameStart& io_start);
// Fails with kUnsupported, and one line for the player, if this game has other files or another version.
base::Status check_files(const assets::Library& library, const std::filesystem::path& program_file,
                         std::string_view program_version, const GameStart& start);

// Copies the values of the server's variables that are not the defaults from the host's variables. Those that
// would write files are left out.
std::vector<std::pair<std::string, std::string>> list_server_variables(const command::Variables& variables);

void write_start(const GameStart& start, base::ByteWriter& io_writer);
base::Result<GameStart> read_start(base::ByteReader& io_reader);

}  // namespace temblor::lockstep
