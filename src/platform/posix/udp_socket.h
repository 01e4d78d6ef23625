// Datagrams over UDP, by the sockets of POSIX.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "base/result.h"
#include "platform/datagram_socket.h"

namespace temblor::platform::posix {

struct UdpOptions {
  std::uint16_t port = 0;  // 0: any that is free
  // A host in numbers to receive on alone, such as "127.0.0.1"; empty: on all of the machine, IPv6 as well
  // where it has that.
  std::string_view host{};
};

// kIo with the system's reason, such as a port that is taken; kUsage for a host that is not in numbers.
base::Result<std::unique_ptr<DatagramSocket>> open_udp_socket(const UdpOptions& options);

// "HOST" or "HOST:PORT", the host a name or in numbers; IPv4 is taken where a name has both. Asks the system,
// which may wait for a name server: seconds. kNotFound for a name that nobody knows.
base::Result<Address> look_up(std::string_view host_and_port, std::uint16_t default_port);

}  // namespace temblor::platform::posix
