// The client's end of a connection: the handshake with a server, then one Channel over a datagram socket.
//
//   client                           server
//     | -- CCREQ_CONNECT ------------> |   every request_every_s, at most `requests` times
//     | <----------- CCREP_ACCEPT port |   or CCREP_REJECT reason
//     | -- clc_nop (unreliable) -----> |   opens the client's NAT for a new server port
//     | <== channel =================> |   until disconnect() or timeout_s of silence
//
// Works with servers that keep one port for everyone (Temblor) and with servers that open a port for each
// client (stock). Reads no clock: callers pass the time in seconds, which never goes back.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "net/protocol/client_message.h"
#include "net/transport/channel.h"
#include "platform/datagram_socket.h"

namespace temblor::net {

struct ClientEndpointSettings {
  int requests = 3;              // connection requests before giving up
  double request_every_s = 2.5;  // between two requests
  double timeout_s = 300;        // ends the connection after this much silence; never for a local server
  ChannelSettings channel{};
};

// The server accepted the connection.
struct Connected {};
// A message from the server. `bytes` are valid until the next call of next_event().
struct FromServer {
  base::Bytes bytes;
  bool reliable = false;
};
// How long the server has sent nothing, in seconds, and how long until the connection ends for that reason.
struct ServerSilence {
  double lasts_s = 0, ends_in_s = 0;
};
// The connection failed or ended; the endpoint is idle again.
struct ConnectionLost {
  std::string reason;  // one line for the player, without a line end
};
using ClientEvent = std::variant<Connected, FromServer, ConnectionLost>;

class ClientEndpoint {
 public:
  enum class State { kIdle, kConnecting, kConnected };

  // CHECKs that `socket` is not null.
  explicit ClientEndpoint(std::unique_ptr<platform::DatagramSocket> socket,
                          const ClientEndpointSettings& settings = {});

  // Ends the current connection and requests one from `server`. The result is a Connected or ConnectionLost
  // event.
  void connect(const platform::Address& server, double now_s);
  // Notifies the server, if connected, and becomes idle. Causes no event.
  void disconnect();

  // Returns the next event, or nullopt when the socket is empty. Call it every frame until it returns
  // nullopt.
  std::optional<ClientEvent> next_event(double now_s);
  // Repeats overdue requests and fragments, and checks timeouts; a failure arrives as an event. Call it once
  // a frame.
  void update(double now_s);

  // Works like Channel's function; fails with kNotFound without a connection.
  base::Status send_reliable(base::Bytes message);
  base::Status send_unreliable(base::Bytes message);
  bool can_send_reliable() const { return state_ == State::kConnected && channel_.can_send_reliable(); }
  // Applies the message limits of the protocol that the server announced.
  void set_protocol(Protocol protocol);

  State state() const { return state_; }
  // Computed by the last update(). Nothing without a connection, or if the server is in this process.
  std::optional<ServerSilence> silence() const;
  // Address of the server that was asked, or that is connected.
  const platform::Address& server() const { return server_; }
  const Channel& channel() const { return channel_; }
  platform::Address local_address() const { return socket_->local_address(); }

 private:
  void request(double now_s);
  std::optional<ClientEvent> handle_datagram(const platform::Datagram& datagram);
  std::optional<ClientEvent> handle_control(base::Bytes packet);
  void accept(std::int32_t port);
  bool is_from_server(const platform::Address& from) const;
  void drop(std::string reason);

  std::unique_ptr<platform::DatagramSocket> socket_;
  ClientEndpointSettings settings_;
  State state_ = State::kIdle;
  platform::Address requested_server_, server_;
  bool has_received_ = false;   // a packet of the connection arrived, so server_ has the right port
  bool is_darkplaces_ = false;  // the server has answered DarkPlaces's question
  int requests_ = 0;
  double requested_s_ = 0, last_received_s_ = 0, now_s_ = 0;
  Channel channel_;
  base::ByteVector message_bytes_;  // of the last FromServer
  std::optional<ConnectionLost> lost_;
};

}  // namespace temblor::net
