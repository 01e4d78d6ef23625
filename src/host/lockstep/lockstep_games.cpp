#include "host/lockstep/lockstep_games.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/frame/host_parts.h"
#include "host/session/demos.h"
#include "host/session/games.h"
#include "lockstep/game_start.h"
#include "lockstep/play_replay.h"
#include "vfs/disk.h"

namespace temblor::host {
namespace {

constexpr int kMaxReplays = 10000;
constexpr std::uint64_t kMaxReplayBytes = 256 << 20;

// The host of the program owns the game, so the game may refer to it.
lockstep::SimulationSetup make_setup(Host& io_host) {
  return {.library = io_host.game.data->library,
          .program_file = io_host.options.program_file,
          .print = [&io_host](std::string_view text) { print_game_text(io_host, text); }};
}

void open_game(Host& io_host, std::unique_ptr<lockstep::LockstepGame> game) {
  stop_demo(io_host);
  io_host.game.session->open_lockstep(std::move(game), io_host.variables.player(), io_host.timing.now_s);
  io_host.stuffed_text.restore(io_host);
  io_host.console.ui.close();
  io_host.game.menu->close();
}

base::Result<std::unique_ptr<platform::DatagramSocket>> open_socket(const Host& host, std::uint16_t port) {
  if (!host.services.open_socket) return base::error(base::ErrorCode::kUsage, "no network is available");
  return host.services.open_socket(port);
}

// Bots need slots, too.
std::uint8_t count_slots(const command::Variables& variables, std::uint8_t players) {
  return std::max(players, static_cast<std::uint8_t>(variables.find("bot_fill")->number));
}

// In the write folder, unless the path leads elsewhere.
base::Result<base::ByteVector> read_replay_file(const Host& host, std::string_view file) {
  const base::Result<base::ByteVector> bytes =
      vfs::read_disk_file(host.game.data->write_folder / file, kMaxReplayBytes);
  return bytes.ok() ? bytes : vfs::read_disk_file(std::string(file), kMaxReplayBytes);
}

}  // namespace

base::Status host_lockstep(Host& io_host, std::string_view map, std::uint8_t players,
                           std::uint8_t delay_ticks) {
  lockstep::GameStart start{.program_version = io_host.options.version,
                            .map = std::string(map),
                            .seed = io_host.services.seed,
                            .players = players,
                            .slots = count_slots(io_host.variables.variables(), players),
                            .delay_ticks = players == 1 ? std::uint8_t{0} : delay_ticks,
                            .variables = lockstep::list_server_variables(io_host.variables.variables())};
  lockstep::SimulationSetup setup = make_setup(io_host);
  TRY_STATUS(lockstep::hash_files(setup.library, setup.program_file, start));
  TRY_STATUS(finish_recording(io_host));
  std::unique_ptr<platform::DatagramSocket> socket;
  if (players > 1) {
    // Our own server may have the port.
    disconnect(io_host);
    TRY(socket, open_socket(io_host, io_host.variables.port()));
  }
  open_game(io_host, lockstep::LockstepGame::host(std::move(setup), std::move(start), std::move(socket)));
  return base::Ok{};
}

base::Status join_lockstep(Host& io_host, std::string_view address) {
  if (!io_host.services.look_up) return base::error(base::ErrorCode::kUsage, "no network is available");
  TRY(const platform::Address host, io_host.services.look_up(address, kDefaultPort));
  TRY(std::unique_ptr<platform::DatagramSocket> socket, open_socket(io_host, 0));
  TRY_STATUS(finish_recording(io_host));
  open_game(io_host, lockstep::LockstepGame::join(make_setup(io_host), io_host.options.version,
                                                  std::move(socket), host, io_host.services.seed));
  print_line(io_host, fmt::format("Connecting to {}...", address));
  return base::Ok{};
}

base::Status save_replay(Host& io_host) {
  const std::optional<base::ByteVector> replay = io_host.game.session->take_replay();
  if (!replay) return base::Ok{};
  const std::filesystem::path& folder = io_host.game.data->write_folder;
  std::error_code ignored;
  for (int number = 0; number < kMaxReplays; ++number) {
    const std::filesystem::path path = folder / fmt::format("lockstep{:04}.replay", number);
    if (std::filesystem::exists(path, ignored)) continue;
    TRY_STATUS(io_host.services.write_file(path, *replay));
    print_line(io_host,
               fmt::format("Replay saved: {} ({} bytes). Play it with: playreplay {}",
                           io_host.game.data->shorten_path(path), replay->size(), path.filename().string()));
    return base::Ok{};
  }
  return base::error(base::ErrorCode::kUsage, "{} has {} replays; move some elsewhere", folder.string(),
                     kMaxReplays);
}

base::Status play_replay(Host& io_host, std::string_view file, std::size_t player) {
  TRY(const base::ByteVector bytes, read_replay_file(io_host, file));
  TRY(const lockstep::Replay replay, lockstep::read_replay(bytes).with_file(std::string(file)));
  if (player < 1 || player > replay.start.players)
    return base::error(base::ErrorCode::kUsage, "{}: choose a player from 1 to {}", file,
                       replay.start.players);
  TRY(lockstep::PlayedReplay played,
      lockstep::play_replay(replay, make_setup(io_host), io_host.options.version, player - 1)
          .with_file(std::string(file)));
  print_line(io_host,
             fmt::format("Replay {}: {} ticks ({:.0f} s) on {}, the same game: its last state is {:016x}.",
                         file, played.ticks, played.game_s, replay.start.map, played.last_hash));
  return play_demo_bytes(io_host, std::move(played.demo), std::string(file));
}

}  // namespace temblor::host
