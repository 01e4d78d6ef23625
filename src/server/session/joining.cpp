// How a client gets into a level and out of it. The client itself asks for each next step:
//    server                                   client                                    stage afterward
//    level info: models, sounds, music  -->   loads them, answers "prespawn"            kLoading
//    signon: statics, baselines, ...    -->   answers "spawn"                           kPrespawned
//    names, frags, lights, own state    -->   draws its first frame, answers "begin"    kSpawned
//    snapshots                          <->   moves                                     kPlaying
// The words are those of stock Quake. A change of level starts with "reconnect", which makes a client expect
// the level info again.
#include <fmt/format.h>

#include <utility>

#include "server/server.h"
#include "server/session/signon.h"
#include "server/session/stages.h"

namespace temblor::server {

// Numbers of moves and snapshots start again in each level.
base::Status send_level_info(Server& io_server, std::size_t slot) {
  Client& client = io_server.clients[slot];
  client.stage = ClientStage::kLoading;
  client.loads_since_s = io_server.clock.now_s;
  client.moves = MoveQueue{};
  client.sent_move_parameters.reset();
  client.sent_stats.clear();
  client.sent_powerup_ends_s.clear();
  client.was_sent_combat = false;
  if (client.sent_snapshots) client.sent_snapshots->reset();
  TRY(base::ByteVector message, make_level_message(*io_server.game, slot));
  io_server.clients.queue_alone(slot, std::move(message));
  return base::Ok{};
}

void send_next_level(Server& io_server, std::size_t slot) {
  Client& client = io_server.clients[slot];
  client.stage = ClientStage::kPrespawned;  // so that the next message is not held back
  io_server.clients.send(slot, net::StuffText{"reconnect\n"});
  if (const base::Status sent = send_level_info(io_server, slot); !sent.ok())
    client.drop_reason = sent.error().message();
}

// Messages that were held back while the client loaded follow the signon.
base::Status send_signon(Server& io_server, std::size_t slot) {
  io_server.clients[slot].stage = ClientStage::kPrespawned;
  TRY(std::vector<base::ByteVector> parts, make_signon_messages(*io_server.game));
  for (base::ByteVector& part : parts) io_server.clients.queue_alone(slot, std::move(part));
  io_server.clients.queue_held(slot);
  return base::Ok{};
}

// A resuming player is in the game already. The game was paused until it came.
base::Status spawn_client(Server& io_server, std::size_t slot) {
  Client& client = io_server.clients[slot];
  if (io_server.resuming_players[slot])
    set_paused(io_server, false);
  else
    TRY_STATUS(io_server.game->spawn_client(slot, client.parameters, client.name, client.colors));
  if (slot < io_server.kept_places.size())
    if (const auto place = std::exchange(io_server.kept_places[slot], std::nullopt))
      TRY_STATUS(restore_player_place(*io_server.game, slot, *place));
  io_server.resuming_players[slot] = false;
  client.stage = ClientStage::kSpawned;
  client.has_spawned = true;
  TRY(std::vector<base::ByteVector> parts,
      make_state_messages(*io_server.game, io_server.clients.all(), slot));
  for (base::ByteVector& part : parts) io_server.clients.queue_alone(slot, std::move(part));
  return base::Ok{};
}

void begin_play(Server& io_server, std::size_t slot) {
  Client& client = io_server.clients[slot];
  client.stage = ClientStage::kPlaying;
  print_event(io_server, fmt::format("{} entered the game\n", client.name));
}

void disconnect_player(Server& io_server, std::size_t slot) {
  Client& client = io_server.clients[slot];
  if (!io_server.game || !(client.is_in_game() || io_server.resuming_players[slot])) return;
  io_server.resuming_players[slot] = false;
  if (io_server.recorder && io_server.recorder->slot() == slot)
    print_if_error(io_server, stop_demo(io_server));
  const base::Status status = io_server.game->disconnect_client(slot);
  client.stage = ClientStage::kLoading;  // a failure restarts the level, and must not come here again
  if (!status.ok()) handle_game_failure(io_server, status.error());
}

}  // namespace temblor::server
