// Names of players. Each name is used once; a second player of that name gets a number: "player (2)".
//
// A player whose program was killed comes back while its old connection still waits for packets. The new
// connection replaces the old one, and gets its name, if all of this is true:
//
// - both come from the same host and ask for the same name;
// - the old one played, so that its client sent moves in every frame;
// - it has sent nothing since the new one connected, and for kDeadSilence_s.
//
// So two players behind one address who both are "player" keep their places: each of them sends packets, or
// loads a level. Nobody can take the place of a player whose client still runs.
#include <fmt/format.h>

#include <optional>
#include <span>
#include <string>

#include "base/text.h"
#include "server/server.h"
#include "server/session/stages.h"

namespace temblor::server {
namespace {

constexpr double kDeadSilence_s = 2;

std::string make_unique_name(std::span<const Client> clients, std::size_t slot, const std::string& wanted) {
  const auto is_taken = [&](const std::string& name) {
    for (std::size_t other = 0; other < clients.size(); ++other)
      if (other != slot && !clients[other].is_free() && base::equal_ignoring_case(clients[other].name, name))
        return true;
    return false;
  };
  if (wanted == Client::kNoName) return wanted;
  std::string name = wanted;
  for (int number = 2; is_taken(name); ++number) {
    const std::string mark = fmt::format(" ({})", number);
    name = wanted.substr(0, Client::kMaxNameChars - mark.size()) + mark;
  }
  return name;
}

bool has_replaced_dead_connection(const Server& server, const Client& old, const Client& newcomer) {
  if (old.stage != ClientStage::kPlaying || old.connection == newcomer.connection) return false;
  if (!base::equal_ignoring_case(old.wanted_name, newcomer.wanted_name)) return false;
  const auto old_address = server.endpoint.peer_address(old.connection);
  const auto new_address = server.endpoint.peer_address(newcomer.connection);
  if (!old_address || !new_address || !old_address->same_host(*new_address)) return false;
  const double last_packet_s = *server.endpoint.last_packet_s(old.connection);
  return last_packet_s < newcomer.joined_at_s && server.clock.now_s - last_packet_s >= kDeadSilence_s;
}

// Whether this client has another name than it wants, because somebody else has that one.
bool has_numbered_name(const Client& client) {
  return !client.is_free() && !client.wanted_name.empty() && client.name != client.wanted_name;
}

std::optional<std::size_t> find_dead_connection(const Server& server, const Client& newcomer) {
  for (std::size_t slot = 0; slot < server.clients.size(); ++slot)
    if (has_replaced_dead_connection(server, server.clients[slot], newcomer)) return slot;
  return std::nullopt;
}

}  // namespace

void set_player_name(Server& io_server, std::size_t slot, const std::string& wanted) {
  Client& client = io_server.clients[slot];
  client.wanted_name = wanted;
  const std::string name = make_unique_name(io_server.clients.all(), slot, wanted);
  if (name == client.name) return;
  if (client.is_in_game() && client.name != Client::kNoName)
    print(io_server, fmt::format("{} is now {}\n", client.name, name));
  client.name = name;
  if (client.is_in_game() && !io_server.game->set_player_look(slot, name, client.colors).ok())
    client.drop_reason = "there is no memory for its name";
  io_server.clients.send_to_all(net::UpdateName{static_cast<std::uint8_t>(slot), name});
}

void replace_dead_connections(Server& io_server) {
  for (std::size_t slot = 0; slot < io_server.clients.size(); ++slot) {
    if (!has_numbered_name(io_server.clients[slot])) continue;
    const std::optional<std::size_t> dead = find_dead_connection(io_server, io_server.clients[slot]);
    if (!dead) continue;
    drop_client(io_server, *dead, "came back with another connection");
    // Game code runs when a player leaves, and may fail.
    if (has_numbered_name(io_server.clients[slot]))
      set_player_name(io_server, slot, std::string(io_server.clients[slot].wanted_name));
  }
}

}  // namespace temblor::server
