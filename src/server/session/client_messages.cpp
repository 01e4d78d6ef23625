// Handles what clients send: moves and lines of text. Stock clients send moves without numbers; ours precede
// them with a line of text that numbers them (net/protocol/numbered_moves.h). Both kinds go into the client's
// MoveQueue.
//    stock packet:  move                     ours:  "numbered" line | move n-k | ... | move n
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "command/text.h"
#include "net/protocol/client_message.h"
#include "net/protocol/numbered_moves.h"
#include "server/commands/player_commands.h"
#include "server/server.h"
#include "server/session/stages.h"

namespace temblor::server {
namespace {

// A client may send any time; a longer ping would spoil the mean.
constexpr float kMaxPing_s = 5;

PlayerInput make_input(const net::Move& move) {
  return {.command = {.view_angles_deg = move.angles_deg,
                      .forward = static_cast<float>(move.forward),
                      .side = static_cast<float>(move.side),
                      .up = static_cast<float>(move.up)},
          .buttons = move.buttons,
          .impulse = move.impulse};
}

// Moves that go into the queue together: those of a whole packet if they are numbered, else one.
struct MoveBatch {
  std::optional<std::uint32_t> last_number{};  // empty: moves without numbers
  std::array<PlayerInput, net::kMaxMovesInPacket> moves{};
  std::size_t count = 0;
  float sent_time_s = 0;  // the game time that the client had last received when it sent the last move

  // Ignores moves past what a packet may hold.
  void add(const net::Move& move) {
    if (count == moves.size()) return;
    moves[count++] = make_input(move);
    sent_time_s = move.time_s;
  }
};

// The ping is the age of the newest snapshot that the client had when it sent the move, in game time.
void queue_moves(Server& io_server, std::size_t slot, MoveBatch& io_batch) {
  if (io_batch.count == 0) return;
  Client& client = io_server.clients[slot];
  const float ping_s = static_cast<float>(io_server.game->time_s()) - io_batch.sent_time_s;
  client.add_ping(std::clamp(ping_s, 0.0f, kMaxPing_s));
  client.moves.add(io_batch.last_number, std::span(io_batch.moves).first(io_batch.count));
  io_batch.count = 0;
}

// The line before numbered moves also says which snapshots have arrived.
void handle_packet_head(Client& io_client, const net::NumberedPacket& head) {
  io_client.accepts_deltas = io_client.was_offered_deltas && head.accepts_deltas;
  if (!io_client.accepts_deltas) return;
  if (!io_client.sent_snapshots) io_client.sent_snapshots.emplace();
  if (head.received_snapshot) io_client.sent_snapshots->acknowledge(*head.received_snapshot);
}

std::string make_unreadable_reason(const base::Error& error) {
  return fmt::format("sent an unreadable message: {}", error.what);
}

// Lets game code handle the line, if it has a function for that (KRIMZON_SV_PARSECLIENTCOMMAND). false: it
// has none, and the server handles the line.
bool offer_command_to_game(Server& io_server, std::size_t slot, std::string_view line) {
  Game& game = *io_server.game;
  const vm::FunctionIndex parse = game.machine().program().find_function("SV_ParseClientCommand");
  if (parse == vm::kNoFunction) return false;
  const base::Result<vm::StringIndex> text = game.machine().make_string(line);
  if (!text.ok()) {
    handle_game_failure(io_server, text.error());
    return true;
  }
  game.machine().set_parameter_string(0, *text);
  const base::Status status =
      game.world().calls.call(parse, Game::player_index(slot), vm::kWorld, game.time_s());
  if (!status.ok())
    handle_game_failure(io_server, status.error());
  else
    handle_game_requests(io_server);
  return true;
}

// Handles "prespawn" and "spawn": each is expected once, in this order. One that comes at another time
// belongs to the previous level.
void handle_join_command(Server& io_server, std::size_t slot, bool is_spawn) {
  Client& client = io_server.clients[slot];
  const bool is_expected = client.stage == (is_spawn ? ClientStage::kPrespawned : ClientStage::kLoading);
  if (!is_expected) return;
  if (std::exchange(client.loads_old_level, false)) return send_next_level(io_server, slot);
  const base::Status status = is_spawn ? spawn_client(io_server, slot) : send_signon(io_server, slot);
  if (!status.ok()) handle_game_failure(io_server, status.error());
}

// DarkPlaces reads protocol 15 only. It leaves at once, with a page of numbers on its console.
void handle_leave(Server& io_server, std::size_t slot) {
  const Client& client = io_server.clients[slot];
  const auto protocol = static_cast<int>(io_server.clients.dialect().protocol);
  if (client.stage == ClientStage::kLoading && !client.has_spawned &&
      protocol != static_cast<int>(net::Protocol::kNetQuake)) {
    io_server.endpoint.send_notice(
        client.connection,
        fmt::format("This game uses protocol {}. If your program cannot read it, ask the host to set: "
                    "sv_protocol 15\n",
                    protocol));
    print(io_server, fmt::format("client {} left before it had loaded the level. If it cannot read protocol "
                                 "{}, as DarkPlaces, set: sv_protocol 15\n",
                                 client.address, protocol));
  }
  drop_client(io_server, slot, "left");
}

// The words of the handshake are handled here, and never reach game code.
void handle_command(Server& io_server, std::size_t slot, std::string_view line) {
  Client& client = io_server.clients[slot];
  if (!client.commands.take(io_server.clock.now_s)) {
    client.drop_reason = "sent too many commands";
    return;
  }
  const std::vector<std::string> words = command::split_words(line);
  if (words.empty()) return;
  const std::string& name = words[0];
  if (name == "prespawn" || name == "spawn") {
    handle_join_command(io_server, slot, name == "spawn");
  } else if (name == "begin") {
    if (client.stage == ClientStage::kSpawned) begin_play(io_server, slot);
  } else if (name == "dropclient" || name == "drop") {
    handle_leave(io_server, slot);
  } else if (!client.is_in_game() || !offer_command_to_game(io_server, slot, line)) {
    run_player_command(io_server, slot, line);
  }
}

// An unreliable packet from a client that does not play yet. Only a disconnect counts: its moves belong to
// the previous level, and may be in another protocol. A newcomer has no previous level, so it must be
// readable.
void handle_early_packet(Server& io_server, std::size_t slot, net::ClientMessageReader& io_reader) {
  Client& client = io_server.clients[slot];
  const auto message = io_reader.next();
  if (!message.ok() && !client.has_spawned)
    client.drop_reason = make_unreadable_reason(message.error());
  else if (message.ok() && *message && std::holds_alternative<net::Disconnect>(**message))
    handle_leave(io_server, slot);
}

}  // namespace

// Any message may drop the client or end the level, so both are checked before the next message is read.
void handle_packet(Server& io_server, std::size_t slot, base::Bytes bytes, bool is_reliable) {
  net::ClientMessageReader reader(bytes, io_server.clients.dialect().protocol);
  Client& client = io_server.clients[slot];
  if (!is_reliable && client.stage != ClientStage::kPlaying)
    return handle_early_packet(io_server, slot, reader);
  MoveBatch batch;
  while (true) {
    const auto message = reader.next();
    if (!message.ok()) {
      client.drop_reason = make_unreadable_reason(message.error());
      return;
    }
    if (!message->has_value()) break;
    if (std::holds_alternative<net::Disconnect>(**message)) return handle_leave(io_server, slot);
    if (const auto* move = std::get_if<net::Move>(&**message)) {
      if (client.stage != ClientStage::kPlaying) continue;
      batch.add(*move);
      if (!batch.last_number) queue_moves(io_server, slot, batch);
    } else if (const auto* command = std::get_if<net::StringCommand>(&**message)) {
      if (!is_reliable && !batch.last_number) {
        if (const auto head = net::read_numbered_packet(command->text)) {
          batch.last_number = head->last_move;
          handle_packet_head(client, *head);
        }
      }
      if (batch.last_number) continue;
      handle_command(io_server, slot, command->text);
      if (client.is_free() || !io_server.game) return;
    }
  }
  queue_moves(io_server, slot, batch);
}

}  // namespace temblor::server
