// The network address of a peer: host and port, as a value that can be compared, sorted and printed.
//
// IPv4 hosts are stored in their IPv6 form, so that the rest of the engine handles one kind of address:
//
//   byte  0 ... 9   10 11   12 13 14 15
//         0         ff ff    a  b  c  d      IPv4 a.b.c.d
//         0         0  0     0  0  0  0      a peer in this process, over a loopback
//         anything else                      IPv6
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"

namespace temblor::platform {

struct Address {
  // In network byte order. A peer has the same address through an IPv4 and an IPv6 socket.
  std::array<std::uint8_t, 16> host{};
  std::uint16_t port = 0;
  // The interface's index, for link-local IPv6 hosts (fe80::); otherwise 0.
  std::uint32_t scope = 0;

  auto operator<=>(const Address&) const = default;

  // Whether the host is an IPv4 host in its IPv6 form.
  bool is_ip4() const;
  // Whether the peer is in this process.
  bool is_local() const { return host == std::array<std::uint8_t, 16>{}; }
  // Whether the host is this machine's loopback interface: 127.x.x.x or ::1.
  bool is_loopback() const;
  // Whether both are on one machine; ports may differ.
  bool same_host(const Address& other) const { return host == other.host && scope == other.scope; }
};

Address ip4_address(std::array<std::uint8_t, 4> host, std::uint16_t port);

// The host alone: "192.0.2.1", "2001:db8::1", "local".
std::string host_text(const Address& address);
// Host and port: "192.0.2.1:26000", "[2001:db8::1]:26000", "local:1".
std::string to_text(const Address& address);

struct HostAndPort {
  std::string host;
  std::optional<std::uint16_t> port;
};
// Splits "HOST", "HOST:PORT" or "[HOST]:PORT". An IPv6 host needs brackets only if a port follows. The host
// is not looked up. Fails with kUsage if the host is empty or the port is not a number from 1 to 65535.
base::Result<HostAndPort> split_host_and_port(std::string_view text);

// Parses a numeric IPv4 or IPv6 host. Returns nothing for a name.
std::optional<Address> parse_host(std::string_view text, std::uint16_t port);

}  // namespace temblor::platform
