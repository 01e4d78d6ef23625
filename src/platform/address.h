// Where a peer is: host and port.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"

namespace temblor::platform {

// A value. IPv4 hosts are held as IPv6 has them (::ffff:a.b.c.d), so that one peer has one address whatever
// socket it came through, and prefixes of both kinds are compared alike. A host of zeros only is this
// process: a peer over a loopback.
struct Address {
  std::array<std::uint8_t, 16> host{};
  std::uint16_t port = 0;
  // IPv6 hosts of one link alone (fe80::): the number of the interface; else 0.
  std::uint32_t scope = 0;

  auto operator<=>(const Address&) const = default;

  bool is_ip4() const;
  bool is_local() const { return host == std::array<std::uint8_t, 16>{}; }
  bool same_host(const Address& other) const { return host == other.host && scope == other.scope; }
};

Address ip4_address(std::array<std::uint8_t, 4> host, std::uint16_t port);

// "192.0.2.1", "2001:db8::1", "local".
std::string host_text(const Address& address);
// "192.0.2.1:26000", "[2001:db8::1]:26000", "local:1".
std::string to_text(const Address& address);

// "HOST", "HOST:PORT", "[HOST]:PORT" taken apart; an IPv6 host may stand without brackets where no port
// follows. kUsage with what is wrong for an empty host and a port that is no number from 1 to 65535.
struct HostAndPort {
  std::string host;
  std::optional<std::uint16_t> port;
};
base::Result<HostAndPort> split_host_and_port(std::string_view text);

// A host in numbers; nothing for a name.
std::optional<Address> parse_host(std::string_view text, std::uint16_t port);

}  // namespace temblor::platform
