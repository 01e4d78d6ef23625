#include "host/commands/shown_state.h"

#include <fmt/format.h>

#include "host/frame/host_parts.h"

namespace temblor::host {

client::ClientState* find_shown_state(Host& io_host, command::Console::Arguments arguments) {
  if (io_host.demos.session) return &io_host.demos.session->state();
  if (io_host.game.session->is_playing()) return &io_host.game.session->connection()->state();
  io_host.console.commands.print_error(fmt::format("{}: start or join a game first", arguments[0]));
  return nullptr;
}

void apply_message(Host& io_host, client::ClientState& io_state, const net::ServerMessage& message) {
  if (const base::Status applied = io_state.apply(message); !applied.ok())
    io_host.console.commands.print_error(applied.error().message());
}

}  // namespace temblor::host
