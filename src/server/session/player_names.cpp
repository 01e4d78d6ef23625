// Names of players. Each name is used once; a second player of that name gets a number: "player (2)".
//
// A player whose program was killed comes back while its old connection still waits for packets. The new
// connection gets the name of the old one if all of this is true:
//
// - both come from the same host and ask for the same name;
// - the old one played, so that its client sent moves in every frame;
// - it has sent nothing since the new one connected.
//
// After kDeadSilence_s it replaces the old one. If that sends something before, the new one gets a number.
//
// So two players behind one address who both are "player" keep their places: each of them sends packets, or
// loads a level. Nobody can take the place of a player whose client still runs.
#include <fmt/format.h>

#include <optional>
#include <string>

#include "base/text.h"
#include "server/server.h"
#include "server/session/stages.h"

namespace temblor::server {
namespace {

constexpr double kDeadSilence_s = 2;

bool has_name(const Client& client, std::string_view name) {
  return !client.is_free() && base::equal_ignoring_case(client.name, name);
}

// How long the connection that this newcomer may replace has been silent. None: it is in use.
std::optional<double> measure_silence_s(const Server& server, const Client& old, const Client& newcomer) {
  if (old.stage != ClientStage::kPlaying || old.connection == newcomer.connection) return std::nullopt;
  if (!base::equal_ignoring_case(old.wanted_name, newcomer.wanted_name)) return std::nullopt;
  const auto old_address = server.endpoint.peer_address(old.connection);
  const auto new_address = server.endpoint.peer_address(newcomer.connection);
  if (!old_address || !new_address || !old_address->same_host(*new_address)) return std::nullopt;
  const double last_packet_s = *server.endpoint.last_packet_s(old.connection);
  if (last_packet_s >= newcomer.joined_at_s) return std::nullopt;
  return server.clock.now_s - last_packet_s;
}

bool is_name_taken(const Server& server, std::size_t slot, std::string_view name) {
  const Client& newcomer = server.clients[slot];
  for (std::size_t other = 0; other < server.clients.size(); ++other)
    if (other != slot && has_name(server.clients[other], name) &&
        !measure_silence_s(server, server.clients[other], newcomer))
      return true;
  return false;
}

std::string make_unique_name(const Server& server, std::size_t slot, const std::string& wanted) {
  if (wanted == Client::kNoName) return wanted;
  std::string name = wanted;
  for (int number = 2; is_name_taken(server, slot, name); ++number) {
    const std::string mark = fmt::format(" ({})", number);
    name = wanted.substr(0, Client::kMaxNameChars - mark.size()) + mark;
  }
  return name;
}

// Whether this client cannot have the name that it wants, or shares it with an older connection.
bool has_rival(const Server& server, std::size_t slot) {
  const Client& client = server.clients[slot];
  if (client.is_free() || client.wanted_name.empty() || client.wanted_name == Client::kNoName) return false;
  if (client.name != client.wanted_name) return true;
  for (std::size_t other = 0; other < server.clients.size(); ++other)
    if (other != slot && has_name(server.clients[other], client.name) &&
        server.clients[other].joined_at_s < client.joined_at_s)
      return true;
  return false;
}

std::optional<std::size_t> find_dead_connection(const Server& server, const Client& newcomer) {
  for (std::size_t slot = 0; slot < server.clients.size(); ++slot)
    if (measure_silence_s(server, server.clients[slot], newcomer).value_or(0) >= kDeadSilence_s) return slot;
  return std::nullopt;
}

}  // namespace

void set_player_name(Server& io_server, std::size_t slot, const std::string& wanted) {
  Client& client = io_server.clients[slot];
  client.wanted_name = wanted;
  const std::string name = make_unique_name(io_server, slot, wanted);
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
    if (!has_rival(io_server, slot)) continue;
    if (const std::optional<std::size_t> dead = find_dead_connection(io_server, io_server.clients[slot]))
      drop_client(io_server, *dead, "came back with another connection");
    // Game code runs when a player leaves, and may fail.
    if (has_rival(io_server, slot))
      set_player_name(io_server, slot, std::string(io_server.clients[slot].wanted_name));
  }
}

}  // namespace temblor::server
