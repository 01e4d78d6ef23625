#include "net/transport/server_endpoint.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "net/protocol/message_writer.h"
#include "net/transport/send_to.h"
#include "net/wire/packet_header.h"

namespace temblor::net {
namespace {

// A request to connect that comes again this soon is a repetition: the answer to the first was lost.
constexpr double kRepeatedRequest_s = 2;

base::ByteVector server_message_bytes(const ServerMessage& message) {
  base::ByteWriter writer;
  const base::Status status = write_message(message, Dialect{}, writer);
  CHECK(status.ok(), "{}", status.error().message());
  return std::move(writer).take();
}

}  // namespace

ServerEndpoint::ServerEndpoint(Sockets sockets, const ServerEndpointSettings& settings, Describe describe)
    : sockets_(std::move(sockets)),
      settings_(settings),
      describe_(std::move(describe)),
      unverified_limits_(settings.strangers, settings.secret[0]) {
  CHECK(!sockets_.empty());
}

std::optional<ServerEvent> ServerEndpoint::next_event(double now_s) {
  now_s_ = now_s;
  while (events_read_ == events_.size()) {
    events_.clear();
    events_read_ = 0;
    if (packets_read_ >= settings_.max_packets_between_updates) return std::nullopt;
    const std::optional<Arrived> packet = receive();
    if (!packet) return std::nullopt;
    ++packets_read_;
    take(*packet);
  }
  return std::move(events_[events_read_++]);
}

void ServerEndpoint::update(double now_s) {
  now_s_ = now_s;
  packets_read_ = 0;
  half_open_.remove_older_than(settings_.half_open_s, now_s);
  for (HalfOpen& half_open : half_open_.entries())
    half_open.channel.update(now_s, SendTo{*sockets_[half_open.socket], half_open.address});
  disconnect_resender_.update(now_s);
  std::vector<ConnectionId> silent;
  for (Connection& connection : connections_) {
    connection.channel.update(now_s, SendTo{*sockets_[connection.peer.socket], connection.peer.address});
    if (now_s - connection.heard_s > settings_.timeout_s) silent.push_back(connection.id);
  }
  for (const ConnectionId id : silent) lose(id, "timed out");
}

base::Status ServerEndpoint::send_reliable(ConnectionId connection, base::Bytes message) {
  Connection* found = find(connection);
  if (found == nullptr) return base::error(base::ErrorCode::kNotFound, "the connection has ended");
  return found->channel.send_reliable(message, now_s_,
                                      SendTo{*sockets_[found->peer.socket], found->peer.address});
}

base::Status ServerEndpoint::send_unreliable(ConnectionId connection, base::Bytes message) {
  Connection* found = find(connection);
  if (found == nullptr) return base::error(base::ErrorCode::kNotFound, "the connection has ended");
  return found->channel.send_unreliable(message, SendTo{*sockets_[found->peer.socket], found->peer.address});
}

bool ServerEndpoint::can_send_reliable(ConnectionId connection) const {
  const Connection* found = find(connection);
  return found != nullptr && found->channel.can_send_reliable();
}

void ServerEndpoint::disconnect(ConnectionId connection, std::string_view reason) {
  const auto is_of_it = [&](const ServerEvent& event) {
    const auto* message = std::get_if<PeerMessage>(&event);
    const auto* connected = std::get_if<PeerConnected>(&event);
    return (message != nullptr && message->connection == connection) ||
           (connected != nullptr && connected->connection == connection);
  };
  const auto unread = events_.begin() + static_cast<std::ptrdiff_t>(events_read_);
  events_.erase(std::remove_if(unread, events_.end(), is_of_it), events_.end());
  end(connection, reason);
}

void ServerEndpoint::disconnect_all(std::string_view reason) {
  while (!connections_.empty()) disconnect(connections_.back().id, reason);
}

void ServerEndpoint::set_protocol(Protocol protocol) {
  protocol_ = protocol;
  for (Connection& connection : connections_)
    connection.channel.set_sent_limits(limits_of(protocol, connection.peer.address.is_local()));
}

MessageLimits ServerEndpoint::limits_to(ConnectionId connection) const {
  const Connection* found = find(connection);
  return found == nullptr ? limits_of(protocol_, false) : found->channel.sent_limits();
}

void ServerEndpoint::ban(const AddressPrefix& prefix) {
  if (std::find(bans_.begin(), bans_.end(), prefix) == bans_.end()) bans_.push_back(prefix);
  std::vector<ConnectionId> banned;
  for (const Connection& connection : connections_)
    if (prefix.contains(connection.peer.address)) banned.push_back(connection.id);
  for (const ConnectionId id : banned) lose(id, "banned");
}

bool ServerEndpoint::unban(const AddressPrefix& prefix) {
  return std::erase(bans_, prefix) > 0;
}

bool ServerEndpoint::admits_remote_command(const platform::Address& from, std::string_view password,
                                           double now_s) {
  if (!unverified_limits_.admit_password(from, now_s)) return false;
  if (equal_in_constant_time(password, remote_password_)) return true;
  unverified_limits_.wrong_password(from, now_s);
  return false;
}

void ServerEndpoint::reply_to_remote_command(const RemoteCommand& command, std::string_view text) {
  constexpr std::size_t kPieceBytes = 1024;
  text = text.substr(0, std::min(kMaxRemoteReplyBytes, text.find('\0')));
  for (; !text.empty(); text.remove_prefix(std::min(kPieceBytes, text.size())))
    send_control({command.from, command.socket}, RemoteCommandReply{text.substr(0, kPieceBytes)});
}

std::optional<platform::Address> ServerEndpoint::address_of(ConnectionId connection) const {
  const Connection* found = find(connection);
  return found == nullptr ? std::nullopt : std::optional(found->peer.address);
}

const Channel* ServerEndpoint::channel_of(ConnectionId connection) const {
  const Connection* found = find(connection);
  return found == nullptr ? nullptr : &found->channel;
}

std::optional<ServerEndpoint::Arrived> ServerEndpoint::receive() {
  // In turns: a flood at one does not keep the others waiting.
  for (std::size_t tried = 0; tried < sockets_.size(); ++tried) {
    const std::size_t socket = next_socket_;
    next_socket_ = (next_socket_ + 1) % sockets_.size();
    if (const auto datagram = sockets_[socket]->receive())
      return Arrived{{datagram->from, socket}, datagram->bytes};
  }
  return std::nullopt;
}

void ServerEndpoint::take(const Arrived& packet) {
  ++statistics_.datagrams;
  if (is_control_packet(packet.bytes)) return take_control(packet);
  if (Connection* connection = find(packet.from.address))
    return take_from_connection(*connection, packet.bytes);
  if (HalfOpen* half_open = half_open_.find(packet.from.address))
    return take_from_half_open(*half_open, packet.bytes);
  handle_unverified_packet(packet.from);
}

void ServerEndpoint::take_control(const Arrived& packet) {
  const auto read = read_control_packet(packet.bytes);
  if (!read.ok()) {
    ++statistics_.malformed;
    return;
  }
  if (const auto* connect = std::get_if<ConnectRequest>(&*read))
    return take_connect_request(packet.from, *connect, packet.bytes.size());
  if (const auto* command = std::get_if<RemoteCommandRequest>(&*read))
    return take_remote_command(packet.from, *command);
  if (is_query(*read)) answer_query(packet.from, *read, packet.bytes.size());
}

void ServerEndpoint::take_connect_request(const Peer& from, const ConnectRequest& request,
                                          std::size_t question_bytes) {
  if (is_banned(from.address)) return reject(from, "You are banned.\n", question_bytes);
  if (request.net_protocol != kNetProtocol) return reject(from, "Incompatible version.\n", question_bytes);
  if (!unverified_limits_.admit_connection_request(from.address, now_s_)) {
    ++statistics_.unanswered;
    return;
  }
  if (const Connection* connection = find(from.address)) {
    if (now_s_ - connection->accepted_s < kRepeatedRequest_s) return accept(from);
    // One that goes on with its old connection asks for no new one: somebody else wrote its address.
    if (now_s_ - connection->heard_s < kRepeatedRequest_s) return;
    lose(connection->id, "connects anew");
  }
  if (half_open_.find(from.address) != nullptr) return accept(from);
  if (connections_.size() >= settings_.max_connections)
    return reject(from, "Server is full.\n", question_bytes);
  open_half(from);
}

void ServerEndpoint::take_remote_command(const Peer& from, const RemoteCommandRequest& request) {
  if (!admits_remote_command(from.address, request.password, now_s_)) {
    ++statistics_.unanswered;
    return;
  }
  const base::Bytes command = base::as_bytes(request.command);
  message_bytes_.assign(command.begin(), command.end());
  events_.push_back(RemoteCommand{from.address, from.socket, base::as_text(message_bytes_)});
}

void ServerEndpoint::answer_query(const Peer& to, const ControlPacket& query, std::size_t question_bytes) {
  const bool is_known = has_connection_of_host(to.address);
  if (!unverified_limits_.admit_query(to.address, is_known, now_s_)) {
    ++statistics_.unanswered;
    return;
  }
  const ServerDescription description = describe_();
  const std::string own_address = to_text(sockets_[to.socket]->local_address());
  if (const auto answer = answer_to(query, description, own_address))
    send_to_unverified_peer(to, *answer, question_bytes, is_known);
}

void ServerEndpoint::take_from_connection(Connection& connection, base::Bytes packet) {
  if (!connection.packets.take(1, settings_.packets_of_connection, now_s_)) {
    ++statistics_.flooded;
    return;
  }
  const auto message = connection.channel.receive(
      packet, now_s_, SendTo{*sockets_[connection.peer.socket], connection.peer.address});
  if (!message.ok()) {
    if (message.error().code == base::ErrorCode::kTooLarge) return lose(connection.id, message.error().what);
    ++statistics_.malformed;
    return;
  }
  connection.heard_s = now_s_;
  if (message->has_value()) keep_message(connection.id, **message);
}

void ServerEndpoint::take_from_half_open(HalfOpen& half_open, base::Bytes packet) {
  const auto message =
      half_open.channel.receive(packet, now_s_, SendTo{*sockets_[half_open.socket], half_open.address});
  if (!message.ok()) {
    ++statistics_.malformed;
    if (message.error().code == base::ErrorCode::kTooLarge) half_open_.remove(half_open.address);
    return;
  }
  if (!message->has_value() && !half_open.channel.can_send_reliable()) return;  // no sign of life
  const ChannelMessage said = message->value_or(ChannelMessage{});
  if (!settings_.challenge || half_open.address.is_local()) return promote(half_open, said);
  if (half_open.word.empty()) return ask_for_word(half_open);
  if (const auto rest = without_word(said.bytes, half_open.word)) promote(half_open, {*rest, said.reliable});
}

void ServerEndpoint::ask_for_word(HalfOpen& half_open) {
  half_open.word = challenge_word(settings_.secret, half_open.address, next_word_++);
  const base::Status sent = half_open.channel.send_reliable(
      challenge_message(half_open.word), now_s_, SendTo{*sockets_[half_open.socket], half_open.address});
  CHECK(sent.ok());
}

void ServerEndpoint::handle_unverified_packet(const Peer& from) {
  ++statistics_.from_strangers;
  disconnect_resender_.repeat(from.address, now_s_, SendTo{*sockets_[from.socket], from.address});
}

void ServerEndpoint::promote(const HalfOpen& half_open, const ChannelMessage& said) {
  const Peer peer{half_open.address, half_open.socket};
  if (connections_.size() >= settings_.max_connections) {
    say_farewell(peer, half_open.channel, "Server is full.");
  } else {
    const ConnectionId id{next_id_++};
    connections_.push_back({id, peer, half_open.channel, half_open.began_s, now_s_});
    connections_.back().channel.set_sent_limits(limits_of(protocol_, peer.address.is_local()));
    events_.push_back(PeerConnected{id, peer.address});
    if (!said.bytes.empty()) keep_message(id, said);
  }
  half_open_.remove(peer.address);
}

void ServerEndpoint::keep_message(ConnectionId connection, const ChannelMessage& message) {
  message_bytes_.assign(message.bytes.begin(), message.bytes.end());
  events_.push_back(PeerMessage{connection, message_bytes_, message.reliable});
}

void ServerEndpoint::open_half(const Peer& from) {
  HalfOpen* half_open = half_open_.add(from.address, from.socket, settings_.channel, now_s_);
  if (half_open == nullptr) {
    ++statistics_.unanswered;
    return;
  }
  disconnect_resender_.forget(from.address);
  accept(from);
  const base::Status sent = half_open->channel.send_reliable(server_message_bytes(Nop{}), now_s_,
                                                             SendTo{*sockets_[from.socket], from.address});
  CHECK(sent.ok());
}

void ServerEndpoint::accept(const Peer& to) {
  const std::uint16_t own_port = sockets_[to.socket]->local_address().port;
  const bool translated = settings_.announced_port != 0 && !to.address.is_local();
  send_control(to, AcceptReply{translated ? settings_.announced_port : own_port});
}

void ServerEndpoint::reject(const Peer& to, std::string_view reason, std::size_t question_bytes) {
  const bool is_known = has_connection_of_host(to.address);
  if (unverified_limits_.admit_query(to.address, is_known, now_s_))
    send_to_unverified_peer(to, RejectReply{reason}, question_bytes, is_known);
  else
    ++statistics_.unanswered;
}

void ServerEndpoint::send_to_unverified_peer(const Peer& to, const ControlPacket& answer,
                                             std::size_t question_bytes, bool is_known) {
  const auto bytes = write_control_packet(answer);
  if (!bytes.ok()) return;  // a name with a zero in it
  if (unverified_limits_.admit_answer(to.address, question_bytes, bytes->size(), is_known, now_s_))
    sockets_[to.socket]->send(to.address, *bytes);
  else
    ++statistics_.unanswered;
}

void ServerEndpoint::send_control(const Peer& to, const ControlPacket& packet) {
  const auto bytes = write_control_packet(packet);
  CHECK(bytes.ok(), "{}", bytes.error().message());
  sockets_[to.socket]->send(to.address, *bytes);
}

void ServerEndpoint::end(ConnectionId connection, std::string_view reason) {
  const auto found = std::find_if(connections_.begin(), connections_.end(),
                                  [&](const Connection& c) { return c.id == connection; });
  if (found == connections_.end()) return;
  Connection ended = std::move(*found);
  connections_.erase(found);
  say_farewell(ended.peer, std::move(ended.channel), reason);
}

void ServerEndpoint::lose(ConnectionId connection, std::string_view reason) {
  const std::optional<platform::Address> address = address_of(connection);
  CHECK(address.has_value());
  end(connection, reason);
  events_.push_back(PeerDisconnected{connection, *address, std::string(reason)});
}

void ServerEndpoint::say_farewell(const Peer& peer, Channel channel, std::string_view reason) {
  disconnect_resender_.say(peer.address, std::move(channel), reason, now_s_,
                           SendTo{*sockets_[peer.socket], peer.address});
}

ServerEndpoint::Connection* ServerEndpoint::find(ConnectionId connection) {
  for (Connection& candidate : connections_)
    if (candidate.id == connection) return &candidate;
  return nullptr;
}

const ServerEndpoint::Connection* ServerEndpoint::find(ConnectionId connection) const {
  for (const Connection& candidate : connections_)
    if (candidate.id == connection) return &candidate;
  return nullptr;
}

ServerEndpoint::Connection* ServerEndpoint::find(const platform::Address& address) {
  for (Connection& candidate : connections_)
    if (candidate.peer.address == address) return &candidate;
  return nullptr;
}

bool ServerEndpoint::has_connection_of_host(const platform::Address& address) const {
  return std::any_of(connections_.begin(), connections_.end(),
                     [&](const Connection& c) { return c.peer.address.same_host(address); });
}

bool ServerEndpoint::is_banned(const platform::Address& address) const {
  return std::any_of(bans_.begin(), bans_.end(),
                     [&](const AddressPrefix& prefix) { return prefix.contains(address); });
}

}  // namespace temblor::net
