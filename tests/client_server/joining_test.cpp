// Clients that load a level slowly. Stock ones read packets in the meantime to stay connected, and give
// up if these contain anything.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <optional>

#include "client_server/served_game.h"
#include "net/protocol/client_message.h"
#include "net/protocol/message_reader.h"
#include "net/transport/client_endpoint.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

// A client that sends nothing on its own, and stores the names of levels and all text that it is sent.
class SlowClient {
 public:
  explicit SlowClient(ServedGame& io_served)
      : served_(io_served), endpoint_(io_served.network().open(platform::ip4_address({10, 0, 9, 9}, 4000))) {
    endpoint_.connect(kServedAddress, served_.now_s());
  }

  void run(double seconds) {
    for (const double until_s = served_.now_s() + seconds; served_.now_s() < until_s;) {
      served_.run(1.0 / 72);
      endpoint_.update(served_.now_s());
      while (const auto event = endpoint_.next_event(served_.now_s()))
        if (const auto* packet = std::get_if<net::FromServer>(&*event)) read(packet->bytes);
    }
  }
  void say(std::string_view line) {
    base::ByteWriter writer;
    CHECK(net::write_client_message(net::StringCommand{line}, net::Protocol::kNetQuake, writer).ok());
    CHECK(endpoint_.send_reliable(std::move(writer).take()).ok());
  }

  int levels = 0;       // serverinfos
  int since_level = 0;  // messages after the last serverinfo, except those that belong to it
  int signon = 0;       // the last signon number
  std::string texts;    // prints and stufftexts

 private:
  void read(base::Bytes packet) {
    reader_.begin(packet);
    bool brings_level = false;
    for (auto message = reader_.next(); message.ok() && *message; message = reader_.next()) {
      if (std::holds_alternative<net::ServerInfo>(**message)) {
        brings_level = true;
        ++levels;
        since_level = 0;
      }
      since_level += brings_level || std::holds_alternative<net::Nop>(**message) ? 0 : 1;
      if (const auto* number = std::get_if<net::SignonNumber>(&**message)) signon = number->number;
      if (const auto* print = std::get_if<net::Print>(&**message)) texts += print->text;
      if (const auto* stuffed = std::get_if<net::StuffText>(&**message)) texts += stuffed->text;
    }
  }

  ServedGame& served_;
  net::ClientEndpoint endpoint_;
  net::MessageReader reader_;
};

TEST(Joining, ALoadingClientIsSentNothing) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t other = served.add_client("talker");
  ASSERT_TRUE(served.run_until_playing(other));
  SlowClient slow(served);
  slow.run(1);
  ASSERT_EQ(slow.levels, 1);
  for (int i = 0; i < 10; ++i) {
    served.command(fmt::format("say line {}", i));
    slow.run(0.2);
  }
  EXPECT_EQ(slow.since_level, 0);
  slow.say("prespawn");
  slow.run(1);
  EXPECT_EQ(slow.signon, 2);
  for (int i = 0; i < 10; ++i) EXPECT_THAT(slow.texts, HasSubstr(fmt::format("line {}\n", i)));
}

TEST(Joining, ALevelThatChangesMeanwhileFollowsTheFirst) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  SlowClient slow(served);
  slow.run(1);
  ASSERT_EQ(slow.levels, 1);
  served.command("changelevel small");
  slow.run(1);
  EXPECT_EQ(slow.levels, 1);
  EXPECT_EQ(slow.since_level, 0);
  slow.say("prespawn");
  slow.run(1);
  EXPECT_EQ(slow.levels, 2);
  EXPECT_THAT(slow.texts, HasSubstr("reconnect"));
  EXPECT_EQ(slow.signon, 1);
  EXPECT_EQ(slow.since_level, 0);
  for (const std::string_view line : {"prespawn", "spawn", "begin"}) {
    slow.say(line);
    slow.run(1);
  }
  EXPECT_EQ(slow.signon, 3);
  EXPECT_EQ(served.server().clients[0].stage, server::ClientStage::kPlaying);
}

// The second change happens before the first could be sent: no answer to the first is expected.
TEST(Joining, LevelsThatFollowAtOnceAreSentOnce) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(small_program(), {.conditions = {.delay_s = 0.1}});
  const std::size_t me = served.add_client("me");
  ASSERT_TRUE(served.run_until_playing(me));
  for (const std::string_view line : {"changelevel small; changelevel small", "map small; reload; restart"}) {
    served.command(line);
    served.run(5);
    EXPECT_TRUE(served.client(me).is_playing()) << line << served.console();
    EXPECT_EQ(served.server().clients[0].stage, server::ClientStage::kPlaying) << line;
  }
}

TEST(Joining, AClientThatConnectsDuringALevelChangeGetsThere) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t me = served.add_client("me");
  for (int i = 0; i < 6; ++i) {
    served.command("changelevel small");
    served.run(0.03);
  }
  served.run(5);
  EXPECT_TRUE(served.client(me).is_playing()) << served.client(me).disconnect_reason() << served.console();
}

// Players of one host, whose connections the test can cut off without a word, as a crash does.
class PlayersOfOneHost {
 public:
  void join(std::string name) {
    const auto port = static_cast<std::uint16_t>(5000 + players_.size());
    players_.push_back({std::make_unique<client::Connection>(
                            served_.network().open(platform::ip4_address({10, 0, 8, 8}, port)),
                            client::PlayerSettings{std::move(name), 1, 2}),
                        false});
    players_.back().connection->connect(kServedAddress, served_.now_s());
  }
  void kill(std::size_t player) { players_[player].is_dead = true; }
  void revive(std::size_t player) { players_[player].is_dead = false; }
  bool is_playing(std::size_t player) const { return players_[player].connection->is_playing(); }

  void run(double seconds) {
    for (const double until_s = served_.now_s() + seconds; served_.now_s() < until_s;) {
      served_.run(1.0 / 72);
      for (Player& player : players_) {
        if (player.is_dead) continue;
        player.connection->update(served_.now_s());
        player.connection->send_move({});
        player.connection->state().events().clear();
      }
    }
  }
  // The names of all players in the order of their slots.
  std::vector<std::string> names() {
    std::vector<std::string> names;
    for (const server::Client& client : served_.server().clients.all())
      if (!client.is_free()) names.push_back(client.name);
    return names;
  }
  ServedGame& served() { return served_; }

 private:
  struct Player {
    std::unique_ptr<client::Connection> connection;
    bool is_dead = false;
  };
  ServedGame served_;
  std::vector<Player> players_;
};

TEST(Joining, AKilledPlayerWhoComesBackHasItsNameAgain) {
  SKIP_WITHOUT_QUAKEC();
  PlayersOfOneHost players;
  players.join("joe");
  players.run(2);
  ASSERT_THAT(players.names(), ElementsAre("joe"));
  players.kill(0);
  players.run(0.3);
  players.join("Joe");
  players.run(1);
  EXPECT_THAT(players.names(), ElementsAre("joe", "Joe"));  // the old one may only be slow
  players.run(1.5);
  EXPECT_THAT(players.names(), ElementsAre("Joe"));
  EXPECT_TRUE(players.is_playing(1));
  EXPECT_THAT(players.served().console(), HasSubstr("came back with another connection"));
}

TEST(Joining, APlayerWhoWasOnlySlowKeepsItsName) {
  SKIP_WITHOUT_QUAKEC();
  PlayersOfOneHost players;
  players.join("joe");
  players.run(2);
  players.kill(0);
  players.join("joe");
  players.run(1);
  ASSERT_THAT(players.names(), ElementsAre("joe", "joe"));
  players.revive(0);
  players.run(5);
  EXPECT_THAT(players.names(), ElementsAre("joe", "joe (2)"));
  EXPECT_TRUE(players.is_playing(0) && players.is_playing(1));
}

TEST(Joining, TwoPlayersOfOneNameAndHostKeepTheirPlaces) {
  SKIP_WITHOUT_QUAKEC();
  PlayersOfOneHost players;
  players.join("player");
  players.run(2);
  players.join("player");
  players.run(10);
  EXPECT_THAT(players.names(), ElementsAre("player", "player (2)"));
  // Neither a stall after both have joined nor a slow level change makes room for the other.
  players.kill(0);
  players.run(20);
  EXPECT_THAT(players.names(), ElementsAre("player", "player (2)"));
  players.revive(0);
  players.run(1);
  players.served().command("changelevel small");
  players.run(0.05);
  players.kill(0);
  players.run(20);
  EXPECT_THAT(players.names(), ElementsAre("player", "player (2)"));
  players.revive(0);
  players.run(3);
  EXPECT_TRUE(players.is_playing(0) && players.is_playing(1));
}

TEST(Joining, AnotherHostCannotReplaceAKilledPlayer) {
  SKIP_WITHOUT_QUAKEC();
  PlayersOfOneHost players;
  players.join("joe");
  players.run(2);
  players.kill(0);
  players.run(3);
  players.served().add_client("joe");
  players.run(5);
  EXPECT_THAT(players.names(), ElementsAre("joe", "joe (2)"));
}

// A peer whose packets are written byte by byte.
class RawPeer {
 public:
  RawPeer(ServedGame& io_served, std::uint8_t last_address_byte)
      : socket_(io_served.network().open(platform::ip4_address({10, 0, 9, last_address_byte}, 4000))) {}
  void send(std::string_view bytes) { socket_->send(kServedAddress, base::as_bytes(bytes)); }
  auto receive() { return socket_->receive(); }
  void request_connection() { send(std::string_view("\x80\0\0\x0c\x01QUAKE\0\x03", 12)); }
  // Acknowledges the server's first reliable packet.
  void acknowledge_first() { send(std::string_view("\0\x02\0\x08\0\0\0\0", 8)); }

 private:
  std::unique_ptr<platform::DatagramSocket> socket_;
};

// It completes the handshake and then sends bytes that no client sends.
TEST(Joining, ANewcomerThatSendsGarbageIsDropped) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  RawPeer peer(served, 9);
  peer.request_connection();
  served.run(0.1);
  peer.acknowledge_first();
  served.run(0.1);
  ASSERT_EQ(served.server().endpoint.connections(), 1u);
  peer.send(std::string_view("\0\x10\0\x0c\0\0\0\0\xde\xad\xbe\xef", 12));
  served.run(0.1);
  EXPECT_EQ(served.server().endpoint.connections(), 0u);
  EXPECT_THAT(served.console(), HasSubstr("sent an unreadable message"));
}

// It acknowledges the level's files, as a client that loads them. A real one sends nothing then.
TEST(Joining, ANewcomerThatSendsUnreadablePacketsIsDroppedSoon) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  SlowClient slow(served);
  RawPeer peer(served, 7);
  peer.request_connection();
  slow.run(0.1);
  peer.acknowledge_first();
  for (int i = 0; i < 10; ++i) {
    while (const auto datagram = peer.receive())
      if (datagram->bytes.size() > 8)
        peer.send(std::string("\0\x02\0\x08", 4) + std::string(base::as_text(datagram->bytes.subspan(4, 4))));
    slow.run(0.1);
  }
  const auto send_garbage_for = [&](int seconds) {
    for (int i = 0; i < seconds; ++i) {
      peer.send("junk and more junk");
      slow.run(1);
    }
  };
  send_garbage_for(8);
  EXPECT_EQ(served.server().endpoint.connections(), 2u) << served.console();
  send_garbage_for(4);
  EXPECT_EQ(served.server().endpoint.connections(), 1u);
  EXPECT_THAT(served.console(), HasSubstr("sends unreadable packets"));
  slow.say("prespawn");
  slow.run(1);
  EXPECT_EQ(slow.signon, 2);
}

// Stock clients acknowledge the level's files before they load them.
TEST(Joining, ANewcomerMayLoadForLongButMustAcknowledge) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  SlowClient slow(served);
  RawPeer silent(served, 8);
  silent.request_connection();
  slow.run(0.1);
  silent.acknowledge_first();
  slow.run(4);
  EXPECT_EQ(served.server().endpoint.connections(), 2u);
  slow.run(2);
  EXPECT_EQ(served.server().endpoint.connections(), 1u);
  EXPECT_THAT(served.console(), HasSubstr("does not answer"));
  served.run(30);  // the slow one sends nothing now
  slow.say("prespawn");
  slow.run(1);
  EXPECT_EQ(slow.signon, 2);
}

TEST(Joining, ANewcomerThatNeverGetsThereLosesItsSlot) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t player = served.add_client("player");
  ASSERT_TRUE(served.run_until_playing(player));
  SlowClient slow(served);
  slow.run(70);
  slow.say("prespawn");
  slow.run(70);
  EXPECT_EQ(served.server().endpoint.connections(), 2u);
  slow.run(10);
  EXPECT_EQ(served.server().endpoint.connections(), 1u);
  EXPECT_THAT(served.console(), HasSubstr("did not finish to join"));
  EXPECT_TRUE(served.client(player).is_playing());
}

// A program whose worldspawn and player code do the rest.
server::Game& game_with(std::optional<ServedGame>& out_served, std::string_view field,
                        std::string_view line) {
  std::string program = small_program(field);
  const std::string_view spawn = "void() worldspawn = {";
  program.insert(program.find(spawn) + spawn.size(), line);
  out_served.emplace(program);
  return out_served->game();
}

TEST(Joining, TheProtocolHasRoomForHowEntitiesLook) {
  SKIP_WITHOUT_QUAKEC();
  std::optional<ServedGame> served;
  const auto protocol = [&](std::string_view field, std::string_view line) {
    return game_with(served, field, line).setup().dialect.protocol;
  };
  EXPECT_EQ(protocol(".float alpha, scale;\n", ""), net::Protocol::kNetQuake);
  EXPECT_EQ(protocol(".float scale;\n", " local entity e; e = spawn(); e.scale = 2; "),
            net::Protocol::kFitzQuake);
  EXPECT_EQ(protocol(".float alpha;\n", " local entity e; e = spawn(); e.alpha = 0.5; "),
            net::Protocol::kFitzQuake);
}

// DarkPlaces prints packets like this one whether it is connected or not.
std::string read_notice_after_leaving(std::string_view protocol) {
  ServedGame served;
  CHECK(served.variables().set("sv_protocol", protocol).ok());
  served.command("map small");
  served.run(0.1);
  RawPeer peer(served, 9);
  peer.request_connection();
  served.run(0.1);
  peer.acknowledge_first();
  served.run(0.1);
  CHECK(served.server().endpoint.connections() == 1);
  peer.send(std::string_view("\0\x10\0\x09\0\0\0\0\x02", 9));  // clc_disconnect
  served.run(0.1);
  std::string notice;
  while (const auto datagram = peer.receive())
    if (base::as_text(datagram->bytes).starts_with("\xff\xff\xff\xffn"))
      notice = base::as_text(datagram->bytes);
  return notice + served.console();
}

TEST(Joining, AClientThatCannotReadTheProtocolIsSentTheSettingForIt) {
  SKIP_WITHOUT_QUAKEC();
  const std::string notice = read_notice_after_leaving("666");
  EXPECT_THAT(notice, HasSubstr("nThis game uses protocol 666."));
  EXPECT_THAT(notice, HasSubstr("as DarkPlaces, set: sv_protocol 15"));
  EXPECT_THAT(read_notice_after_leaving("15"), Not(HasSubstr("sv_protocol")));
}

}  // namespace
}  // namespace temblor::test
