// A server endpoint on a simulated network with a virtual clock, and a log of its events.
#pragma once

#include <fmt/format.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "net/transport/client_endpoint.h"
#include "net/transport/server_endpoint.h"
#include "support/programs/bad_network.h"

namespace temblor::test {

inline platform::Address host(unsigned number, unsigned port) {
  return platform::ip4_address(
      {10, 0, static_cast<std::uint8_t>(number >> 8), static_cast<std::uint8_t>(number)},
      static_cast<std::uint16_t>(port));
}
inline const platform::Address kServer = host(1, 26000);

inline net::ServerDescription described() {
  return {
      "a host", "dm1", 16, {{"bob", 0x4d, -2, 61.5, "private"}}, {{"fraglimit", "20"}, {"timelimit", "10"}}};
}

class ServerOnBench {
 public:
  ServerOnBench(BadNetwork& network, const net::ServerEndpointSettings& settings = {})
      : endpoint(sockets(network), settings, described) {}

  // Events become lines: "+1", "1R:text", "1U:text", "-1 reason", "rcon text".
  void tick(double now_s) {
    endpoint.update(now_s);
    while (const auto event = endpoint.next_event(now_s)) std::visit(*this, *event);
  }
  std::vector<std::string> taken() { return std::exchange(lines_, {}); }
  bool send(unsigned connection, std::string_view text) {
    return endpoint.send_reliable(net::ConnectionId{connection}, base::as_bytes(text)).ok();
  }

  void operator()(const net::PeerConnected& e) { add("+{}", number(e.connection)); }
  void operator()(const net::PeerMessage& e) {
    add("{}{}:{}", number(e.connection), e.reliable ? "R" : "U", base::as_text(e.bytes));
  }
  void operator()(const net::PeerDisconnected& e) { add("-{} {}", number(e.connection), e.reason); }
  void operator()(const net::RemoteCommand& e) {
    add("rcon {}", e.command);
    endpoint.reply_to_remote_command(e, "done");
  }

  net::ServerEndpoint endpoint;

 private:
  static net::ServerEndpoint::Sockets sockets(BadNetwork& network) {
    net::ServerEndpoint::Sockets one;
    one.push_back(network.open(kServer));
    return one;
  }
  static std::uint32_t number(net::ConnectionId id) { return static_cast<std::uint32_t>(id); }
  template <typename... Args>
  void add(fmt::format_string<Args...> format, Args&&... args) {
    lines_.push_back(fmt::format(format, std::forward<Args>(args)...));
  }

  std::vector<std::string> lines_;
};

class ClientOnBench {
 public:
  ClientOnBench(BadNetwork& network, const platform::Address& address,
                const net::ClientEndpointSettings& settings = {})
      : endpoint(network.open(address), settings) {}

  // "+", "R:text", "U:text", "- reason".
  void tick(double now_s) {
    endpoint.update(now_s);
    while (const auto event = endpoint.next_event(now_s)) std::visit(*this, *event);
  }
  std::vector<std::string> taken() { return std::exchange(lines_, {}); }
  bool send(std::string_view text) { return endpoint.send_reliable(base::as_bytes(text)).ok(); }

  void operator()(const net::Connected&) { lines_.push_back("+"); }
  void operator()(const net::FromServer& e) {
    lines_.push_back(fmt::format("{}:{}", e.reliable ? "R" : "U", base::as_text(e.bytes)));
  }
  void operator()(const net::ConnectionLost& e) { lines_.push_back(fmt::format("- {}", e.reason)); }

  net::ClientEndpoint endpoint;

 private:
  std::vector<std::string> lines_;
};

}  // namespace temblor::test
