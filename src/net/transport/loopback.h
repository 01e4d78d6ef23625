// Datagrams between sockets of one process, without a system: single player speaks to its server through
// this. Nothing is lost but what overflows, and everything keeps its order.
#pragma once

#include <cstdint>
#include <memory>

#include "platform/datagram_socket.h"

namespace temblor::net {

// Bytes that may wait at one socket; what comes on top of them is lost, as in a system's own buffer.
constexpr std::size_t kLoopbackBufferBytes = 1 << 20;

class LoopbackNetwork {
 public:
  LoopbackNetwork();

  // A socket with the address "local:PORT"; 0 means any that is free. CHECKs that nobody has it. The network
  // may end before its sockets, which then still reach one another.
  std::unique_ptr<platform::DatagramSocket> open(std::uint16_t port = 0);

  struct Sockets;

 private:
  std::shared_ptr<Sockets> sockets_;
};

}  // namespace temblor::net
