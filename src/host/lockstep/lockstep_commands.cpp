#include "host/lockstep/lockstep_commands.h"

#include <optional>

#include "command/text.h"
#include "host/commands/command_adder.h"
#include "host/lockstep/lockstep_games.h"
#include "lockstep/lockstep_game.h"

namespace temblor::host {
namespace {

using Arguments = command::Console::Arguments;

constexpr std::string_view kHostHelp =
    "lockstep MAP [PLAYERS [DELAY]]: starts a lockstep game for 1 to 4 players (default 2), which all "
    "computers "
    "simulate. Inputs take effect after 1 to 36 ticks (default 4). The game's replay is saved when it ends.";
constexpr std::string_view kJoinHelp = "lockstep_join HOST[:PORT]: joins a lockstep game.";
constexpr std::string_view kReplayHelp =
    "playreplay FILE [PLAYER]: simulates a lockstep game again, and plays it as that player (default 1) saw "
    "it.";

void print_if_failed(Host& io_host, const base::Status& status) {
  if (!status.ok()) io_host.console.commands.print_error(status.error().message());
}

// The argument as a whole number in the range. `otherwise`: if it is missing. Nothing if it is no such
// number.
std::optional<std::uint8_t> parse_small(Arguments arguments, std::size_t index, int min, int max,
                                        int otherwise) {
  if (index >= arguments.size()) return static_cast<std::uint8_t>(otherwise);
  const std::optional<std::int64_t> number = command::parse_whole_number(arguments[index]);
  if (!number || *number < min || *number > max) return std::nullopt;
  return static_cast<std::uint8_t>(*number);
}

void host_command(Host& io_host, Arguments arguments) {
  const auto players = parse_small(arguments, 2, 1, lockstep::kMaxPlayers, 2);
  const auto delay_ticks = parse_small(arguments, 3, 1, kMaxDelayTicks, kDefaultDelayTicks);
  if (arguments.size() < 2 || arguments.size() > 4 || !players || !delay_ticks)
    return io_host.console.commands.print_error(kHostHelp);
  print_if_failed(io_host, host_lockstep(io_host, arguments[1], *players, *delay_ticks));
}

void join_command(Host& io_host, Arguments arguments) {
  if (arguments.size() != 2) return io_host.console.commands.print_error(kJoinHelp);
  print_if_failed(io_host, join_lockstep(io_host, arguments[1]));
}

void replay_command(Host& io_host, Arguments arguments) {
  const auto player = parse_small(arguments, 2, 1, lockstep::kMaxPlayers, 1);
  if (arguments.size() < 2 || arguments.size() > 3 || !player)
    return io_host.console.commands.print_error(kReplayHelp);
  print_if_failed(io_host, play_replay(io_host, arguments[1], *player));
}

}  // namespace

void add_lockstep_commands(Host& io_host) {
  const auto add = make_adder(io_host);
  add("lockstep", kHostHelp, host_command);
  add("lockstep_join", kJoinHelp, join_command);
  add("playreplay", kReplayHelp, replay_command);
}

}  // namespace temblor::host
