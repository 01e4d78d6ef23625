// The server's end of all its connections, over one or more datagram sockets: a UDP port, and for a listen
// server also the loopback to its own player. It handles the handshake, one Channel per connection, queries,
// remote commands, bans, and rate limits. The game sees only the events and the send functions.
//
// A peer is an address and a port. Every peer starts unverified, because anybody can forge a sender address:
//
//   unverified --- CCREQ_CONNECT ---> half open --- ack ---> connection
//                  (CCREP_ACCEPT)     (svc_nop)     (and the cookie, if `challenge` is set)
//
// - CCREP_ACCEPT names the port that the request came to. All clients share this port, so NAT and containers
//   need to forward only one.
// - A half-open peer (admission/half_open.h) gets one reliable byte, svc_nop. Its acknowledgment shows that
//   the peer receives packets at this address. Until then the peer never gets a packet larger than its
//   request, except replies to queries, which have budgets (admission/unverified_peer_limits.h), and its data
//   is ignored: a client repeats what is reliable.
// - A connection has a rate limit for packets, and ends after timeout_s of silence. It must acknowledge
//   something of its first reliable message within answer_timeout_s. Clients do that before they load a
//   level. Unreadable packets end it after garbage_timeout_s without others.
// - Packets of ended connections are answered with the disconnect message again (disconnect_resender.h).
//
// The endpoint reads no clock: callers pass the time in seconds, which never goes back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "net/transport/admission/address_prefix.h"
#include "net/transport/admission/challenge.h"
#include "net/transport/admission/half_open.h"
#include "net/transport/admission/unverified_peer_limits.h"
#include "net/transport/channel.h"
#include "net/transport/control.h"
#include "net/transport/disconnect_resender.h"
#include "net/transport/server_description.h"
#include "platform/datagram_socket.h"

namespace temblor::net {

// Identifies a connection of one endpoint. Never reused.
enum class ConnectionId : std::uint32_t {};

struct ServerEndpointSettings {
  std::size_t max_connections = 16;
  double timeout_s = 300;           // ends a connection after this much silence
  double half_open_timeout_s = 10;  // forgets a half-open peer after this time
  double answer_timeout_s = 5;    // ends a connection that acknowledges nothing of its first reliable message
  double garbage_timeout_s = 10;  // ends a connection that sent only unreadable packets for this time
  // Port that CCREP_ACCEPT names instead of the socket's own; for servers behind NAT. 0: the socket's own
  // port.
  std::uint16_t announced_port = 0;
  // The limits of sent messages are those of the server's protocol: see set_protocol().
  ChannelSettings channel{.max_received_bytes = 8192};
  Rate packets_per_connection{1000, 500};          // excess packets are dropped unread
  std::size_t max_packets_between_updates = 8192;  // more packets wait in the socket
  UnverifiedPeerRates unverified_peer_rates{};
  // Whether a peer must also return a challenge cookie (admission/challenge.h) before it becomes a
  // connection. An attacker can guess the sequence number of the first acknowledgment, and so make the
  // server stream a game to a victim; it cannot guess the cookie. Costs one round trip. Works with all
  // clients that have the console command `cmd`, including stock ones.
  bool challenge = false;
  // Key for cookies and hash tables: from the system's random source, or fixed in tests.
  Secret secret{};
};

// A peer completed the handshake.
struct PeerConnected {
  ConnectionId connection{};
  platform::Address address;
};
// A message of a client. `bytes` are valid until the next call of next_event().
struct PeerMessage {
  ConnectionId connection{};
  base::Bytes bytes;
  bool reliable = false;
};
// A connection ended. Not sent for disconnect() and disconnect_all().
struct PeerDisconnected {
  ConnectionId connection{};
  platform::Address address;
  std::string reason;  // for the log, without a line end
};
// A remote command with the right password. `command` is valid until the next call of next_event().
struct RemoteCommand {
  platform::Address from;
  std::size_t socket = 0;
  std::string_view command;
};
using ServerEvent = std::variant<PeerConnected, PeerMessage, PeerDisconnected, RemoteCommand>;

// Counters since the start.
struct ServerEndpointStatistics {
  std::uint64_t datagrams = 0;
  std::uint64_t malformed = 0;           // not valid packets
  std::uint64_t from_unknown_peers = 0;  // packets that belong to no connection
  std::uint64_t unanswered = 0;          // requests and queries over the rate limits
  std::uint64_t rate_limited = 0;        // packets of connections over their rate limit
};

class ServerEndpoint {
 public:
  using Sockets = std::vector<std::unique_ptr<platform::DatagramSocket>>;
  // Describes the server for queries.
  using Describe = std::function<ServerDescription()>;

  // CHECKs that there is at least one socket. Calls `describe` for each query that it answers.
  ServerEndpoint(Sockets sockets, const ServerEndpointSettings& settings, Describe describe);

  // Returns the next event in order of arrival. Returns nullopt when the sockets are empty, or
  // max_packets_between_updates were read. Call it every tick until it returns nullopt.
  std::optional<ServerEvent> next_event(double now_s);
  // Resends overdue fragments and ends silent connections (with events). Call it once a tick.
  void update(double now_s);

  // Works like Channel's function; fails with kNotFound if the connection has ended (its event may still be
  // unread). After any other error of send_reliable() the client is missing a message: disconnect it.
  base::Status send_reliable(ConnectionId connection, base::Bytes message);
  base::Status send_unreliable(ConnectionId connection, base::Bytes message);
  // Sends a text outside of the connection, which DarkPlaces prints even after it has left.
  void send_notice(ConnectionId connection, std::string_view text);
  // Returns false if the connection has ended.
  bool can_send_reliable(ConnectionId connection) const;
  // Ends a connection, sends the peer the reason (unless it is empty), and discards its unread events. Does
  // nothing if the connection has ended.
  void disconnect(ConnectionId connection, std::string_view reason);
  // Ends all connections, for example at shutdown.
  void disconnect_all(std::string_view reason);

  // Changes ServerEndpointSettings::timeout_s.
  void set_timeout(double timeout_s) { settings_.timeout_s = timeout_s; }
  // Connections above the limit stay.
  void set_max_connections(std::size_t count) { settings_.max_connections = count; }
  // Applies the message limits of `protocol` to all connections (message_limits_for()).
  void set_protocol(Protocol protocol);
  // Limits for messages to this connection; those of a remote peer if it has ended.
  MessageLimits message_limits(ConnectionId connection) const;

  // Rejects these hosts from now on, and drops their connections (with events). Adding a prefix twice is
  // harmless.
  void ban(const AddressPrefix& prefix);
  // Returns false if the prefix was not banned.
  bool unban(const AddressPrefix& prefix);
  const std::vector<AddressPrefix>& bans() const { return bans_; }

  // An empty password (the default) disables remote commands.
  void set_remote_password(std::string_view password) { remote_password_ = password; }
  // Checks a password that came over a connection: "rcon PASSWORD COMMAND" as a console line, which stock
  // clients send with `cmd rcon ...`. Takes constant time, and limits the rate of wrong passwords for each
  // host.
  bool admit_remote_command(const platform::Address& from, std::string_view password, double now_s);
  // Largest reply to a remote command; longer ones are truncated.
  static constexpr std::size_t kMaxRemoteReplyBytes = 8 * 1024;
  // Sends `text`, up to its first zero byte, in packets of 1024 bytes.
  void reply_to_remote_command(const RemoteCommand& command, std::string_view text);

  // Number of connections; half-open ones do not count.
  std::size_t connections() const { return connections_.size(); }
  // nullopt if the connection has ended.
  std::optional<platform::Address> peer_address(ConnectionId connection) const;
  // When the last packet of the connection arrived; nullopt if it has ended.
  std::optional<double> last_packet_s(ConnectionId connection) const;
  // Returns null if the connection has ended. Valid until the next non-const call.
  const Channel* find_channel(ConnectionId connection) const;
  const ServerEndpointStatistics& statistics() const { return statistics_; }
  // `socket`: index in the constructor's list.
  platform::Address local_address(std::size_t socket = 0) const { return sockets_[socket]->local_address(); }

 private:
  struct Peer {
    platform::Address address;
    std::size_t socket = 0;
  };
  struct Connection {
    ConnectionId id{};
    Peer peer;
    Channel channel;
    double accepted_s = 0, last_received_s = 0;
    TokenBucket packets{};
    std::uint32_t handshake_fragments = 0;    // acknowledged before it became a connection
    std::optional<double> first_message_s{};  // when its first reliable message was sent
    std::size_t unreadable_packets = 0;       // since last_received_s
  };
  struct ReceivedPacket {
    Peer from;
    base::Bytes bytes;
  };

  std::optional<ReceivedPacket> receive();
  void handle_packet(const ReceivedPacket& packet);
  void handle_control(const ReceivedPacket& packet);
  void handle_connect_request(const Peer& from, const ConnectRequest& request, std::size_t request_bytes);
  void handle_remote_command(const Peer& from, const RemoteCommandRequest& request);
  void reply_to_query(const Peer& to, const ControlPacket& query, std::size_t request_bytes);
  void handle_connection_packet(Connection& connection, base::Bytes packet);
  void handle_half_open_packet(HalfOpen& half_open, base::Bytes packet);
  void send_challenge(HalfOpen& half_open);
  void handle_unverified_packet(const Peer& from);
  // Turns a half-open peer into a connection and queues its first message, unless that is empty. Disconnects
  // it if the server is full.
  void promote(const HalfOpen& half_open, const ChannelMessage& first_message);
  void queue_message(ConnectionId connection, const ChannelMessage& message);

  void start_handshake(const Peer& from);
  void accept(const Peer& to);
  void reject(const Peer& to, std::string_view reason, std::size_t request_bytes);
  // Sends a reply if the budgets allow it.
  void send_to_unverified_peer(const Peer& to, const ControlPacket& reply, std::size_t request_bytes,
                               bool is_known);
  void send_bytes_to_unverified_peer(const Peer& to, base::Bytes bytes, std::size_t request_bytes,
                                     bool is_known);
  void explain_to_quakeworld(const Peer& to, std::size_t request_bytes);
  void send_control(const Peer& to, const ControlPacket& packet);
  // Ends a connection, without an event.
  void close_connection(ConnectionId connection, std::string_view reason);
  // Ends a connection, with an event.
  void drop(ConnectionId connection, std::string_view reason);
  // Sends the disconnect message over the channel of an ended connection.
  void send_disconnect(const Peer& peer, Channel channel, std::string_view reason);
  Connection* find(ConnectionId connection);
  const Connection* find(ConnectionId connection) const;
  Connection* find(const platform::Address& address);
  // The connection that gives its place to a newcomer from this address. Null if there is none.
  const Connection* find_replaceable(const platform::Address& newcomer) const;
  bool can_take(const platform::Address& newcomer) const;
  bool answers_in_time(const Connection& connection) const;
  bool sends_only_garbage(const Connection& connection) const;
  bool has_connection_of_host(const platform::Address& address) const;
  bool is_banned(const platform::Address& address) const;

  Sockets sockets_;
  ServerEndpointSettings settings_;
  Describe describe_;
  Protocol protocol_ = Protocol::kNetQuake;
  double now_s_ = 0;
  std::uint32_t next_id_ = 1;
  std::uint64_t next_cookie_serial_ = 0;
  std::vector<Connection> connections_;
  HalfOpenTable half_open_;
  DisconnectResender disconnect_resender_;
  UnverifiedPeerLimits unverified_limits_;
  std::vector<AddressPrefix> bans_;
  std::string remote_password_;
  std::vector<ServerEvent> events_;  // before events_read_: already returned
  std::size_t events_read_ = 0;
  base::ByteVector message_bytes_;  // of the PeerMessage or RemoteCommand in events_
  std::size_t packets_read_ = 0;    // since the last update()
  std::size_t next_socket_ = 0;     // to be read next
  ServerEndpointStatistics statistics_;
};

}  // namespace temblor::net
