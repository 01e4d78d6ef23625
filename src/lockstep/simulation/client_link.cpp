#include "lockstep/simulation/client_link.h"

#include <utility>

#include "net/protocol/message_writer.h"
#include "net/protocol/numbered_moves.h"

namespace temblor::lockstep {
namespace {

// The simulation's server takes its own client to be connected at once, and sends it the level as fast as it
// can.
constexpr std::size_t kQueueBytes = 16 << 20;

net::ServerEndpoint::Sockets make_sockets(std::unique_ptr<platform::DatagramSocket> socket) {
  net::ServerEndpoint::Sockets sockets;
  sockets.push_back(std::move(socket));
  return sockets;
}

net::ServerEndpointSettings make_settings() {
  net::ServerEndpointSettings settings{.max_connections = 1};
  settings.channel.queue_bytes = kQueueBytes;
  // A client that loads a level is silent; the other peers notice one that is gone.
  settings.timeout_s = settings.answer_timeout_s = 3600;
  return settings;
}

}  // namespace

ClientLink::ClientLink(std::unique_ptr<platform::DatagramSocket> socket)
    : endpoint_(make_sockets(std::move(socket)), make_settings(), [] { return net::ServerDescription(); }) {}

void ClientLink::update(double now_s, net::Protocol protocol) {
  endpoint_.set_protocol(protocol);
  while (const std::optional<net::ServerEvent> event = endpoint_.next_event(now_s)) {
    if (const auto* connected = std::get_if<net::PeerConnected>(&*event))
      connection_ = connected->connection;
    else if (const auto* message = std::get_if<net::PeerMessage>(&*event))
      read_packet(message->bytes, protocol);
    else if (std::holds_alternative<net::PeerDisconnected>(*event))
      has_left_ = true;
  }
  send_waiting();
  endpoint_.update(now_s);
}

// A packet repeats the moves of the last ones, which have arrived: nothing is lost inside of a process. The
// snapshots that a client has are left out, so that the server sends whole ones.
void ClientLink::read_packet(base::Bytes packet, net::Protocol protocol) {
  net::ClientMessageReader reader(packet, protocol);
  std::vector<net::Move> moves;
  std::uint32_t last_number = 0;
  while (true) {
    const auto message = reader.next();
    if (!message.ok() || !message->has_value()) break;
    if (const auto* move = std::get_if<net::Move>(&**message)) {
      moves.push_back(*move);
    } else if (const auto* command = std::get_if<net::StringCommand>(&**message)) {
      if (const auto head = net::read_numbered_packet(command->text))
        last_number = head->last_move;
      else
        commands_.emplace_back(command->text);
    } else if (std::holds_alternative<net::Disconnect>(**message)) {
      has_left_ = true;
    }
  }
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const std::uint32_t number =
        last_number == 0 ? 0 : last_number - static_cast<std::uint32_t>(moves.size() - 1 - i);
    if (number != 0 && number <= last_number_) continue;
    moves_.push_back({number, moves[i]});
    if (number != 0) last_number_ = number;
  }
}

// Moves of one input are either numbered one after the other, or have no numbers.
ClientInput ClientLink::take_input() {
  ClientInput input;
  if (std::exchange(is_leave_taken_, has_left_)) return input;
  while (!moves_.empty() && input.moves.size() < kMaxMovesInTick) {
    const auto& [number, move] = moves_.front();
    if (!input.moves.empty() && number != (input.last_number == 0 ? 0 : input.last_number + 1)) break;
    input.last_number = number;
    input.moves.push_back(move);
    moves_.pop_front();
  }
  std::size_t bytes = 0;
  while (!commands_.empty() && input.commands.size() < kMaxCommandsInTick) {
    bytes += commands_.front().size();
    if (bytes > kMaxCommandBytesInTick && !input.commands.empty()) break;
    input.commands.push_back(std::move(commands_.front()));
    commands_.pop_front();
  }
  input.leaves = has_left_;
  return input;
}

void ClientLink::forward(std::span<const MessageForClient> messages) {
  for (const MessageForClient& message : messages) {
    if (message.is_reliable)
      waiting_.push_back(message.bytes);
    else if (connection_)
      static_cast<void>(endpoint_.send_unreliable(*connection_, message.bytes));
  }
  send_waiting();
}

// After an error the connection has ended, or its client does not read; both show as has_left().
void ClientLink::send_waiting() {
  if (!connection_) return;
  for (const base::ByteVector& message : std::exchange(waiting_, {}))
    if (!endpoint_.send_reliable(*connection_, message).ok()) has_left_ = true;
}

void ClientLink::print(std::string_view text) {
  base::ByteWriter message;
  static_cast<void>(net::write_message(net::Print{text}, {}, message));
  waiting_.push_back(message.view());
  send_waiting();
}

void ClientLink::end(std::string_view reason) {
  if (connection_) endpoint_.disconnect(*connection_, reason);
  has_left_ = true;
}

}  // namespace temblor::lockstep
