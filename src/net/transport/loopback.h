// Datagram sockets inside one process, without the operating system. A single-player game and its server talk
// through these. Datagrams keep their order, and are lost only when a receiver's buffer overflows.
#pragma once

#include <cstdint>
#include <memory>

#include "platform/datagram_socket.h"

namespace temblor::net {

// Receive buffer of each socket, overhead included. Datagrams that do not fit are lost, as with a real
// socket.
constexpr std::size_t kLoopbackBufferBytes = 1 << 20;

class LoopbackNetwork {
 public:
  LoopbackNetwork();

  // Opens a socket with the address "local:PORT"; port 0 picks a free one. CHECKs that the port is free.
  // Sockets may outlive the network object and still reach one another.
  std::unique_ptr<platform::DatagramSocket> open(std::uint16_t port = 0);

  struct Sockets;  // inboxes by port, shared by all sockets

 private:
  std::shared_ptr<Sockets> sockets_;
};

}  // namespace temblor::net
