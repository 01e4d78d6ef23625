// The interface to an unreliable datagram socket. A datagram may arrive once, several times, late, out of
// order, or never; net/transport builds reliable messages on top of it.
#pragma once

#include <optional>

#include "base/bytes.h"
#include "platform/address.h"

namespace temblor::platform {

struct Datagram {
  Address from;
  base::Bytes bytes;  // owned by the socket
  // How long it has waited at this machine before receive(), if the system says; otherwise 0.
  double waited_s = 0;
};

// No function blocks. Implementations: platform/posix/udp_socket.h, net/transport/loopback.h.
class DatagramSocket {
 public:
  virtual ~DatagramSocket() = default;

  // Sends one datagram. If the system refuses it (no route to the host, full buffers), it is lost, like a
  // datagram that the network drops.
  virtual void send(const Address& to, base::Bytes bytes) = 0;
  // Returns the next datagram that has arrived, or nothing. Its bytes are valid until the next call.
  virtual std::optional<Datagram> receive() = 0;
  // The port on which the socket receives. The host is zeros if it receives on all interfaces.
  virtual Address local_address() const = 0;
};

}  // namespace temblor::platform
