// UDP sockets and host names by POSIX. An IPv6 socket that also receives IPv4 is used if the system has IPv6.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "base/result.h"
#include "platform/datagram_socket.h"

namespace temblor::platform::posix {

struct UdpOptions {
  std::uint16_t port = 0;  // 0: any free port
  // The numeric address of the only interface to receive on, such as "127.0.0.1". Empty: all interfaces.
  std::string_view host{};
};

// Opens a socket. Fails with kIo and the system's reason, for example if the port is in use, and with kUsage
// if the host is not numeric.
base::Result<std::unique_ptr<DatagramSocket>> open_udp_socket(const UdpOptions& options);

// Whether the host is an address of this machine, of any of its interfaces. The port does not matter.
bool is_own_host(const Address& address);

// Resolves "HOST" or "HOST:PORT", where the host is a name or a numeric address. If a name has addresses of
// both kinds, the result is IPv4. This may block for seconds while the system asks a name server. Fails with
// kNotFound if the name is unknown.
base::Result<Address> look_up(std::string_view host_and_port, std::uint16_t default_port);

}  // namespace temblor::platform::posix
