// Clients: how they come, what they ask for, how they go.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "base/text.h"
#include "command/text.h"
#include "net/protocol/client_message.h"
#include "net/protocol/message_writer.h"
#include "server/commands/player_commands.h"
#include "server/server.h"
#include "server/session/signon.h"

namespace temblor::server {
namespace {

// Lines of text that a client may give at once, and how many more each second: more than anybody types.
constexpr double kCommandsAtOnce = 60, kCommandsPerSecond = 20;
constexpr float kMaxPing_s = 5;

PlayerInput input_of(const net::Move& move) {
  return {.command = {.view_angles_deg = move.angles_deg,
                      .forward = static_cast<float>(move.forward),
                      .side = static_cast<float>(move.side),
                      .up = static_cast<float>(move.up)},
          .buttons = move.buttons,
          .impulse = move.impulse};
}

// Of one packet; more than it may hold are left out.
struct PacketMoves {
  std::optional<std::uint32_t> last_number{};
  std::array<PlayerInput, net::kMaxMovesInPacket> moves{};
  std::size_t count = 0;
  float last_time_s = 0;

  void add(const net::Move& move) {
    if (count == moves.size()) return;
    moves[count++] = input_of(move);
    last_time_s = move.time_s;
  }
};

}  // namespace

void Server::take_events() {
  while (const std::optional<net::ServerEvent> event = endpoint_.next_event(now_s_))
    std::visit([this](const auto& one) { take_event(one); }, *event);
}

void Server::take_event(const net::PeerConnected& event) {
  const std::optional<std::size_t> slot = place_for_newcomer();
  if (!game_ || !slot) {
    endpoint_.disconnect(event.connection, game_ ? "The server is full.\n" : "No level is running.\n");
    return;
  }
  Client& client = clients_[*slot];
  client = Client{};
  client.stage = ClientStage::kTold;
  client.connection = event.connection;
  client.address = platform::to_text(event.address);
  client.joined_at_s = now_s_;
  client.command_credit = kCommandsAtOnce;
  client.credit_since_s = now_s_;
  print_event(fmt::format("client {} connected\n", client.address));
  base::Result<SpawnParameters> parameters = game_->new_parameters();
  if (!parameters.ok()) return fail(parameters.error());
  client.parameters = *parameters;
  if (const base::Status told = tell_level(*slot); !told.ok()) client.drop_reason = told.error().message();
}

// Where all are taken, a bot makes room.
std::optional<std::size_t> Server::place_for_newcomer() {
  if (const std::optional<std::size_t> slot = clients_.free_slot()) return slot;
  for (std::size_t slot = 0; slot < clients_.size(); ++slot)
    if (clients_[slot].is_bot()) {
      drop(slot, "makes room");
      break;
    }
  return clients_.free_slot();
}

void Server::take_event(const net::PeerMessage& event) {
  if (const std::optional<std::size_t> slot = clients_.slot_of(event.connection))
    take_messages(*slot, event.bytes, event.reliable);
}

void Server::take_event(const net::PeerDisconnected& event) {
  if (const std::optional<std::size_t> slot = clients_.slot_of(event.connection)) drop(*slot, event.reason);
}

void Server::take_event(const net::RemoteCommand& event) {
  print(fmt::format("rcon from {}: {}\n", platform::to_text(event.from), base::printable(event.command)));
  endpoint_.reply_to_remote_command(event, run_and_capture(event.command));
}

net::ServerDescription Server::description() const {
  net::ServerDescription description;
  description.host_name = setup_.settings.host_name();
  description.map = game_ ? game_->setup().map_name : "";
  description.max_players = static_cast<int>(clients_.size());
  for (const Client& client : clients_.all()) {
    if (client.is_free()) continue;
    // Where players are is nobody's business.
    description.players.push_back({.name = client.name,
                                   .colors = client.colors,
                                   .frags = client.sent_frags,
                                   .connected_s = now_s_ - client.joined_at_s,
                                   .address = "private"});
  }
  for (const auto& [name, value] : setup_.settings.rules()) description.rules.push_back({name, value});
  return description;
}

base::Status Server::tell_level(std::size_t slot) {
  clients_[slot].stage = ClientStage::kTold;
  clients_[slot].input = PlayerInput{};
  clients_[slot].moves = MoveQueue{};
  clients_[slot].sent_move_parameters.reset();
  if (clients_[slot].sent_snapshots) clients_[slot].sent_snapshots->forget();
  TRY(base::ByteVector message, level_message(*game_, slot));
  clients_.queue_alone(slot, std::move(message));
  return base::Ok{};
}

// To a client that is in another one, or on its way there.
void Server::tell_next_level(std::size_t slot) {
  clients_[slot].stage = ClientStage::kLoaded;  // it listens
  clients_.tell(slot, net::StuffText{"reconnect\n"});
  if (const base::Status told = tell_level(slot); !told.ok())
    clients_[slot].drop_reason = told.error().message();
}

base::Status Server::tell_beginning(std::size_t slot) {
  clients_[slot].stage = ClientStage::kLoaded;
  TRY(std::vector<base::ByteVector> parts, beginning_messages(*game_));
  for (base::ByteVector& part : parts) clients_.queue_alone(slot, std::move(part));
  clients_.queue_held(slot);
  return base::Ok{};
}

base::Status Server::spawn_client(std::size_t slot) {
  Client& client = clients_[slot];
  if (resuming_[slot])
    set_paused(false);
  else
    TRY_STATUS(game_->put_in(slot, client.parameters, client.name, client.colors));
  resuming_[slot] = false;
  client.stage = ClientStage::kSpawned;
  TRY(std::vector<base::ByteVector> parts, state_messages(*game_, clients_.all(), slot));
  for (base::ByteVector& part : parts) clients_.queue_alone(slot, std::move(part));
  return base::Ok{};
}

void Server::begin_play(std::size_t slot) {
  Client& client = clients_[slot];
  client.stage = ClientStage::kPlaying;
  print_event(fmt::format("{} entered the game\n", client.name));
}

void Server::take_messages(std::size_t slot, base::Bytes bytes, bool is_reliable) {
  net::ClientMessageReader reader(bytes, clients_.dialect().protocol);
  // Moves that were on their way when the level changed are in its protocol, which may have been another.
  if (!is_reliable && clients_[slot].stage != ClientStage::kPlaying) {
    const auto message = reader.next();
    if (message.ok() && *message && std::holds_alternative<net::Disconnect>(**message)) drop(slot, "left");
    return;
  }
  PacketMoves numbered;
  while (true) {
    const auto message = reader.next();
    Client& client = clients_[slot];
    if (!message.ok()) {
      client.drop_reason = fmt::format("sent what cannot be read: {}", message.error().what);
      return;
    }
    if (!message->has_value()) break;
    if (std::holds_alternative<net::Disconnect>(**message)) return drop(slot, "left");
    if (const auto* move = std::get_if<net::Move>(&**message)) {
      if (client.stage != ClientStage::kPlaying) continue;
      if (numbered.last_number)
        numbered.add(*move);
      else
        take_move(slot, *move);
    } else if (const auto* command = std::get_if<net::StringCommand>(&**message)) {
      if (!is_reliable && !numbered.last_number) {
        if (const auto head = net::read_numbered_packet(command->text)) {
          numbered.last_number = head->last_move;
          take_packet_head(slot, *head);
        }
      }
      if (numbered.last_number) continue;
      take_command(slot, command->text);
      if (clients_[slot].is_free() || !game_) return;
    }
  }
  if (numbered.count == 0) return;
  note_ping(slot, numbered.last_time_s);
  clients_[slot].moves.add(*numbered.last_number, std::span(numbered.moves).first(numbered.count));
}

void Server::note_ping(std::size_t slot, float told_time_s) {
  const float ping_s = static_cast<float>(game_->time_s()) - told_time_s;
  clients_[slot].add_ping(std::clamp(ping_s, 0.0f, kMaxPing_s));
}

// Which updates the client has.
void Server::take_packet_head(std::size_t slot, const net::NumberedPacket& head) {
  Client& client = clients_[slot];
  client.accepts_deltas = client.was_offered_deltas && head.accepts_deltas;
  if (!client.accepts_deltas) return;
  if (!client.sent_snapshots) client.sent_snapshots.emplace();
  if (head.received_snapshot) client.sent_snapshots->acknowledge(*head.received_snapshot);
}

// One without a number, which holds until the next one comes.
void Server::take_move(std::size_t slot, const net::Move& move) {
  Client& client = clients_[slot];
  note_ping(slot, move.time_s);
  // One that comes before the last was played must not take its place.
  const std::uint8_t impulse = move.impulse != 0 ? move.impulse : client.input.impulse;
  client.input = input_of(move);
  client.input.impulse = impulse;
  if (client.moves.has_begun()) client.moves.restart();
}

// Whether this client has not asked for too much lately.
bool Server::may_command(std::size_t slot) {
  Client& client = clients_[slot];
  client.command_credit = std::min(
      kCommandsAtOnce, client.command_credit + (now_s_ - client.credit_since_s) * kCommandsPerSecond);
  client.credit_since_s = now_s_;
  if (client.command_credit < 1) return false;
  client.command_credit -= 1;
  return true;
}

void Server::take_command(std::size_t slot, std::string_view line) {
  if (!may_command(slot)) {
    clients_[slot].drop_reason = "gave too many commands";
    return;
  }
  const std::vector<std::string> words = command::split_words(line);
  if (words.empty()) return;
  const ClientStage stage = clients_[slot].stage;
  const std::string& name = words[0];
  // Each of these is asked for once, in this order; what comes out of turn belongs to the level before.
  if (name == "prespawn" || name == "spawn") {
    const bool is_turn = stage == (name == "spawn" ? ClientStage::kLoaded : ClientStage::kTold);
    if (!is_turn) return;
    if (std::exchange(clients_[slot].loads_old_level, false)) return tell_next_level(slot);
    const base::Status status = name == "spawn" ? spawn_client(slot) : tell_beginning(slot);
    if (!status.ok()) fail(status.error());
  } else if (name == "begin") {
    if (stage == ClientStage::kSpawned) begin_play(slot);
  } else if (name == "dropclient" || name == "drop") {
    drop(slot, "left");
  } else if (!clients_[slot].is_in_game() || !parse_command(slot, line)) {
    run_player_command(*this, slot, line);
  }
}

// Gives the program a chance at the line, if it wants one; false: the line is the server's.
bool Server::parse_command(std::size_t slot, std::string_view line) {
  const vm::FunctionIndex parse = game_->machine().program().find_function("SV_ParseClientCommand");
  if (parse == vm::kNoFunction) return false;
  const base::Result<vm::StringIndex> text = game_->machine().make_string(line);
  if (!text.ok()) {
    fail(text.error());
    return true;
  }
  game_->machine().set_parameter_string(0, *text);
  const base::Status status =
      game_->world().calls.call(parse, Game::player_index(slot), vm::kWorld, game_->time_s());
  if (!status.ok())
    fail(status.error());
  else
    do_requests();
  return true;
}

void Server::leave(std::size_t slot) {
  if (!game_ || !(clients_[slot].is_in_game() || resuming_[slot])) return;
  resuming_[slot] = false;
  if (recorder_ && recorder_->slot() == slot) {
    print_if_error(stop_recording());
  }
  const base::Status status = game_->take_out(slot);
  clients_[slot].stage = ClientStage::kTold;  // fail() must not try it again
  if (!status.ok()) fail(status.error());
}

void Server::drop(std::size_t slot, std::string_view reason) {
  if (clients_[slot].is_free()) return;
  leave(slot);
  if (clients_[slot].is_free()) return;
  print(fmt::format("client {} ({}) removed: {}\n", clients_[slot].name, clients_[slot].address, reason));
  clients_.release(slot, reason);
  tell_of_leaving(slot);
}

void Server::tell_of_leaving(std::size_t slot) {
  const auto number = static_cast<std::uint8_t>(slot);
  clients_.tell_everyone(net::UpdateName{number, ""});
  clients_.tell_everyone(net::UpdateFrags{number, 0});
  clients_.tell_everyone(net::UpdateColors{number, 0});
}

void Server::drop_failed_clients() {
  for (std::size_t slot = 0; slot < clients_.size(); ++slot)
    if (!clients_[slot].is_free() && !clients_[slot].drop_reason.empty())
      drop(slot, std::string(clients_[slot].drop_reason));
}

}  // namespace temblor::server
