#include "lockstep/game_start.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/hash.h"
#include "lockstep/peers/text_field.h"
#include "server/server_variables.h"
#include "vfs/disk.h"

namespace temblor::lockstep {
namespace {

constexpr std::uint64_t kMaxProgramBytes = 64 << 20;
constexpr std::size_t kMaxVariables = 256;

base::Result<std::uint64_t> hash_program(const assets::Library& library,
                                         const std::filesystem::path& program_file) {
  TRY(const base::ByteVector bytes, program_file.empty()
                                        ? library.files().read("progs.dat")
                                        : vfs::read_disk_file(program_file, kMaxProgramBytes));
  return base::hash_bytes(bytes);
}

base::Result<std::uint64_t> hash_level(const assets::Library& library, const std::string& map) {
  TRY(const base::ByteVector bytes, library.files().read(fmt::format("maps/{}.bsp", map)));
  return base::hash_bytes(bytes);
}

}  // namespace

base::Status hash_files(const assets::Library& library, const std::filesystem::path& program_file,
                        GameStart& io_start) {
  TRY(io_start.code_hash, hash_program(library, program_file));
  TRY(io_start.level_hash, hash_level(library, io_start.map));
  return base::Ok{};
}

base::Status check_files(const assets::Library& library, const std::filesystem::path& program_file,
                         std::string_view program_version, const GameStart& start) {
  if (start.program_version != program_version)
    return base::error(base::ErrorCode::kUnsupported, "the game needs {}, and this is {}",
                       start.program_version, program_version);
  GameStart own = start;
  TRY_STATUS(hash_files(library, program_file, own));
  if (own.code_hash != start.code_hash)
    return base::error(base::ErrorCode::kUnsupported, "the game's progs.dat is not the one here");
  if (own.level_hash != start.level_hash)
    return base::error(base::ErrorCode::kUnsupported, "the game's level {} is not the one here", start.map);
  return base::Ok{};
}

std::vector<std::pair<std::string, std::string>> list_server_variables(const command::Variables& variables) {
  constexpr std::array<std::string_view, 4> kOfThisMachine = {"sv_autosave", "sv_autoload", "sv_reload",
                                                              "rcon_password"};
  command::Variables server_variables;
  const server::ServerVariables registered(server_variables);
  std::vector<std::pair<std::string, std::string>> values;
  for (const command::Variable* variable : server_variables.all()) {
    const command::Variable* const set = variables.find(variable->name);
    const bool is_skipped = std::ranges::find(kOfThisMachine, variable->name) != kOfThisMachine.end();
    if (set != nullptr && !is_skipped && set->text != variable->text)
      values.emplace_back(variable->name, set->text);
  }
  return values;
}

void write_start(const GameStart& start, base::ByteWriter& io_writer) {
  write_text(start.program_version, io_writer);
  write_text(start.map, io_writer);
  io_writer.write(start.seed);
  io_writer.u8(start.players);
  io_writer.u8(start.slots);
  io_writer.u8(start.delay_ticks);
  io_writer.write(start.code_hash);
  io_writer.write(start.level_hash);
  io_writer.u16(static_cast<std::uint16_t>(start.variables.size()));
  for (const auto& [name, value] : start.variables) {
    write_text(name, io_writer);
    write_text(value, io_writer);
  }
}

base::Result<GameStart> read_start(base::ByteReader& io_reader) {
  GameStart start;
  start.program_version = read_text(io_reader);
  start.map = read_text(io_reader);
  start.seed = io_reader.read<std::uint64_t>();
  start.players = io_reader.u8();
  start.slots = io_reader.u8();
  start.delay_ticks = io_reader.u8();
  start.code_hash = io_reader.read<std::uint64_t>();
  start.level_hash = io_reader.read<std::uint64_t>();
  const std::size_t variables = io_reader.u16();
  if (variables > kMaxVariables) return base::malformed("the start of the game has {} variables", variables);
  for (std::size_t i = 0; i < variables; ++i) {
    std::string name = read_text(io_reader);
    start.variables.emplace_back(std::move(name), read_text(io_reader));
  }
  if (!io_reader.ok()) return base::malformed("the start of the game is cut short");
  if (start.players < 1 || start.players > kMaxPlayers || start.slots < start.players)
    return base::malformed("the game has {} players and {} slots", start.players, start.slots);
  return start;
}

}  // namespace temblor::lockstep
