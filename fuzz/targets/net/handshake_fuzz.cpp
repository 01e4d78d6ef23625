// Sends arbitrary datagrams from four addresses to a server and to a client that is connecting. In the
// input, each datagram is a byte for its sender and the time that passes, a byte with its length, and its
// bytes. Control packets that can be read must also be written unchanged.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

#include "base/check.h"
#include "fuzz/targets.h"
#include "net/transport/client_endpoint.h"
#include "net/transport/control.h"
#include "net/transport/server_endpoint.h"

using namespace temblor;

namespace {

// Holds one datagram at a time, and checks all outgoing ones.
class FedSocket final : public platform::DatagramSocket {
 public:
  explicit FedSocket(std::optional<platform::Datagram>& io_next) : next_(io_next) {}
  void send(const platform::Address&, base::Bytes bytes) override {
    CHECK(!bytes.empty() && bytes.size() <= 1400);
  }
  std::optional<platform::Datagram> receive() override { return std::exchange(next_, std::nullopt); }
  platform::Address local_address() const override { return platform::ip4_address({10, 0, 0, 1}, 26000); }

 private:
  std::optional<platform::Datagram>& next_;
};

void check_control(base::Bytes bytes) {
  const auto read = net::read_control_packet(bytes);
  if (!read.ok()) return;
  const auto again = net::write_control_packet(*read);
  CHECK(!again.ok() || again->size() <= bytes.size());
}

void speak(net::ServerEndpoint& io_server, double now_s) {
  io_server.update(now_s);
  while (const auto event = io_server.next_event(now_s)) {
    const auto* message = std::get_if<net::PeerMessage>(&*event);
    if (message == nullptr || message->bytes.empty()) continue;
    if (message->reliable)
      CHECK(io_server.send_reliable(message->connection, message->bytes.first(1)).ok());
    else
      io_server.disconnect(message->connection, "unreliable");
  }
  CHECK(io_server.connections() <= 2);
}

void speak(net::ClientEndpoint& io_client, double now_s) {
  io_client.update(now_s);
  while (io_client.next_event(now_s)) {
  }
  if (io_client.state() == net::ClientEndpoint::State::kIdle)
    io_client.connect(platform::ip4_address({10, 0, 0, 2}, 26000), now_s);
}

}  // namespace

int temblor::fuzz::fuzz_handshake(const std::uint8_t* data, std::size_t size) {
  std::optional<platform::Datagram> to_server, to_client;
  net::ServerEndpoint::Sockets sockets;
  sockets.push_back(std::make_unique<FedSocket>(to_server));
  net::ServerEndpoint server(std::move(sockets), {.max_connections = 2}, [] {
    return net::ServerDescription{"host", "map", 2, {{"bob", 1, 2, 3, "x"}}, {{"rule", "value"}}};
  });
  server.set_remote_password("p");
  net::ClientEndpoint client(std::make_unique<FedSocket>(to_client));
  base::ByteReader reader(std::as_bytes(std::span(data, size)));
  for (double now_s = 0; reader.remaining() >= 2;) {
    const std::uint8_t how = reader.u8();
    now_s += (how >> 2) / 16.0;
    const std::size_t wanted = reader.u8();
    const base::Bytes bytes = reader.take(wanted < reader.remaining() ? wanted : reader.remaining());
    const auto from = platform::ip4_address({10, 0, 0, static_cast<std::uint8_t>(2 + (how & 1))},
                                            static_cast<std::uint16_t>(26000 + (how >> 1 & 1)));
    check_control(bytes);
    to_server = to_client = platform::Datagram{from, bytes};
    speak(server, now_s);
    speak(client, now_s);
  }
  return 0;
}
