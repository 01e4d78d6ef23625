#include "platform/address.h"

#include <arpa/inet.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "base/text.h"

namespace temblor::platform {
namespace {

// The prefix of IPv4-mapped addresses (RFC 4291, section 2.5.5.2).
constexpr std::array<std::uint8_t, 12> kIp4Prefix = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff};

base::Result<std::uint16_t> parse_port(std::string_view text) {
  std::uint16_t port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  if (error == std::errc{} && end == text.data() + text.size() && port != 0) return port;
  return base::error(base::ErrorCode::kUsage, "port '{}' is not a number from 1 to 65535",
                     base::quotable(text));
}

}  // namespace

bool Address::is_ip4() const {
  return std::equal(kIp4Prefix.begin(), kIp4Prefix.end(), host.begin());
}

bool Address::is_loopback() const {
  constexpr std::array<std::uint8_t, 16> kIp6Loopback{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
  return is_ip4() ? host[12] == 127 : host == kIp6Loopback;
}

Address ip4_address(std::array<std::uint8_t, 4> host, std::uint16_t port) {
  Address address;
  std::copy(kIp4Prefix.begin(), kIp4Prefix.end(), address.host.begin());
  std::copy(host.begin(), host.end(), address.host.begin() + kIp4Prefix.size());
  address.port = port;
  return address;
}

std::string host_text(const Address& address) {
  if (address.is_local()) return "local";
  const auto& host = address.host;
  if (address.is_ip4()) return fmt::format("{}.{}.{}.{}", host[12], host[13], host[14], host[15]);
  std::array<char, INET6_ADDRSTRLEN> text{};
  inet_ntop(AF_INET6, host.data(), text.data(), text.size());
  return text.data();
}

std::string to_text(const Address& address) {
  const bool brackets = !address.is_local() && !address.is_ip4();
  return brackets ? fmt::format("[{}]:{}", host_text(address), address.port)
                  : fmt::format("{}:{}", host_text(address), address.port);
}

base::Result<HostAndPort> split_host_and_port(std::string_view text) {
  std::string_view host = text, port;
  bool has_port = false;
  if (text.starts_with('[')) {
    const std::size_t end = text.find(']');
    const std::string_view rest = end == std::string_view::npos ? text : text.substr(end + 1);
    if (!rest.empty() && !rest.starts_with(':'))
      return base::error(base::ErrorCode::kUsage, "'{}' is not of the form [HOST]:PORT",
                         base::quotable(text));
    host = text.substr(1, end - 1);
    has_port = !rest.empty();
    if (has_port) port = rest.substr(1);
  } else if (std::count(text.begin(), text.end(), ':') == 1) {  // more colons: an IPv6 host without a port
    const std::size_t colon = text.find(':');
    host = text.substr(0, colon);
    port = text.substr(colon + 1);
    has_port = true;
  }
  if (host.empty() || host.find('\0') != std::string_view::npos)
    return base::error(base::ErrorCode::kUsage, "'{}' names no host", base::quotable(text));
  HostAndPort parts{std::string(host), {}};
  if (has_port) {
    TRY(parts.port, parse_port(port));
  }
  return parts;
}

std::optional<Address> parse_host(std::string_view text, std::uint16_t port) {
  // inet_pton() needs a terminated string, which an embedded zero would cut short.
  const std::string host(text);
  if (host.find('\0') != std::string::npos) return std::nullopt;
  if (std::array<std::uint8_t, 4> ip4{}; inet_pton(AF_INET, host.c_str(), ip4.data()) == 1)
    return ip4_address(ip4, port);
  Address address;
  if (inet_pton(AF_INET6, host.c_str(), address.host.data()) != 1) return std::nullopt;
  address.port = port;
  return address;
}

}  // namespace temblor::platform
