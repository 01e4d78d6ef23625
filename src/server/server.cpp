// Sets up a server's parts, prints for the host, and shuts the server down.
#include "server/server.h"

#include <fmt/format.h>

#include "server/commands/host_commands.h"
#include "server/session/stages.h"

namespace temblor::server {
namespace {

std::string with_newline(std::string_view line) {
  return std::string(line) + "\n";
}

// A server never has more connections than player slots.
net::ServerEndpointSettings make_endpoint_settings(const ServerSetup& setup) {
  net::ServerEndpointSettings settings = setup.wire;
  settings.max_connections = setup.max_clients;
  settings.timeout_s = setup.settings.timeout_s();
  return settings;
}

}  // namespace

Server::Server(ServerSetup server_setup)
    : setup(std::move(server_setup)),
      console(setup.settings.variables(),
              [this](std::string_view line) { print(*this, with_newline(line)); }),
      endpoint(std::move(setup.sockets), make_endpoint_settings(setup),
               [this] { return describe_server(*this); }),
      clients(endpoint, setup.max_clients),
      tick_inputs(setup.max_clients) {
  add_host_commands(*this);
}

// The order matters: clients are sent the reason as text before the disconnect, and update() sends both
// before the sockets close.
void shut_down(Server& io_server, std::string_view reason) {
  if (io_server.recorder) print_if_error(io_server, stop_demo(io_server));
  autosave_on_leave(io_server);
  Clients& clients = io_server.clients;
  clients.print_to_all(fmt::format("{}\n", reason));
  clients.send_queued();
  for (std::size_t slot = 0; slot < clients.size(); ++slot)
    if (!clients[slot].is_free()) clients.release(slot, reason);
  io_server.endpoint.update(io_server.clock.now_s);
}

base::Status set_max_clients(Server& io_server, std::uint32_t count) {
  if (io_server.game)
    return base::error(base::ErrorCode::kUsage,
                       "the number of players is fixed while a level runs; set it in server.cfg or with "
                       "--maxclients {}",
                       count);
  io_server.setup.max_clients = count;
  io_server.endpoint.set_max_connections(count);
  io_server.clients.set_size(count);
  io_server.tick_inputs = std::vector<PlayerInput>(count);
  return base::Ok{};
}

void set_paused(Server& io_server, bool is_paused) {
  if (is_paused == io_server.clock.is_paused) return;
  io_server.clock.is_paused = is_paused;
  io_server.clients.send_to_all(net::SetPause{is_paused});
}

// Output of rcon goes to the host's console too, so that nobody can use rcon unnoticed.
void print(Server& io_server, std::string_view text) {
  io_server.setup.print(text);
  if (io_server.captured_output) *io_server.captured_output += text;
}

void print_event(Server& io_server, std::string_view text) {
  if (io_server.setup.prints_events) print(io_server, text);
}

void print_if_error(Server& io_server, const base::Status& status) {
  if (!status.ok()) print(io_server, status.error().message() + "\n");
}

// Calls may nest: a command that fails can print, and its output belongs to the innermost call.
std::string run_and_capture(Server& io_server, std::string_view line) {
  std::optional<std::string> outer = std::exchange(io_server.captured_output, std::string());
  io_server.console.execute(line);
  return *std::exchange(io_server.captured_output, std::move(outer));
}

}  // namespace temblor::server
