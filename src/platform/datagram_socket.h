// Datagrams out and in: what is sent may arrive once, several times, late or never.
#pragma once

#include <optional>

#include "base/bytes.h"
#include "platform/address.h"

namespace temblor::platform {

struct Datagram {
  Address from;
  base::Bytes bytes;
};

// Never waits. Implementations: platform/posix/udp_socket.h, net/transport/loopback.h.
class DatagramSocket {
 public:
  virtual ~DatagramSocket() = default;

  // What the system will not take (no way to that host, its buffers full) is lost, as on the way.
  virtual void send(const Address& to, base::Bytes bytes) = 0;
  // The next one that has arrived; its bytes are valid until the next call. Nothing when none is waiting.
  virtual std::optional<Datagram> receive() = 0;
  // The port it receives on; its host may be unknown (zeros) where it receives on all of a machine's.
  virtual Address local_address() const = 0;
};

}  // namespace temblor::platform
