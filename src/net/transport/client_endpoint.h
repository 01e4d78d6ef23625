// A client's end of the wire: asks a server for a connection, and keeps one. Works with servers that answer
// from the port they were asked at (ours) and with those that open a new one for each client (stock).
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
  int requests = 3;
  double request_every_s = 2.5;
  double timeout_s = 300;  // a server that is silent for longer is given up
  ChannelSettings channel{};
};

struct Connected {};
// `bytes` are valid until the next call of next_event().
struct FromServer {
  base::Bytes bytes;
  bool reliable = false;
};
// It could not be had, or it ended; the endpoint is idle again.
struct ConnectionLost {
  std::string reason;  // for a person, without line's end
};
using ClientEvent = std::variant<Connected, FromServer, ConnectionLost>;

class ClientEndpoint {
 public:
  enum class State { kIdle, kConnecting, kConnected };

  explicit ClientEndpoint(std::unique_ptr<platform::DatagramSocket> socket,
                          const ClientEndpointSettings& settings = {});

  // Ends what there is and asks this server. Brings Connected or ConnectionLost.
  void connect(const platform::Address& server, double now_s);
  // Tells the server, if there is one. Brings no event.
  void disconnect();

  // The next thing that happened; nothing when the socket is empty. Call it until then, every frame.
  std::optional<ClientEvent> next_event(double now_s);
  // Sends again; call it once a frame. What it gives up comes as an event.
  void update(double now_s);

  // As Channel's; kNotFound where there is no connection.
  base::Status send_reliable(base::Bytes message);
  base::Status send_unreliable(base::Bytes message);
  bool can_send_reliable() const { return state_ == State::kConnected && channel_.can_send_reliable(); }
  // Of what is sent: limits_of() of the protocol that the server has named.
  void set_protocol(Protocol protocol);

  State state() const { return state_; }
  // Whom it asked, or speaks to.
  const platform::Address& server() const { return server_; }
  const Channel& channel() const { return channel_; }
  platform::Address local_address() const { return socket_->local_address(); }

 private:
  void request(double now_s);
  std::optional<ClientEvent> take(const platform::Datagram& datagram);
  std::optional<ClientEvent> take_control(base::Bytes packet);
  void accept(std::int32_t port);
  bool is_from_server(const platform::Address& from) const;
  void lose(std::string reason);

  std::unique_ptr<platform::DatagramSocket> socket_;
  ClientEndpointSettings settings_;
  State state_ = State::kIdle;
  platform::Address asked_, server_;
  bool heard_ = false;  // a packet of the connection: it is known which of the two ports is the server's
  int requests_ = 0;
  double requested_s_ = 0, heard_s_ = 0, now_s_ = 0;
  Channel channel_;
  base::ByteVector message_bytes_;
  std::optional<ConnectionLost> lost_;
};

}  // namespace temblor::net
