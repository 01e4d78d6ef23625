// ClientEndpoint against hand-made replies of our servers, and of stock servers, which open a port for each
// client.
#include "net/transport/client_endpoint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "net/transport/endpoint_bench.h"
#include "support/effort.h"
#include "support/mutations.h"

namespace temblor::net {
namespace {

using test::BadNetwork;
using test::ClientOnBench;
using test::host;
using test::kServer;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using namespace std::string_literals;

const std::string kClientConnect = "\x80\0\0\x0c\x01QUAKE\0\x03"s;
const std::string kQuakeWorldStatus = "\xff\xff\xff\xffstatus\n";
const std::string kDarkPlacesStatus = "\xff\xff\xff\xffgetstatus\n";
const std::string kNop = "\0\x10\0\x09\0\0\0\0\x01"s;

struct ClientBench {
  ClientBench() { client.endpoint.connect(kServer, now_s); }

  void tick(double seconds = 0) {
    now_s += seconds;
    network.advance_to(now_s);
    client.tick(now_s);
  }
  void send(std::string_view bytes) { server->send(host(2, 1), base::as_bytes(bytes)); }
  static std::vector<std::string> received(platform::DatagramSocket& socket) {
    std::vector<std::string> all;
    while (const auto datagram = socket.receive()) all.emplace_back(base::as_text(datagram->bytes));
    return all;
  }
  std::vector<std::string> received() { return received(*server); }

  BadNetwork network{{}, 1};
  double now_s = 100;
  std::unique_ptr<platform::DatagramSocket> server = network.open(kServer);
  ClientOnBench client{network, host(2, 1)};
};

TEST(ClientEndpoint, GivesUpAfterThreeRequests) {
  ClientBench bench;
  EXPECT_THAT(bench.received(), ElementsAre(kClientConnect));
  bench.tick(2.4);
  EXPECT_THAT(bench.received(), IsEmpty());
  bench.tick(0.2);
  EXPECT_THAT(bench.received(), ElementsAre(kClientConnect, kQuakeWorldStatus, kDarkPlacesStatus));
  bench.tick(2.5);
  EXPECT_THAT(bench.received(), ElementsAre(kClientConnect, kQuakeWorldStatus, kDarkPlacesStatus));
  EXPECT_THAT(bench.client.taken(), IsEmpty());
  bench.tick(2.5);
  EXPECT_THAT(bench.client.taken(), ElementsAre("- No response from 10.0.0.1:26000."));
  EXPECT_EQ(bench.client.endpoint.state(), ClientEndpoint::State::kIdle);
  bench.tick(10);
  EXPECT_THAT(bench.received(), IsEmpty());
}

TEST(ClientEndpoint, ExplainsThatAServerSpeaksQuakeWorld) {
  ClientBench bench;
  bench.tick(2.6);
  bench.send("\xff\xff\xff\xffn\\maxclients\\8\\map\\dm6\n"s);
  bench.tick();
  EXPECT_THAT(bench.client.taken(), ElementsAre("- 10.0.0.1:26000 is a QuakeWorld server. Temblor plays on "
                                                "Quake servers (NetQuake) only."));
  EXPECT_EQ(bench.client.endpoint.state(), ClientEndpoint::State::kIdle);
}

// A DarkPlaces server with its own protocol answers only this; another one also lets us join.
TEST(ClientEndpoint, ExplainsThatDarkPlacesHasAnotherProtocol) {
  ClientBench bench;
  bench.tick(2.6);
  bench.send("\xff\xff\xff\xffstatusResponse\n\\gamename\\DarkPlaces-Quake"s);
  bench.tick();
  EXPECT_THAT(bench.client.taken(), IsEmpty());
  bench.tick(2.5);
  bench.tick(2.5);
  EXPECT_THAT(
      bench.client.taken(),
      ElementsAre("- 10.0.0.1:26000 is a DarkPlaces server with a protocol of its own; its host can set "
                  "sv_protocolname to QUAKE"));
  bench.client.endpoint.connect(kServer, bench.now_s);
  for (int i = 0; i < 3; ++i) bench.tick(2.6);
  EXPECT_THAT(bench.client.taken(), ElementsAre("- No response from 10.0.0.1:26000."));
}

TEST(ClientEndpoint, OtherPacketsOutsideAConnectionAreIgnored) {
  ClientBench bench;
  for (const auto& text :
       {"\xff\xff\xff\xffstatusResponse\n\\a\\b"s, "\xff\xff\xff\xffn"s, "\xff\xff\xff\xff"s}) {
    bench.send(text);
    bench.tick();
  }
  EXPECT_THAT(bench.client.taken(), IsEmpty());
  EXPECT_EQ(bench.client.endpoint.state(), ClientEndpoint::State::kConnecting);
}

TEST(ClientEndpoint, FollowsStockServerToNewPort) {
  ClientBench bench;
  const auto fresh = bench.network.open(host(1, 40000));
  bench.send("\x80\0\0\x09\x81\x40\x9c\0\0"s);
  bench.tick();
  EXPECT_THAT(bench.client.taken(), ElementsAre("+"));
  EXPECT_THAT(ClientBench::received(*fresh), ElementsAre(kNop));
  fresh->send(host(2, 1), base::as_bytes("\0\x09\0\x0a\0\0\0\0hi"s));
  bench.tick();
  EXPECT_THAT(bench.client.taken(), ElementsAre("R:hi"));
  EXPECT_THAT(ClientBench::received(*fresh), ElementsAre("\0\x02\0\x08\0\0\0\0"s));
  // The first port no longer belongs to the server.
  bench.send("\0\x10\0\x09\0\0\0\0x"s);
  bench.tick();
  EXPECT_THAT(bench.client.taken(), IsEmpty());
}

TEST(ClientEndpoint, AcceptsServerWhoseNatHidesAnnouncedPort) {
  ClientBench bench;
  bench.send("\x80\0\0\x09\x81\x40\x9c\0\0"s);
  bench.send("\0\x09\0\x0a\0\0\0\0hi"s);
  bench.tick();
  EXPECT_THAT(bench.client.taken(), ElementsAre("+", "R:hi"));
  EXPECT_EQ(bench.client.endpoint.server(), kServer);
  bench.received();
  EXPECT_TRUE(bench.client.send("yes"));
  EXPECT_THAT(bench.received(), ElementsAre("\0\x09\0\x0b\0\0\0\0yes"s));
}

TEST(ClientEndpoint, InvalidPortMeansRequestedPort) {
  for (const std::string& port : {"\0\0\0\0"s, "\xff\xff\xff\xff"s, "\0\0\x01\0"s}) {
    ClientBench bench;
    bench.send("\x80\0\0\x09\x81"s + port);
    bench.tick();
    EXPECT_THAT(bench.client.taken(), ElementsAre("+"));
    EXPECT_EQ(bench.client.endpoint.server(), kServer);
  }
}

TEST(ClientEndpoint, ReportsRejection) {
  ClientBench bench;
  bench.send("\x80\0\0\x16\x82Server is full.\n\0"s);
  bench.tick();
  EXPECT_THAT(bench.client.taken(), ElementsAre("- Server is full."));
  EXPECT_FALSE(bench.client.send("x"));
}

TEST(ClientEndpoint, IgnoresOtherSenders) {
  ClientBench bench;
  const auto other = bench.network.open(host(5, 26000));
  other->send(host(2, 1), base::as_bytes("\x80\0\0\x09\x81\x90\x65\0\0"s));
  bench.tick();
  EXPECT_THAT(bench.client.taken(), IsEmpty());
  bench.send("\x80\0\0\x09\x81\x90\x65\0\0"s);
  other->send(host(2, 1), base::as_bytes("\0\x10\0\x09\0\0\0\0x"s));
  bench.tick();
  EXPECT_THAT(bench.client.taken(), ElementsAre("+"));
}

TEST(ClientEndpoint, SendsDisconnectThreeTimes) {
  ClientBench bench;
  bench.send("\x80\0\0\x09\x81\x90\x65\0\0"s);
  bench.tick();
  bench.received();
  bench.client.endpoint.disconnect();
  EXPECT_THAT(bench.received(), ElementsAre("\0\x10\0\x09\0\0\0\x01\x02"s, "\0\x10\0\x09\0\0\0\x02\x02"s,
                                            "\0\x10\0\x09\0\0\0\x03\x02"s));
  bench.client.endpoint.disconnect();
  EXPECT_THAT(bench.received(), IsEmpty());
}

TEST(ClientEndpoint, TimesOutSilentServer) {
  ClientBench bench;
  bench.send("\x80\0\0\x09\x81\x90\x65\0\0"s);
  bench.tick();
  bench.client.taken();
  bench.tick(299);
  EXPECT_THAT(bench.client.taken(), IsEmpty());
  ASSERT_TRUE(bench.client.endpoint.silence());
  EXPECT_NEAR(bench.client.endpoint.silence()->lasts_s, 299, 0.1);
  EXPECT_NEAR(bench.client.endpoint.silence()->ends_in_s, 1, 0.1);
  bench.tick(2);
  EXPECT_THAT(bench.client.taken(), ElementsAre("- the server stopped responding"));
  EXPECT_FALSE(bench.client.endpoint.silence());
}

TEST(HostileServer, RandomPacketsCauseNoDuplicates) {
  test::Random random(4);
  for (int round = 0; round < test::effort(50, 5); ++round) {
    ClientBench bench;
    bench.send("\x80\0\0\x09\x81\x90\x65\0\0"s);
    bench.tick();
    EXPECT_THAT(bench.client.taken(), ElementsAre("+"));
    const std::string valid = "\0\x09\0\x09\0\0\0\0x"s;
    for (int i = 0; i < 200; ++i) {
      const base::ByteVector sent = random.chance(0.5)
                                        ? test::with_flipped_bits(base::as_bytes(valid), random)
                                        : test::random_bytes(random, random.below(40));
      bench.send(base::as_text(sent));
      bench.tick(0.01);
      bench.client.taken();
    }
    EXPECT_EQ(bench.client.endpoint.state(), ClientEndpoint::State::kConnected);
    bench.send(valid);
    bench.send(valid);
    bench.tick();
    const auto lines = bench.client.taken();
    EXPECT_LE(std::count(lines.begin(), lines.end(), "R:x"), 1);
  }
}

TEST(HostileServer, EndlessMessageEndsConnection) {
  ClientBench bench;
  bench.send("\x80\0\0\x09\x81\x90\x65\0\0"s);
  for (int i = 0; i < 100; ++i) {
    bench.send("\0\x01\x04\x08\0\0\0"s + static_cast<char>(i) + std::string(1024, 'a'));
    bench.tick(0.01);
  }
  EXPECT_THAT(bench.client.taken(), ElementsAre("+", "- reliable message exceeds 65535 bytes"));
}

}  // namespace
}  // namespace temblor::net
