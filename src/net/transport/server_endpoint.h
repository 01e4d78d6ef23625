// A server's end of the wire: all its connections and all its strangers, over one UDP port (and, of a listen
// server, the loopback to its own player).
//
// A peer is host and port. A request to connect is answered with the port it came to, so that address
// translation and containers need one port alone. The peer then is half open: it gets a message of one byte
// that does nothing, and is a connection when it has acknowledged it or said anything itself. Nothing larger
// than its own question is sent to a peer until then, but for answers to queries, which have budgets
// (net/transport/admission/unverified_peer_limits.h).
//
// The endpoint reads no clock: every call that needs it is given the time, in seconds, that does not go back.
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

// Of one endpoint; none is given twice.
enum class ConnectionId : std::uint32_t {};

struct ServerEndpointSettings {
  std::size_t max_connections = 16;
  double timeout_s = 300;   // a connection that is silent for longer ends
  double half_open_s = 10;  // one that shows no sign of life at all
  // Told to clients instead of the socket's own where a translation of addresses gives the server another.
  std::uint16_t announced_port = 0;
  // Limits of what is sent follow from the protocol that the server speaks: set_protocol().
  ChannelSettings channel{.max_received_bytes = 8192};
  Rate packets_of_connection{1000, 500};           // further ones are dropped unread
  std::size_t max_packets_between_updates = 8192;  // the rest waits
  UnverifiedPeerRates strangers{};
  // Whether a peer must also say a word that was sent to it (net/transport/admission/challenge.h) before the
  // game hears of it: its first acknowledgement can be guessed, by a forger who would have a victim played
  // to. Costs a round trip. Needs clients that know the console's `cmd`, as stock ones do.
  bool challenge = false;
  // From the system's source of chance; anything in tests.
  Secret secret{};
};

struct PeerConnected {
  ConnectionId connection{};
  platform::Address address;
};
// `bytes` are valid until the next call of next_event().
struct PeerMessage {
  ConnectionId connection{};
  base::Bytes bytes;
  bool reliable = false;
};
// Not for those that the owner disconnected itself.
struct PeerDisconnected {
  ConnectionId connection{};
  platform::Address address;
  std::string reason;
};
// A console line from somebody who knew the password. `command` is valid until the next call of next_event().
struct RemoteCommand {
  platform::Address from;
  std::size_t socket = 0;
  std::string_view command;
};
using ServerEvent = std::variant<PeerConnected, PeerMessage, PeerDisconnected, RemoteCommand>;

struct ServerEndpointStatistics {
  std::uint64_t datagrams = 0;
  std::uint64_t malformed = 0;       // neither control packets nor a connection's
  std::uint64_t from_strangers = 0;  // packets of connections that are not there
  std::uint64_t unanswered = 0;      // requests and queries over the limits
  std::uint64_t flooded = 0;         // packets of connections over their rate
};

class ServerEndpoint {
 public:
  using Sockets = std::vector<std::unique_ptr<platform::DatagramSocket>>;
  using Describe = std::function<ServerDescription()>;

  // `sockets`: one or more. `describe` is asked when a query is to be answered.
  ServerEndpoint(Sockets sockets, const ServerEndpointSettings& settings, Describe describe);

  // The next thing that happened, in order; nothing when the sockets are empty or enough was read until
  // update(). Call it until then, every tick.
  std::optional<ServerEvent> next_event(double now_s);
  // Sends again, gives up who is silent. Call it once a tick.
  void update(double now_s);

  // kNotFound for a connection that has ended (its event may not have been read yet), else as Channel's. An
  // error of send_reliable() means that the peer cannot go on: disconnect it.
  base::Status send_reliable(ConnectionId connection, base::Bytes message);
  base::Status send_unreliable(ConnectionId connection, base::Bytes message);
  // False for a connection that has ended.
  bool can_send_reliable(ConnectionId connection) const;
  // Tells the peer, with the reason unless it is empty, and forgets it. Nothing for one that has ended.
  void disconnect(ConnectionId connection, std::string_view reason);
  // Everybody, as when the server ends.
  void disconnect_all(std::string_view reason);

  // Seconds of silence after which a connection ends, from here on.
  void set_timeout(double timeout_s) { settings_.timeout_s = timeout_s; }
  // What peers take in one message, from here on (limits_of).
  void set_protocol(Protocol protocol);
  MessageLimits limits_to(ConnectionId connection) const;

  // Hosts that are kept out; those of them that play are disconnected, with an event. Adding one twice does
  // nothing.
  void ban(const AddressPrefix& prefix);
  // Whether it was there.
  bool unban(const AddressPrefix& prefix);
  const std::vector<AddressPrefix>& bans() const { return bans_; }

  // Empty, as at first: there are no remote commands.
  void set_remote_password(std::string_view password) { remote_password_ = password; }
  // For the same password said over a connection ("rcon PASSWORD COMMAND" as a console line, which stock
  // clients send with `cmd rcon ...`). Constant time; wrong ones are limited for each host.
  bool admits_remote_command(const platform::Address& from, std::string_view password, double now_s);
  // At most kMaxRemoteReplyBytes; the rest is left out.
  static constexpr std::size_t kMaxRemoteReplyBytes = 8 * 1024;
  void reply_to_remote_command(const RemoteCommand& command, std::string_view text);

  std::size_t connections() const { return connections_.size(); }
  std::optional<platform::Address> address_of(ConnectionId connection) const;
  // Null for one that has ended; valid until the next call that is not const.
  const Channel* channel_of(ConnectionId connection) const;
  const ServerEndpointStatistics& statistics() const { return statistics_; }
  // Of the socket at this place in what the constructor was given.
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
    double accepted_s = 0, heard_s = 0;
    TokenBucket packets{};
  };
  struct Arrived {
    Peer from;
    base::Bytes bytes;
  };

  std::optional<Arrived> receive();
  void take(const Arrived& packet);
  void take_control(const Arrived& packet);
  void take_connect_request(const Peer& from, const ConnectRequest& request, std::size_t question_bytes);
  void take_remote_command(const Peer& from, const RemoteCommandRequest& request);
  void answer_query(const Peer& to, const ControlPacket& query, std::size_t question_bytes);
  void take_from_connection(Connection& connection, base::Bytes packet);
  void take_from_half_open(HalfOpen& half_open, base::Bytes packet);
  void ask_for_word(HalfOpen& half_open);
  void handle_unverified_packet(const Peer& from);
  // Makes it a connection, which has said this (if it is not empty); or tells it that there is no place.
  void promote(const HalfOpen& half_open, const ChannelMessage& said);
  void keep_message(ConnectionId connection, const ChannelMessage& message);

  void open_half(const Peer& from);
  void accept(const Peer& to);
  void reject(const Peer& to, std::string_view reason, std::size_t question_bytes);
  // An answer within the budgets.
  void send_to_unverified_peer(const Peer& to, const ControlPacket& answer, std::size_t question_bytes,
                               bool is_known);
  void send_control(const Peer& to, const ControlPacket& packet);
  void end(ConnectionId connection, std::string_view reason);
  // Ends it, with an event.
  void lose(ConnectionId connection, std::string_view reason);
  void say_farewell(const Peer& peer, Channel channel, std::string_view reason);
  Connection* find(ConnectionId connection);
  const Connection* find(ConnectionId connection) const;
  Connection* find(const platform::Address& address);
  bool has_connection_of_host(const platform::Address& address) const;
  bool is_banned(const platform::Address& address) const;

  Sockets sockets_;
  ServerEndpointSettings settings_;
  Describe describe_;
  Protocol protocol_ = Protocol::kNetQuake;
  double now_s_ = 0;
  std::uint32_t next_id_ = 1;
  std::uint64_t next_word_ = 0;
  std::vector<Connection> connections_;
  HalfOpenTable half_open_;
  DisconnectResender disconnect_resender_;
  UnverifiedPeerLimits unverified_limits_;
  std::vector<AddressPrefix> bans_;
  std::string remote_password_;
  std::vector<ServerEvent> events_;  // those up to `events_read_` were given out
  std::size_t events_read_ = 0;
  base::ByteVector message_bytes_;  // of the PeerMessage or RemoteCommand among the events
  std::size_t packets_read_ = 0;    // since update()
  std::size_t next_socket_ = 0;     // to be read
  ServerEndpointStatistics statistics_;
};

}  // namespace temblor::net
