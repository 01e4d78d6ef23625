#include "net/transport/server_endpoint.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "net/protocol/message_writer.h"
#include "net/transport/quakeworld.h"
#include "net/transport/send_to.h"
#include "net/wire/packet_header.h"

namespace temblor::net {
namespace {

// A connection request that repeats within this time is a resend, because our reply was lost.
constexpr double kRepeatedRequest_s = 2;
// A full server gives the place of a connection that has been silent for this time to a newcomer from the
// same host, which probably is the same player after a crash. Clients that load a level send something every
// five seconds.
constexpr double kReplaceableSilence_s = 10;

base::ByteVector make_server_message_bytes(const ServerMessage& message) {
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
      unverified_limits_(settings.unverified_peer_rates, settings.secret[0]) {
  CHECK(!sockets_.empty());
}

// Hands out all events of one packet before it reads the next: message_bytes_ holds the bytes of one message.
std::optional<ServerEvent> ServerEndpoint::next_event(double now_s) {
  now_s_ = now_s;
  while (events_read_ == events_.size()) {
    events_.clear();
    events_read_ = 0;
    if (packets_read_ >= settings_.max_packets_between_updates) return std::nullopt;
    const std::optional<ReceivedPacket> packet = receive();
    if (!packet) return std::nullopt;
    ++packets_read_;
    handle_packet(*packet);
  }
  return std::move(events_[events_read_++]);
}

void ServerEndpoint::update(double now_s) {
  now_s_ = now_s;
  packets_read_ = 0;
  half_open_.remove_older_than(settings_.half_open_timeout_s, now_s);
  for (HalfOpen& half_open : half_open_.entries())
    half_open.channel.update(now_s, SendTo{*sockets_[half_open.socket], half_open.address});
  disconnect_resender_.update(now_s);
  // drop() removes connections, so it must not run inside the loop.
  std::vector<ConnectionId> silent, without_answer, garbled;
  for (Connection& connection : connections_) {
    connection.channel.update(now_s, SendTo{*sockets_[connection.peer.socket], connection.peer.address});
    if (now_s - connection.last_received_s > settings_.timeout_s)
      silent.push_back(connection.id);
    else if (!answers_in_time(connection))
      without_answer.push_back(connection.id);
    else if (sends_only_garbage(connection))
      garbled.push_back(connection.id);
  }
  for (const ConnectionId id : silent) drop(id, "timed out");
  for (const ConnectionId id : without_answer) drop(id, "does not answer");
  for (const ConnectionId id : garbled) drop(id, "sends unreadable packets");
}

base::Status ServerEndpoint::send_reliable(ConnectionId connection, base::Bytes message) {
  Connection* found = find(connection);
  if (found == nullptr) return base::error(base::ErrorCode::kNotFound, "the connection has ended");
  if (!found->first_message_s) found->first_message_s = now_s_;
  return found->channel.send_reliable(message, now_s_,
                                      SendTo{*sockets_[found->peer.socket], found->peer.address});
}

base::Status ServerEndpoint::send_unreliable(ConnectionId connection, base::Bytes message) {
  Connection* found = find(connection);
  if (found == nullptr) return base::error(base::ErrorCode::kNotFound, "the connection has ended");
  return found->channel.send_unreliable(message, SendTo{*sockets_[found->peer.socket], found->peer.address});
}

void ServerEndpoint::send_notice(ConnectionId connection, std::string_view text) {
  if (const Connection* found = find(connection))
    sockets_[found->peer.socket]->send(found->peer.address, make_quakeworld_print(text));
}

bool ServerEndpoint::can_send_reliable(ConnectionId connection) const {
  const Connection* found = find(connection);
  return found != nullptr && found->channel.can_send_reliable();
}

void ServerEndpoint::disconnect(ConnectionId connection, std::string_view reason) {
  const auto belongs_to_it = [&](const ServerEvent& event) {
    const auto* message = std::get_if<PeerMessage>(&event);
    const auto* connected = std::get_if<PeerConnected>(&event);
    return (message != nullptr && message->connection == connection) ||
           (connected != nullptr && connected->connection == connection);
  };
  const auto unread = events_.begin() + static_cast<std::ptrdiff_t>(events_read_);
  events_.erase(std::remove_if(unread, events_.end(), belongs_to_it), events_.end());
  close_connection(connection, reason);
}

void ServerEndpoint::disconnect_all(std::string_view reason) {
  while (!connections_.empty()) disconnect(connections_.back().id, reason);
}

void ServerEndpoint::set_protocol(Protocol protocol) {
  protocol_ = protocol;
  for (Connection& connection : connections_)
    connection.channel.set_sent_limits(
        message_limits_for(protocol, find_peer_place(connection.peer.address)));
}

MessageLimits ServerEndpoint::message_limits(ConnectionId connection) const {
  const Connection* found = find(connection);
  return found == nullptr ? message_limits_for(protocol_, PeerPlace::kNetwork) : found->channel.sent_limits();
}

void ServerEndpoint::ban(const AddressPrefix& prefix) {
  if (std::find(bans_.begin(), bans_.end(), prefix) == bans_.end()) bans_.push_back(prefix);
  std::vector<ConnectionId> banned;
  for (const Connection& connection : connections_)
    if (prefix.contains(connection.peer.address)) banned.push_back(connection.id);
  for (const ConnectionId id : banned) drop(id, "banned");
}

bool ServerEndpoint::unban(const AddressPrefix& prefix) {
  return std::erase(bans_, prefix) > 0;
}

bool ServerEndpoint::admit_remote_command(const platform::Address& from, std::string_view password,
                                          double now_s) {
  if (!unverified_limits_.admit_password(from, now_s)) return false;
  if (equal_in_constant_time(password, remote_password_)) return true;
  unverified_limits_.record_wrong_password(from, now_s);
  return false;
}

void ServerEndpoint::reply_to_remote_command(const RemoteCommand& command, std::string_view text) {
  constexpr std::size_t kPieceBytes = 1024;
  text = text.substr(0, std::min(kMaxRemoteReplyBytes, text.find('\0')));
  for (; !text.empty(); text.remove_prefix(std::min(kPieceBytes, text.size())))
    send_control({command.from, command.socket}, RemoteCommandReply{text.substr(0, kPieceBytes)});
}

std::optional<platform::Address> ServerEndpoint::peer_address(ConnectionId connection) const {
  const Connection* found = find(connection);
  return found == nullptr ? std::nullopt : std::optional(found->peer.address);
}

std::optional<double> ServerEndpoint::last_packet_s(ConnectionId connection) const {
  const Connection* found = find(connection);
  return found == nullptr ? std::nullopt : std::optional(found->last_received_s);
}

const Channel* ServerEndpoint::find_channel(ConnectionId connection) const {
  const Connection* found = find(connection);
  return found == nullptr ? nullptr : &found->channel;
}

std::optional<ServerEndpoint::ReceivedPacket> ServerEndpoint::receive() {
  // Round robin, so that a flood at one socket does not starve the others.
  for (std::size_t tried = 0; tried < sockets_.size(); ++tried) {
    const std::size_t socket = next_socket_;
    next_socket_ = (next_socket_ + 1) % sockets_.size();
    if (const auto datagram = sockets_[socket]->receive())
      return ReceivedPacket{{datagram->from, socket}, datagram->bytes};
  }
  return std::nullopt;
}

// An address has a connection, is half open, or is unknown. Control packets are handled in all three states.
void ServerEndpoint::handle_packet(const ReceivedPacket& packet) {
  ++statistics_.datagrams;
  if (is_control_packet(packet.bytes)) return handle_control(packet);
  if (Connection* connection = find(packet.from.address))
    return handle_connection_packet(*connection, packet.bytes);
  if (HalfOpen* half_open = half_open_.find(packet.from.address))
    return handle_half_open_packet(*half_open, packet.bytes);
  handle_unverified_packet(packet.from);
}

void ServerEndpoint::handle_control(const ReceivedPacket& packet) {
  const auto read = read_control_packet(packet.bytes);
  if (!read.ok()) {
    // Our own client asks every server whether it is one of QuakeWorld or DarkPlaces.
    if (is_status_request(packet.bytes)) return;
    ++statistics_.malformed;
    if (is_quakeworld_join(packet.bytes)) explain_to_quakeworld(packet.from, packet.bytes.size());
    return;
  }
  if (const auto* connect = std::get_if<ConnectRequest>(&*read))
    return handle_connect_request(packet.from, *connect, packet.bytes.size());
  if (const auto* command = std::get_if<RemoteCommandRequest>(&*read))
    return handle_remote_command(packet.from, *command);
  if (is_query(*read)) reply_to_query(packet.from, *read, packet.bytes.size());
}

void ServerEndpoint::handle_connect_request(const Peer& from, const ConnectRequest& request,
                                            std::size_t request_bytes) {
  if (is_banned(from.address)) return reject(from, "You are banned.\n", request_bytes);
  if (request.net_protocol != kNetProtocol) return reject(from, "Incompatible version.\n", request_bytes);
  if (!unverified_limits_.admit_connection_request(from.address, now_s_)) {
    ++statistics_.unanswered;
    return;
  }
  if (const Connection* connection = find(from.address)) {
    if (now_s_ - connection->accepted_s < kRepeatedRequest_s) return accept(from);
    // A client whose connection is alive does not request another one: the request is forged.
    if (now_s_ - connection->last_received_s < kRepeatedRequest_s) return;
    drop(connection->id, "reconnected");
  }
  if (half_open_.find(from.address) != nullptr) return accept(from);
  if (!can_take(from.address)) return reject(from, "Server is full.\n", request_bytes);
  start_handshake(from);
}

void ServerEndpoint::handle_remote_command(const Peer& from, const RemoteCommandRequest& request) {
  if (!admit_remote_command(from.address, request.password, now_s_)) {
    ++statistics_.unanswered;
    return;
  }
  const base::Bytes command = base::as_bytes(request.command);
  message_bytes_.assign(command.begin(), command.end());
  events_.push_back(RemoteCommand{from.address, from.socket, base::as_text(message_bytes_)});
}

void ServerEndpoint::reply_to_query(const Peer& to, const ControlPacket& query, std::size_t request_bytes) {
  const bool is_known = has_connection_of_host(to.address);
  if (!unverified_limits_.admit_query(to.address, is_known, now_s_)) {
    ++statistics_.unanswered;
    return;
  }
  const ServerDescription description = describe_();
  const std::string own_address = to_text(sockets_[to.socket]->local_address());
  if (const auto reply = make_query_reply(query, description, own_address))
    send_to_unverified_peer(to, *reply, request_bytes, is_known);
}

void ServerEndpoint::handle_connection_packet(Connection& connection, base::Bytes packet) {
  if (!connection.packets.spend(1, settings_.packets_per_connection, now_s_)) {
    ++statistics_.rate_limited;
    return;
  }
  const auto message = connection.channel.receive(
      packet, now_s_, SendTo{*sockets_[connection.peer.socket], connection.peer.address});
  if (!message.ok()) {
    if (message.error().code == base::ErrorCode::kTooLarge) return drop(connection.id, message.error().what);
    ++statistics_.malformed;
    ++connection.unreadable_packets;
    return;
  }
  connection.unreadable_packets = 0;
  connection.last_received_s = now_s_;
  if (message->has_value()) queue_message(connection.id, **message);
}

// The peer leaves the half-open state by an acknowledgment of svc_nop; with `challenge`, it must also return
// a cookie, which goes out at that moment. Earlier data is ignored without an acknowledgment, so that a
// client that missed svc_nop sends it again.
void ServerEndpoint::handle_half_open_packet(HalfOpen& half_open, base::Bytes packet) {
  const auto header = read_packet_header(packet);
  const bool is_probed = half_open.channel.acknowledged_fragments() > 0;
  if (header.ok() && header->kind != PacketKind::kAck && !is_probed) return;
  const auto message =
      half_open.channel.receive(packet, now_s_, SendTo{*sockets_[half_open.socket], half_open.address});
  if (!message.ok()) {
    ++statistics_.malformed;
    if (message.error().code == base::ErrorCode::kTooLarge) half_open_.remove(half_open.address);
    return;
  }
  if (half_open.channel.acknowledged_fragments() == 0) return;
  const ChannelMessage first_message = message->value_or(ChannelMessage{});
  if (!settings_.challenge || half_open.address.is_local()) return promote(half_open, first_message);
  if (half_open.cookie.empty()) return send_challenge(half_open);
  if (const auto rest = remove_challenge_reply(first_message.bytes, half_open.cookie))
    promote(half_open, {*rest, first_message.reliable});
}

void ServerEndpoint::send_challenge(HalfOpen& half_open) {
  half_open.cookie = make_challenge_cookie(settings_.secret, half_open.address, next_cookie_serial_++);
  const base::Status sent =
      half_open.channel.send_reliable(make_challenge_message(half_open.cookie), now_s_,
                                      SendTo{*sockets_[half_open.socket], half_open.address});
  CHECK(sent.ok());
}

void ServerEndpoint::handle_unverified_packet(const Peer& from) {
  ++statistics_.from_unknown_peers;
  disconnect_resender_.resend(from.address, now_s_, SendTo{*sockets_[from.socket], from.address});
}

// `first_message` may refer to the channel of `half_open`, so it is copied before the entry is removed.
void ServerEndpoint::promote(const HalfOpen& half_open, const ChannelMessage& first_message) {
  const Peer peer{half_open.address, half_open.socket};
  if (!can_take(peer.address)) {
    send_disconnect(peer, half_open.channel, "Server is full.");
  } else {
    if (connections_.size() >= settings_.max_connections)
      drop(find_replaceable(peer.address)->id, "replaced by a new connection from its address");
    const ConnectionId id{next_id_++};
    connections_.push_back({.id = id,
                            .peer = peer,
                            .channel = half_open.channel,
                            .accepted_s = half_open.began_s,
                            .last_received_s = now_s_,
                            .handshake_fragments = half_open.channel.acknowledged_fragments()});
    connections_.back().channel.set_sent_limits(message_limits_for(protocol_, find_peer_place(peer.address)));
    events_.push_back(PeerConnected{id, peer.address});
    if (!first_message.bytes.empty()) queue_message(id, first_message);
  }
  half_open_.remove(peer.address);
}

void ServerEndpoint::queue_message(ConnectionId connection, const ChannelMessage& message) {
  message_bytes_.assign(message.bytes.begin(), message.bytes.end());
  events_.push_back(PeerMessage{connection, message_bytes_, message.reliable});
}

void ServerEndpoint::start_handshake(const Peer& from) {
  HalfOpen* half_open = half_open_.add(from.address, from.socket, settings_.channel, now_s_);
  if (half_open == nullptr) {
    ++statistics_.unanswered;
    return;
  }
  disconnect_resender_.forget(from.address);
  accept(from);
  const base::Status sent = half_open->channel.send_reliable(make_server_message_bytes(Nop{}), now_s_,
                                                             SendTo{*sockets_[from.socket], from.address});
  CHECK(sent.ok());
}

void ServerEndpoint::accept(const Peer& to) {
  const std::uint16_t own_port = sockets_[to.socket]->local_address().port;
  const bool is_behind_nat = settings_.announced_port != 0 && !to.address.is_local();
  send_control(to, AcceptReply{is_behind_nat ? settings_.announced_port : own_port});
}

void ServerEndpoint::reject(const Peer& to, std::string_view reason, std::size_t request_bytes) {
  const bool is_known = has_connection_of_host(to.address);
  if (unverified_limits_.admit_query(to.address, is_known, now_s_))
    send_to_unverified_peer(to, RejectReply{reason}, request_bytes, is_known);
  else
    ++statistics_.unanswered;
}

void ServerEndpoint::send_to_unverified_peer(const Peer& to, const ControlPacket& reply,
                                             std::size_t request_bytes, bool is_known) {
  const auto bytes = write_control_packet(reply);
  if (!bytes.ok()) return;  // a name contains a zero byte
  send_bytes_to_unverified_peer(to, *bytes, request_bytes, is_known);
}

void ServerEndpoint::send_bytes_to_unverified_peer(const Peer& to, base::Bytes bytes,
                                                   std::size_t request_bytes, bool is_known) {
  if (unverified_limits_.admit_reply(to.address, request_bytes, bytes.size(), is_known, now_s_))
    sockets_[to.socket]->send(to.address, bytes);
  else
    ++statistics_.unanswered;
}

// The client prints it, and would otherwise wait in silence.
void ServerEndpoint::explain_to_quakeworld(const Peer& to, std::size_t request_bytes) {
  const bool is_known = has_connection_of_host(to.address);
  if (!unverified_limits_.admit_query(to.address, is_known, now_s_)) {
    ++statistics_.unanswered;
    return;
  }
  send_bytes_to_unverified_peer(
      to,
      make_quakeworld_print(
          "This is a Quake server. QuakeWorld clients cannot join it: use a Quake client.\n"),
      request_bytes, is_known);
}

void ServerEndpoint::send_control(const Peer& to, const ControlPacket& packet) {
  const auto bytes = write_control_packet(packet);
  CHECK(bytes.ok(), "{}", bytes.error().message());
  sockets_[to.socket]->send(to.address, *bytes);
}

void ServerEndpoint::close_connection(ConnectionId connection, std::string_view reason) {
  const auto found = std::find_if(connections_.begin(), connections_.end(),
                                  [&](const Connection& c) { return c.id == connection; });
  if (found == connections_.end()) return;
  Connection ended = std::move(*found);
  connections_.erase(found);
  send_disconnect(ended.peer, std::move(ended.channel), reason);
}

void ServerEndpoint::drop(ConnectionId connection, std::string_view reason) {
  const std::optional<platform::Address> address = peer_address(connection);
  CHECK(address.has_value());
  close_connection(connection, reason);
  events_.push_back(PeerDisconnected{connection, *address, std::string(reason)});
}

void ServerEndpoint::send_disconnect(const Peer& peer, Channel channel, std::string_view reason) {
  disconnect_resender_.send(peer.address, std::move(channel), reason, now_s_,
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

// The one that has been silent for longest.
const ServerEndpoint::Connection* ServerEndpoint::find_replaceable(const platform::Address& newcomer) const {
  const Connection* found = nullptr;
  for (const Connection& candidate : connections_) {
    const bool is_silent = now_s_ - candidate.last_received_s >= kReplaceableSilence_s;
    if (!is_silent || newcomer.is_local() || !candidate.peer.address.same_host(newcomer)) continue;
    if (found == nullptr || candidate.last_received_s < found->last_received_s) found = &candidate;
  }
  return found;
}

bool ServerEndpoint::can_take(const platform::Address& newcomer) const {
  return connections_.size() < settings_.max_connections || find_replaceable(newcomer) != nullptr;
}

// A player in this process may stop, for example in a debugger.
bool ServerEndpoint::answers_in_time(const Connection& connection) const {
  if (connection.peer.address.is_local() || !connection.first_message_s) return true;
  return connection.channel.acknowledged_fragments() != connection.handshake_fragments ||
         now_s_ - *connection.first_message_s <= settings_.answer_timeout_s;
}

// A client that loads a level is silent, but sends nothing unreadable. A few such packets may be forged.
bool ServerEndpoint::sends_only_garbage(const Connection& connection) const {
  constexpr std::size_t kMinPackets = 5;
  return connection.unreadable_packets >= kMinPackets &&
         now_s_ - connection.last_received_s > settings_.garbage_timeout_s;
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
