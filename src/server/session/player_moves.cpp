// Plays the moves in clients' queues, and sends clients the settings for their prediction.
#include "server/server.h"
#include "server/session/move_parameters.h"
#include "server/session/stages.h"

namespace temblor::server {
namespace {

// Offers deltas to our own clients, which number their moves, once per connection. Stock clients ignore the
// line.
void offer_delta_compression(Server& io_server, std::size_t slot) {
  Client& client = io_server.clients[slot];
  if (!client.moves.is_numbered() || client.was_offered_deltas) return;
  client.was_offered_deltas = true;
  io_server.clients.send(slot, net::StuffText{net::format_delta_offer()});
}

}  // namespace

// A client in the game that is still between "spawn" and "begin" has an empty queue; it plays the default
// move.
base::Status play_moves(Server& io_server) {
  for (std::size_t slot = 0; slot < io_server.clients.size(); ++slot) {
    Client& client = io_server.clients[slot];
    PlayerInput& input = io_server.tick_inputs[slot];
    input = PlayerInput{};
    if (!client.is_in_game()) continue;
    if (io_server.clock.is_paused) {
      client.moves.skip();
      continue;
    }
    const std::span<const PlayerInput> due = client.moves.take_due();
    if (due.empty()) continue;  // the player stands still
    for (const PlayerInput& earlier : due.first(due.size() - 1))
      TRY_STATUS(io_server.game->play_move(slot, earlier));
    input = due.back();
    input.is_active = true;
  }
  return base::Ok{};
}

void send_move_parameters(Server& io_server) {
  for (std::size_t slot = 0; slot < io_server.clients.size(); ++slot) {
    Client& client = io_server.clients[slot];
    if (!client.is_in_game()) continue;
    offer_delta_compression(io_server, slot);
    const net::MoveParameters parameters =
        make_move_parameters(io_server.game->world(), slot, io_server.settings().tick_s());
    if (client.sent_move_parameters == parameters) continue;
    client.sent_move_parameters = parameters;
    io_server.clients.send(
        slot, net::StuffText{net::format_move_parameters(parameters)});  // a comment to stock clients
  }
}

}  // namespace temblor::server
