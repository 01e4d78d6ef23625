#include "app/lab/replay_command.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/commands/command_line.h"
#include "app/files/atomic_write.h"
#include "app/files/game_files.h"
#include "app/files/system.h"
#include "assets/library.h"
#include "base/text.h"
#include "lockstep/play_replay.h"
#include "vfs/disk.h"

namespace temblor::app {
namespace {

constexpr std::uint64_t kMaxReplayBytes = 256 << 20;

struct Figures {
  std::string map;
  int players = 0;
  std::uint32_t ticks = 0;
  double game_s = 0, wall_s = 0, kilobytes_per_minute = 0;
  std::uint64_t last_hash = 0;
};

void print_figures(const Figures& figures, bool json) {
  const std::string hash = fmt::format("{:016x}", figures.last_hash);
  if (json) {
    const nlohmann::ordered_json object = {{"map", figures.map},
                                           {"players", figures.players},
                                           {"ticks", figures.ticks},
                                           {"seconds", figures.game_s},
                                           {"kilobytes_per_minute", figures.kilobytes_per_minute},
                                           {"times_real_time", figures.game_s / figures.wall_s},
                                           {"last_state", hash}};
    fmt::print("{}\n", object.dump(2));
    return;
  }
  fmt::print("{}, {}, {} ticks ({:.1f} s), {:.1f} KB per minute\n", figures.map,
             base::counted(figures.players, "player"), figures.ticks, figures.game_s,
             figures.kilobytes_per_minute);
  fmt::print("the same game as recorded; its last state is {}\n", hash);
  fmt::print("simulated in {:.2f} s, {:.0f} times as fast as it was played\n", figures.wall_s,
             figures.game_s / figures.wall_s);
}

}  // namespace

Command* add_replay_command(Command& lab, ReplayOptions& io_options) {
  Command* command =
      lab.add_subcommand("replay", "Simulate a lockstep game again, and check that it is the same");
  command->add_option("FILE", io_options.file, "Replay that `play` has saved")->required();
  command->add_option("--player", io_options.player, "The player whose view -o records")
      ->type_name("N")
      ->check(in_range(1, static_cast<int>(lockstep::kMaxPlayers)))
      ->capture_default_str();
  command->add_option("--progs", io_options.program, "Game code (default: progs.dat of the game directories)")
      ->type_name("FILE");
  command->add_flag("--json", io_options.json, "Print JSON");
  command->add_option("-o,--output", io_options.out, "Save what the player saw as a demo")
      ->type_name("FILE.dem");
  return command;
}

base::Status run_replay(const ReplayOptions& options, const GameFolders& folders) {
  TRY(const base::ByteVector bytes, vfs::read_disk_file(options.file, kMaxReplayBytes));
  TRY(const lockstep::Replay replay, lockstep::read_replay(bytes).with_file(options.file));
  TRY(vfs::FileSystem files, open_files(folders));
  const assets::Library library(std::move(files));
  const double began_s = clock_s();
  TRY(const lockstep::PlayedReplay played,
      lockstep::play_replay(replay, {.library = library, .program_file = options.program},
                            "Temblor " TEMBLOR_VERSION, static_cast<std::size_t>(options.player) - 1)
          .with_file(options.file));
  print_figures(
      {.map = replay.start.map,
       .players = replay.start.players,
       .ticks = played.ticks,
       .game_s = played.game_s,
       .wall_s = clock_s() - began_s,
       .kilobytes_per_minute = static_cast<double>(bytes.size()) / 1000 / std::max(played.game_s / 60, 1e-3),
       .last_hash = played.last_hash},
      options.json);
  if (options.out.empty()) return base::Ok{};
  return replace_file(options.out, played.demo);
}

}  // namespace temblor::app
