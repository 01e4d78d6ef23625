// Connections: clients come and go, and packets pass in and out.
#include <fmt/format.h>

#include "base/text.h"
#include "server/server.h"
#include "server/session/stages.h"

namespace temblor::server {
namespace {

// A free slot. If all are taken, a bot makes room. Empty: the server is full.
std::optional<std::size_t> find_slot_for_newcomer(Server& io_server) {
  Clients& clients = io_server.clients;
  if (const std::optional<std::size_t> slot = clients.find_free_slot()) return slot;
  for (std::size_t slot = 0; slot < clients.size(); ++slot)
    if (clients[slot].is_bot()) {
      drop_client(io_server, slot, "makes room for a player");
      break;
    }
  return clients.find_free_slot();
}

// The slot is reset before anything can fail, so that the old client's state never leaks to the new one.
void handle_event(Server& io_server, const net::PeerConnected& event) {
  const std::optional<std::size_t> slot = find_slot_for_newcomer(io_server);
  if (!io_server.game || !slot) {
    io_server.endpoint.disconnect(event.connection,
                                  io_server.game ? "The server is full." : "No level is running.");
    return;
  }
  const double now_s = io_server.clock.now_s;
  Client& client = io_server.clients[*slot];
  client = Client{};
  client.stage = ClientStage::kLoading;
  client.connection = event.connection;
  client.address = platform::to_text(event.address);
  client.joined_at_s = now_s;
  client.commands.refill(now_s);
  print_event(io_server, fmt::format("client {} connected\n", client.address));
  base::Result<SpawnParameters> parameters = io_server.game->new_parameters();
  if (!parameters.ok()) return handle_game_failure(io_server, parameters.error());
  client.parameters = *parameters;
  if (const base::Status sent = send_level_info(io_server, *slot); !sent.ok())
    client.drop_reason = sent.error().message();
}

void handle_event(Server& io_server, const net::PeerMessage& event) {
  if (const std::optional<std::size_t> slot = io_server.clients.find_slot(event.connection))
    handle_packet(io_server, *slot, event.bytes, event.reliable);
}

void handle_event(Server& io_server, const net::PeerDisconnected& event) {
  if (const std::optional<std::size_t> slot = io_server.clients.find_slot(event.connection))
    drop_client(io_server, *slot, event.reason);
}

// The endpoint has already checked the password.
void handle_event(Server& io_server, const net::RemoteCommand& event) {
  print(io_server,
        fmt::format("rcon from {}: {}\n", platform::to_text(event.from), base::printable(event.command)));
  io_server.endpoint.reply_to_remote_command(event, run_and_capture(io_server, event.command));
}

// Slow computers take up to a minute to load a large level. A client that acknowledges packets for longer,
// but does not ask for the next step, would keep its slot forever.
bool is_stuck(Clients& io_clients, std::size_t slot, double now_s) {
  constexpr double kMaxStep_s = 75, kMaxJoining_s = 180;
  Client& client = io_clients[slot];
  if (client.is_free() || client.is_bot() || client.stage == ClientStage::kPlaying) return false;
  if (io_clients.has_unacknowledged(slot)) client.waits_since_s = now_s;
  return now_s - client.waits_since_s > kMaxStep_s || now_s - client.loads_since_s > kMaxJoining_s;
}

}  // namespace

void receive_packets(Server& io_server) {
  while (const std::optional<net::ServerEvent> event = io_server.endpoint.next_event(io_server.clock.now_s))
    std::visit([&](const auto& one) { handle_event(io_server, one); }, *event);
}

// Settings are passed on in each step, so that changes of the variables take effect at once.
void send_packets(Server& io_server) {
  io_server.clients.send_queued();
  io_server.endpoint.set_remote_password(io_server.settings().rcon_password());
  io_server.endpoint.set_timeout(io_server.settings().timeout_s());
  io_server.endpoint.update(io_server.clock.now_s);
}

net::ServerDescription describe_server(const Server& server) {
  net::ServerDescription description;
  description.host_name = server.settings().host_name();
  description.map = server.game ? server.game->setup().map_name : "";
  description.max_players = static_cast<int>(server.clients.size());
  for (const Client& client : server.clients.all()) {
    if (client.is_free()) continue;
    // Players' addresses stay private: anybody can query a server.
    description.players.push_back({.name = client.name,
                                   .colors = client.colors,
                                   .frags = client.sent_frags,
                                   .connected_s = server.clock.now_s - client.joined_at_s,
                                   .address = "private"});
  }
  for (const auto& [name, value] : server.settings().rules()) description.rules.push_back({name, value});
  return description;
}

// Game code runs first (ClientDisconnect), while the slot is still in use.
void drop_client(Server& io_server, std::size_t slot, std::string_view reason) {
  Clients& clients = io_server.clients;
  if (clients[slot].is_free()) return;
  disconnect_player(io_server, slot);
  // If QuakeC failed on the way, this client may have been dropped already.
  if (clients[slot].is_free()) return;
  print(io_server,
        fmt::format("client {} ({}) removed: {}\n", clients[slot].name, clients[slot].address, reason));
  clients.release(slot, reason);
  send_empty_slot(io_server, slot);
}

void send_empty_slot(Server& io_server, std::size_t slot) {
  const auto number = static_cast<std::uint8_t>(slot);
  io_server.clients.send_to_all(net::UpdateName{number, ""});
  io_server.clients.send_to_all(net::UpdateFrags{number, 0});
  io_server.clients.send_to_all(net::UpdateColors{number, 0});
}

void drop_failed_clients(Server& io_server) {
  Clients& clients = io_server.clients;
  for (std::size_t slot = 0; slot < clients.size(); ++slot) {
    Client& client = clients[slot];
    if (is_stuck(clients, slot, io_server.clock.now_s) && client.drop_reason.empty())
      client.drop_reason = "did not finish to join";
    if (!client.is_free() && !client.drop_reason.empty())
      drop_client(io_server, slot, std::string(client.drop_reason));
  }
}

}  // namespace temblor::server
