// The end to which a player's real client is connected. It takes what the client sends as inputs for the
// simulation, and passes on what the simulation's server sends to that player:
//
//   client::Connection <-- loopback --> ClientLink --> take_input() --> all peers
//                                           ^--- forward() <-- Simulation::take_messages()
#pragma once

#include <deque>
#include <memory>
#include <span>
#include <string_view>

#include "lockstep/peers/client_input.h"
#include "lockstep/simulation/simulation.h"
#include "net/transport/server_endpoint.h"
#include "platform/datagram_socket.h"

namespace temblor::lockstep {

class ClientLink {
 public:
  explicit ClientLink(std::unique_ptr<platform::DatagramSocket> socket);

  platform::Address address() const { return endpoint_.local_address(); }
  // Reads what the client has sent, and sends what is due. `protocol`: of the simulation's server.
  void update(double now_s, net::Protocol protocol);
  // Returns the input since the last call, up to the limits of one input; the rest follows in the next
  // ones. An input with `leaves` is the last.
  ClientInput take_input();
  // Sends the messages to the client, or keeps the reliable ones until it is connected.
  void forward(std::span<const MessageForClient> messages);
  // Shows text in the client's console.
  void print(std::string_view text);
  // Ends the connection with a reason for the player.
  void end(std::string_view reason);
  bool has_left() const { return has_left_; }

 private:
  struct NumberedMove {
    std::uint32_t number;  // 0: none
    net::Move move;
  };

  void read_packet(base::Bytes packet, net::Protocol protocol);
  void send_waiting();

  net::ServerEndpoint endpoint_;
  std::optional<net::ConnectionId> connection_;
  bool has_left_ = false, is_leave_taken_ = false;
  std::deque<NumberedMove> moves_;
  std::uint32_t last_number_ = 0;  // of the moves that were read
  std::deque<std::string> commands_;
  std::deque<base::ByteVector> waiting_;  // reliable messages for a client that is not connected yet
};

}  // namespace temblor::lockstep
