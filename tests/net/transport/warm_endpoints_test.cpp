// Warm endpoints allocate no memory, over real sockets.
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <thread>
#include <vector>

#include "net/transport/client_endpoint.h"
#include "net/transport/endpoint_bench.h"
#include "net/transport/server_endpoint.h"
#include "platform/posix/udp_socket.h"
#include "support/allocation_counter.h"

namespace temblor::net {
namespace {

std::unique_ptr<platform::DatagramSocket> socket_here() {
  return platform::posix::open_udp_socket({.host = "127.0.0.1"}).value();
}
ServerEndpoint::Sockets one_socket() {
  ServerEndpoint::Sockets one;
  one.push_back(socket_here());
  return one;
}

// Each client sends a move, and gets an unreliable message, and a reliable one every tenth time if possible.
struct Game {
  ServerEndpoint server{one_socket(), {}, test::described};
  std::vector<std::unique_ptr<ClientEndpoint>> clients;
  std::vector<ConnectionId> connections;
  std::size_t heard = 0, heard_reliably = 0;
  const base::ByteVector move = base::ByteVector(16), frame = base::ByteVector(600),
                         print = base::ByteVector(1500);

  void tick(int number) {
    const double now_s = number / 72.0;
    server.update(now_s);
    while (const auto event = server.next_event(now_s)) {
      if (const auto* peer = std::get_if<PeerConnected>(&*event)) connections.push_back(peer->connection);
      heard += std::holds_alternative<PeerMessage>(*event);
    }
    for (const ConnectionId id : connections) {
      ASSERT_TRUE(server.send_unreliable(id, frame).ok());
      const bool speaks = number % 10 == 0 && server.can_send_reliable(id);
      ASSERT_TRUE(!speaks || server.send_reliable(id, print).ok());
    }
    for (auto& client : clients) {
      client->update(now_s);
      while (const auto event = client->next_event(now_s)) {
        const auto* message = std::get_if<FromServer>(&*event);
        heard_reliably += message != nullptr && message->reliable;
      }
      const bool is_there = client->state() == ClientEndpoint::State::kConnected;
      ASSERT_TRUE(!is_there || client->send_unreliable(move).ok());
    }
  }
};

TEST(WarmEndpoints, AllocateNothing) {
  Game game;
  for (int i = 0; i < 8; ++i) {
    game.clients.push_back(std::make_unique<ClientEndpoint>(socket_here()));
    game.clients.back()->connect(game.server.local_address(), 0);
  }
  int number = 0;
  for (; number < 2000 && (game.connections.size() < 8 || number < 200); ++number) {
    game.tick(number);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ASSERT_EQ(game.connections.size(), 8u);
  const std::size_t before = test::allocation_count(), heard = game.heard, reliably = game.heard_reliably;
  EXPECT_GT(before, 0u);
  for (const int end = number + 200; number < end; ++number) game.tick(number);
  EXPECT_EQ(test::allocation_count() - before, 0u);
  EXPECT_GT(game.heard - heard, 8u * 100);
  EXPECT_GT(game.heard_reliably - reliably, 8u * 5);
}

}  // namespace
}  // namespace temblor::net
