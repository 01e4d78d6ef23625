// Client and server endpoints together, over the loopback and over a bad network.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "net/transport/endpoint_bench.h"
#include "net/transport/loopback.h"
#include "support/effort.h"

namespace temblor::net {
namespace {

using test::BadNetwork;
using test::ClientOnBench;
using test::host;
using test::kServer;
using test::ServerOnBench;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::StartsWith;

constexpr double kTick_s = 1 / 72.0;

TEST(Endpoints, ListenServerHasLocalAndRemotePlayers) {
  LoopbackNetwork inside;
  BadNetwork outside({}, 1);
  ServerEndpoint::Sockets sockets;
  sockets.push_back(inside.open(26000));
  sockets.push_back(outside.open(kServer));
  ServerEndpoint server(std::move(sockets), {}, test::described);
  server.set_protocol(Protocol::kFitzQuake);
  ClientEndpoint own(inside.open());
  ClientEndpoint guest(outside.open(host(2, 1)));
  own.connect(server.local_address(0), 0);
  guest.connect(kServer, 0);
  std::vector<ConnectionId> joined;
  for (int i = 0; i < 5; ++i) {
    outside.advance_to(i);
    server.update(i);
    while (const auto event = server.next_event(i))
      if (const auto* peer = std::get_if<PeerConnected>(&*event)) joined.push_back(peer->connection);
    while (own.next_event(i)) {
    }
    while (guest.next_event(i)) {
    }
  }
  EXPECT_EQ(own.state(), ClientEndpoint::State::kConnected);
  EXPECT_EQ(guest.state(), ClientEndpoint::State::kConnected);
  ASSERT_EQ(joined.size(), 2u);
  // Message limits of the network do not apply inside a process.
  EXPECT_EQ(server.message_limits(joined[0]).unreliable_bytes, 64000u);
  EXPECT_EQ(server.message_limits(joined[1]).unreliable_bytes, 1400u);
}

TEST(Endpoints, FloodDoesNotDelayLocalPlayer) {
  LoopbackNetwork inside;
  BadNetwork outside({}, 1);
  ServerEndpoint::Sockets sockets;
  sockets.push_back(outside.open(kServer));
  sockets.push_back(inside.open(26000));
  ServerEndpoint server(std::move(sockets), {.max_packets_between_updates = 100}, test::described);
  ClientEndpoint own(inside.open());
  own.connect(server.local_address(1), 0);
  const auto flood = outside.open(host(2, 1));
  int heard = 0;
  for (int tick = 0; tick < 50; ++tick) {
    const double now_s = tick * kTick_s;
    for (int i = 0; i < 1000; ++i) flood->send(kServer, base::as_bytes("nonsense"));
    server.update(now_s);
    while (const auto event = server.next_event(now_s)) heard += std::holds_alternative<PeerMessage>(*event);
    while (own.next_event(now_s)) {
    }
    const bool is_there = own.state() == ClientEndpoint::State::kConnected;
    ASSERT_TRUE(!is_there || own.send_unreliable(base::as_bytes("move")).ok());
  }
  EXPECT_GE(heard, 45);
}

TEST(Endpoints, DisconnectReachesPeer) {
  BadNetwork network({}, 1);
  ServerOnBench server(network);
  ClientOnBench client(network, host(2, 1));
  client.endpoint.connect(kServer, 0);
  const auto tick = [&] {
    server.tick(0);
    client.tick(0);
    server.tick(0);
  };
  tick();
  EXPECT_THAT(client.taken(), ElementsAre("+", "R:\x01"));
  EXPECT_THAT(server.taken(), ElementsAre("+1"));  // the client's nop came before its acknowledgment
  server.endpoint.disconnect_all("the server ends");
  tick();
  EXPECT_THAT(client.taken(), ElementsAre(StartsWith("U:\x08the server ends\n")));
}

TEST(Endpoints, SixtyFourClientsJoinFromOneHost) {
  BadNetwork network({0, 0, 0.05, 0.01}, 1);
  ServerOnBench server(network, {.max_connections = 64});
  std::vector<std::unique_ptr<ClientOnBench>> clients;
  for (unsigned i = 0; i < 64; ++i) {
    clients.push_back(std::make_unique<ClientOnBench>(network, host(2, 1 + i)));
    clients.back()->endpoint.connect(kServer, 0);
  }
  for (double now_s = 0; now_s < 7; now_s += kTick_s) {
    network.advance_to(now_s);
    server.tick(now_s);
    for (auto& client : clients) client->tick(now_s);
  }
  EXPECT_EQ(server.endpoint.connections(), 64u);
}

// Messages of the long test: numbered lines, several in one message.
struct Speaker {
  std::string said, waiting;

  void say(std::string_view text) {
    said += text;
    waiting += text;
  }
  // Collect lines while a message is in flight, and send them together, as a server does.
  template <typename Endpoint>
  void flush(Endpoint& endpoint) {
    if (waiting.empty() || !endpoint.can_send_reliable()) return;
    const std::size_t size = std::min(waiting.size(), MessageLimits{}.reliable_bytes);
    ASSERT_TRUE(endpoint.send_reliable(base::as_bytes(std::string_view(waiting).substr(0, size))).ok());
    waiting.erase(0, size);
  }
};

// Adapts one connection of a server to the interface of a sender.
struct ConnectionOf {
  ServerEndpoint& endpoint;
  ConnectionId id;
  bool can_send_reliable() const { return endpoint.can_send_reliable(id); }
  base::Status send_reliable(base::Bytes bytes) { return endpoint.send_reliable(id, bytes); }
};

class LongGame {
 public:
  LongGame(const test::NetworkConditions& conditions, std::uint64_t seed, unsigned clients)
      : network_(conditions, seed), server_(sockets(network_), {}, test::described) {
    for (unsigned i = 0; i < clients; ++i)
      players_.push_back(std::make_unique<Player>(network_, host(2 + i, 1)));
    to_clients_.resize(clients);
    from_clients_.resize(clients);
  }

  void tick(double now_s) {
    network_.advance_to(now_s);
    server_.update(now_s);
    while (const auto event = server_.next_event(now_s)) on_server(*event);
    for (auto& player : players_) {
      player->endpoint.update(now_s);
      while (const auto event = player->endpoint.next_event(now_s)) on_client(*player, *event);
    }
  }
  // Runs until all clients have joined; a client that lost all three requests tries again. Returns the time.
  double join() {
    double now_s = 0;
    for (; now_s < 60 && !all_are_there(); now_s += kTick_s) {
      for (auto& player : players_)
        if (player->endpoint.state() == ClientEndpoint::State::kIdle)
          player->endpoint.connect(kServer, now_s);
      tick(now_s);
    }
    EXPECT_TRUE(all_are_there());
    lost_ = 0;
    return now_s;
  }
  // Exchanges messages in both directions.
  void say(std::string_view text) {
    for (const auto& [id, client] : client_of_) to_clients_[client].say(text);
    for (auto& player : players_)
      if (player->endpoint.state() == ClientEndpoint::State::kConnected) player->speaker.say(text);
  }
  void flush() {
    for (const auto& [id, client] : client_of_) {
      ConnectionOf connection{server_, id};
      to_clients_[client].flush(connection);
      base::ByteWriter frame;
      frame.u32(frame_);
      ASSERT_TRUE(server_.send_unreliable(id, frame.view()).ok());
    }
    ++frame_;
    for (auto& player : players_) player->speaker.flush(player->endpoint);
  }
  bool all_are_there() const {
    return client_of_.size() == players_.size() &&
           std::all_of(players_.begin(), players_.end(), [](const auto& player) {
             return player->endpoint.state() == ClientEndpoint::State::kConnected;
           });
  }
  void check() const {
    EXPECT_EQ(lost_, 0);
    ASSERT_TRUE(all_are_there());
    for (std::size_t i = 0; i < players_.size(); ++i) {
      // Compare short prefixes, so that failures print little.
      EXPECT_EQ(players_[i]->heard.size(), to_clients_[i].said.size());
      EXPECT_TRUE(players_[i]->heard == to_clients_[i].said);
      EXPECT_EQ(from_clients_[i].size(), players_[i]->speaker.said.size());
      EXPECT_TRUE(from_clients_[i] == players_[i]->speaker.said);
      EXPECT_GT(players_[i]->frames, frame_ / 50);
    }
  }

 private:
  struct Player {
    Player(BadNetwork& network, const platform::Address& address) : endpoint(network.open(address)) {}
    ClientEndpoint endpoint;
    Speaker speaker;
    std::string heard;
    std::uint32_t frames = 0, next_frame = 0;
  };

  static ServerEndpoint::Sockets sockets(BadNetwork& network) {
    ServerEndpoint::Sockets one;
    one.push_back(network.open(kServer));
    return one;
  }
  void on_server(const ServerEvent& event) {
    if (const auto* peer = std::get_if<PeerConnected>(&event))
      client_of_.emplace_back(peer->connection, peer->address.host[15] - 2u);
    if (std::holds_alternative<PeerDisconnected>(event)) ++lost_;
    const auto* message = std::get_if<PeerMessage>(&event);
    if (message == nullptr || !message->reliable) return;
    for (const auto& [id, client] : client_of_)
      if (id == message->connection) from_clients_[client] += base::as_text(message->bytes);
  }
  void on_client(Player& player, const ClientEvent& event) {
    if (std::holds_alternative<ConnectionLost>(event)) ++lost_;
    const auto* message = std::get_if<FromServer>(&event);
    if (message == nullptr) return;
    if (!message->reliable) {
      const std::uint32_t frame = base::ByteReader(message->bytes).u32();
      EXPECT_GE(frame, player.next_frame);
      player.next_frame = frame + 1;
      ++player.frames;
    } else if (base::as_text(message->bytes) != "\x01") {  // svc_nop of the handshake
      player.heard += base::as_text(message->bytes);
    }
  }

  BadNetwork network_;
  ServerEndpoint server_;
  std::vector<std::unique_ptr<Player>> players_;
  std::vector<std::pair<ConnectionId, std::size_t>> client_of_;
  std::vector<Speaker> to_clients_;
  std::vector<std::string> from_clients_;
  std::uint32_t frame_ = 0;
  int lost_ = 0;
};

// 20 % loss, 5 % duplicates, 300 ms round trip with half of it jitter. After ten minutes, all clients are
// connected, and of ten thousand numbered lines none is missing, duplicated, or out of order.
TEST(Endpoints, SurviveTenMinutesOfBadNetwork) {
  constexpr unsigned kClients = 4;
  constexpr int kPrints = 10000;
  LongGame game({0.2, 0.05, 0.15, 0.075}, 7, kClients);
  double now_s = game.join();
  const double speaks_until_s = 540, first_s = now_s;
  int printed = 0;
  for (; now_s < 600; now_s += kTick_s) {
    const double part = std::min(1.0, (now_s - first_s) / (speaks_until_s - first_s));
    for (; printed < static_cast<int>(part * kPrints); ++printed)
      game.say("print number " + std::to_string(printed) + "\n");
    game.flush();
    game.tick(now_s);
  }
  EXPECT_EQ(printed, kPrints);
  game.check();
}

// Twice the latency, for more seeds and less time.
TEST(Endpoints, SurviveWorseNetwork) {
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(test::effort(8, 2)); ++seed) {
    SCOPED_TRACE(seed);
    LongGame game({0.2, 0.05, 0.3, 0.2}, seed, 2);
    double now_s = game.join();
    int printed = 0;
    for (const double end_s = now_s + 120; now_s < end_s; now_s += kTick_s) {
      if (now_s < end_s - 60 && printed < 500) game.say(std::to_string(printed++) + "\n");
      game.flush();
      game.tick(now_s);
    }
    EXPECT_EQ(printed, 500);
    game.check();
  }
}

}  // namespace
}  // namespace temblor::net
