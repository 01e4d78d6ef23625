// Built-in functions for console commands.
#include <algorithm>

#include "server/builtins/families.h"

namespace temblor::server {
namespace {

// localcmd(text, ...): runs a console command of the host, after QuakeC has returned.
base::Status localcmd(Call& io_call) {
  std::string& commands = io_call.game.requests.commands;
  const std::string text = io_call.joined_text(0);
  if (text.size() > Requests::kMaxCommandBytes - std::min(commands.size(), Requests::kMaxCommandBytes))
    return io_call.error("more than {} bytes of commands are waiting", Requests::kMaxCommandBytes);
  commands += text;
  return base::Ok{};
}

// clientcommand(player, command): runs a player's command later, as if the game code had not seen it.
base::Status clientcommand(Call& io_call) {
  TRY(const vm::EntityIndex player, io_call.player(0));
  if (!io_call.game.client_command) return io_call.error("this server does not run players' commands");
  io_call.game.client_command(player, std::string(io_call.text(1)));
  return base::Ok{};
}

}  // namespace

std::span<const BuiltinEntry> command_builtins() {
  static constexpr BuiltinEntry kEntries[] = {{46, "localcmd", localcmd},
                                              {440, "clientcommand", clientcommand}};
  return kEntries;
}

}  // namespace temblor::server
