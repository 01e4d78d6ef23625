// ServerEndpoint against hand-made packets of stock clients, and of attackers.
#include "net/transport/server_endpoint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "net/transport/endpoint_bench.h"
#include "support/effort.h"
#include "support/mutations.h"

namespace temblor::net {
namespace {

using test::BadNetwork;
using test::host;
using test::kServer;
using test::ServerOnBench;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using namespace std::string_literals;

const std::string kConnect = "\x80\0\0\x0c\x01QUAKE\0\x03"s;
const std::string kAccept = "\x80\0\0\x09\x81\x90\x65\0\0"s;  // port 26000
const std::string kProbe = "\0\x09\0\x09\0\0\0\0\x01"s;       // svc_nop
const std::string kAck = "\0\x02\0\x08\0\0\0\0"s;
const std::string kInfo = "\x80\0\0\x0c\x02QUAKE\0\x03"s;

// A peer with a bare socket.
struct BarePeer {
  BarePeer(BadNetwork& network, const platform::Address& address) : socket(network.open(address)) {}

  void send(std::string_view bytes) { socket->send(kServer, base::as_bytes(bytes)); }
  std::vector<std::string> received() {
    std::vector<std::string> all;
    while (const auto datagram = socket->receive()) all.emplace_back(base::as_text(datagram->bytes));
    return all;
  }
  std::unique_ptr<platform::DatagramSocket> socket;
};

std::string unreliable(int sequence, std::string_view content) {
  return "\0\x10\0"s + static_cast<char>(8 + content.size()) + "\0\0"s + static_cast<char>(sequence >> 8) +
         static_cast<char>(sequence) + std::string(content);
}
std::string reliable(int sequence, std::string_view content) {
  std::string packet = unreliable(sequence, content);
  packet[1] = '\x09';
  return packet;
}

struct Bench {
  explicit Bench(const ServerEndpointSettings& settings = {}) : server(network, settings) {}
  void tick(double seconds = 0) {
    now_s += seconds;
    network.advance_to(now_s);
    server.tick(now_s);
  }
  void connect(BarePeer& peer) {
    peer.send(kConnect);
    tick();
    peer.send(kAck);
    tick();
    peer.received();
  }

  BadNetwork network{{}, 1};
  ServerOnBench server;
  double now_s = 100;
};

TEST(ServerEndpoint, CompletesHandshakeOfStockClient) {
  Bench bench;
  BarePeer client(bench.network, host(2, 5000));
  client.send(kConnect + "\x01\x22"s);  // extra bytes of another engine are ignored...
  bench.tick();
  EXPECT_THAT(client.received(), IsEmpty());  // ...but not beyond the size in the header
  client.send(kConnect);
  bench.tick();
  EXPECT_THAT(client.received(), ElementsAre(kAccept, kProbe));
  EXPECT_THAT(bench.server.taken(), IsEmpty());
  client.send(kAck);
  bench.tick();
  EXPECT_THAT(bench.server.taken(), ElementsAre("+1"));
  EXPECT_EQ(bench.server.endpoint.peer_address(ConnectionId{1}), host(2, 5000));
  client.send(unreliable(0, "\x02"));
  client.send(reliable(0, "\x04hi\0"s));
  bench.tick();
  EXPECT_THAT(bench.server.taken(), ElementsAre("1U:\x02"s, "1R:\x04hi\0"s));
  EXPECT_THAT(client.received(), ElementsAre(kAck));
  EXPECT_TRUE(bench.server.send(1, "hello"));
  EXPECT_THAT(client.received(), ElementsAre("\0\x09\0\x0d\0\0\0\x01hello"s));
}

// Data proves nothing, because a forger can send it blindly. It is not acknowledged, so a client repeats it.
TEST(ServerEndpoint, OnlyAcknowledgmentCompletesHandshake) {
  Bench bench;
  BarePeer client(bench.network, host(2, 5000));
  client.send(kConnect);
  bench.tick();
  client.received();
  client.send(unreliable(0, "x"));
  client.send(reliable(0, "y"));
  bench.tick();
  EXPECT_THAT(bench.server.taken(), IsEmpty());
  EXPECT_THAT(client.received(), IsEmpty());
  client.send(kAck);
  client.send(reliable(0, "y"));
  bench.tick();
  EXPECT_THAT(bench.server.taken(), ElementsAre("+1", "1R:y"));
}

TEST(ServerEndpoint, AcceptsLongerRequestOfProQuake) {
  Bench bench;
  BarePeer client(bench.network, host(2, 5000));
  client.send("\x80\0\0\x10\x01QUAKE\0\x03\x01\x22\0\0"s);
  bench.tick();
  EXPECT_THAT(client.received(), ElementsAre(kAccept, kProbe));
}

TEST(ServerEndpoint, RepeatedRequestGetsSameReply) {
  Bench bench;
  BarePeer client(bench.network, host(2, 5000));
  for (int i = 0; i < 3; ++i) client.send(kConnect);
  bench.tick();
  EXPECT_THAT(client.received(), ElementsAre(kAccept, kProbe, kAccept, kAccept));
  client.send(kAck);
  client.send(kConnect);  // a late copy, within two seconds
  bench.tick();
  EXPECT_THAT(client.received(), ElementsAre(kAccept));
  EXPECT_THAT(bench.server.taken(), ElementsAre("+1"));
  EXPECT_EQ(bench.server.endpoint.connections(), 1u);
}

TEST(ServerEndpoint, PeerIsAddressAndPort) {
  Bench bench;
  BarePeer first(bench.network, host(2, 5000)), second(bench.network, host(2, 5001));
  bench.connect(first);
  bench.connect(second);
  EXPECT_THAT(bench.server.taken(), ElementsAre("+1", "+2"));
  first.send(unreliable(0, "a"));
  second.send(unreliable(0, "b"));
  bench.tick();
  EXPECT_THAT(bench.server.taken(), ElementsAre("1U:a", "2U:b"));
}

TEST(ServerEndpoint, ClientReconnectsFromSamePort) {
  Bench bench;
  BarePeer client(bench.network, host(2, 5000));
  bench.connect(client);
  bench.tick(1.9);
  client.send(unreliable(0, "a"));
  bench.tick(1);
  bench.server.taken();
  // While the connection is alive, a request with its address is forged.
  client.send(kConnect);
  bench.tick();
  EXPECT_THAT(client.received(), IsEmpty());
  bench.tick(3);
  client.send(kConnect);
  bench.tick();
  EXPECT_THAT(bench.server.taken(), ElementsAre("-1 reconnected"));
  EXPECT_THAT(client.received(), ElementsAre(HasSubstr("reconnected"), kAccept, kProbe));
  client.send(kAck);
  bench.tick();
  EXPECT_THAT(bench.server.taken(), ElementsAre("+2"));
}

TEST(ServerEndpoint, AnnouncesPortOfNat) {
  Bench bench({.announced_port = 1000});
  BarePeer client(bench.network, host(2, 5000));
  client.send(kConnect);
  bench.tick();
  EXPECT_THAT(client.received(), ElementsAre("\x80\0\0\x09\x81\xe8\x03\0\0"s, kProbe));
}

TEST(ServerEndpoint, HalfOpenConnectionExpires) {
  Bench bench;
  BarePeer client(bench.network, host(2, 5000));
  client.send(kConnect);
  bench.tick();
  for (int i = 0; i < 100; ++i) bench.tick(0.5);
  // The reply, and one resent byte per second until it expires.
  EXPECT_LE(client.received().size(), 12u);
  client.send(kAck);
  bench.tick();
  EXPECT_THAT(bench.server.taken(), IsEmpty());
  EXPECT_EQ(bench.server.endpoint.connections(), 0u);
}

TEST(ServerEndpoint, ChallengedPeerMustReturnCookie) {
  Bench bench({.challenge = true, .secret = {1, 2}});
  BarePeer client(bench.network, host(2, 5000));
  client.send(kConnect);
  bench.tick();
  client.received();
  client.send(kAck);
  bench.tick();
  EXPECT_THAT(bench.server.taken(), IsEmpty());
  const auto asked = client.received();
  ASSERT_EQ(asked.size(), 1u);
  // svc_stufftext "cmd COOKIE".
  ASSERT_THAT(asked[0], ::testing::StartsWith("\0\x09\0\x19\0\0\0\x01\x09"
                                              "cmd "s));
  const std::string word = asked[0].substr(13, 10);
  // Guessed acknowledgments and wrong cookies do not connect.
  client.send("\0\x02\0\x08\0\0\0\x01"s);
  client.send(reliable(0,
                       "\x04"
                       "0123456789\0"s));
  client.send(reliable(1, "\x04prespawn\0"s));
  client.send(reliable(2, "\x07"));
  bench.tick();
  EXPECT_THAT(bench.server.taken(), IsEmpty());
  client.send(reliable(3, "\x01\x04" + word + "\n\0\x04name x\0"s));
  bench.tick();
  EXPECT_THAT(bench.server.taken(), ElementsAre("+1", "1R:\x01\x04name x\0"s));
}

TEST(ServerEndpoint, RejectsWhenFullAndOtherVersions) {
  Bench bench({.max_connections = 1});
  BarePeer first(bench.network, host(2, 1)), second(bench.network, host(3, 1));
  bench.connect(first);
  second.send(kConnect);
  bench.tick();
  EXPECT_THAT(second.received(), ElementsAre("\x80\0\0\x16\x82Server is full.\n\0"s));
  second.send("\x80\0\0\x0c\x01QUAKE\0\x04"s);
  bench.tick();
  EXPECT_THAT(second.received(), ElementsAre(HasSubstr("Incompatible version.")));
}

// Half-open peers reserve no slot: the first to acknowledge gets it.
TEST(ServerEndpoint, LastSlotGoesToFirstAcknowledgment) {
  Bench bench({.max_connections = 1});
  BarePeer first(bench.network, host(2, 1)), second(bench.network, host(3, 1));
  first.send(kConnect);
  second.send(kConnect);
  bench.tick();
  second.send(kAck);
  first.send(kAck);
  bench.tick();
  EXPECT_THAT(bench.server.taken(), ElementsAre("+1"));
  EXPECT_EQ(bench.server.endpoint.peer_address(ConnectionId{1}), host(3, 1));
  EXPECT_THAT(first.received().back(), HasSubstr("Server is full."));
}

TEST(ServerEndpoint, ResendsDisconnectWhilePeerKeepsSending) {
  Bench bench;
  BarePeer client(bench.network, host(2, 1));
  bench.connect(client);
  bench.server.endpoint.disconnect(ConnectionId{1}, "kicked\n");  // one line, whatever its end
  // svc_print, svc_disconnect.
  EXPECT_THAT(client.received(), ElementsAre(unreliable(0, "\x08kicked\n\0\x02"s)));
  EXPECT_FALSE(bench.server.send(1, "x"));
  EXPECT_FALSE(bench.server.endpoint.can_send_reliable(ConnectionId{1}));
  std::size_t resent = 0;
  for (int i = 0; i < 2000; ++i) {
    client.send(unreliable(i, "x"));
    bench.tick(0.01);
    resent += client.received().size();
  }
  EXPECT_GT(resent, 5u);
  EXPECT_LE(resent, 21u);
  bench.server.taken();
  bench.connect(client);
  EXPECT_THAT(bench.server.taken(), ElementsAre("+2"));
}

TEST(ServerEndpoint, SilentConnectionsTimeOut) {
  Bench bench({.timeout_s = 30});
  BarePeer silent(bench.network, host(2, 1)), lively(bench.network, host(3, 1));
  bench.connect(silent);
  bench.connect(lively);
  bench.server.taken();
  for (int i = 0; i < 35; ++i) {
    lively.send(unreliable(i, ""));
    bench.tick(1);
  }
  const auto lines = bench.server.taken();
  EXPECT_EQ(std::count(lines.begin(), lines.end(), "-1 timed out"), 1);
  EXPECT_EQ(bench.server.endpoint.connections(), 1u);
}

// It keeps sending, but never acknowledges the server's first message.
TEST(ServerEndpoint, PeerThatAcknowledgesNothingIsDroppedAfterFiveSeconds) {
  Bench bench;
  BarePeer bad(bench.network, host(2, 1)), slow(bench.network, host(3, 1)), idle(bench.network, host(4, 1));
  bench.connect(bad);
  bench.connect(slow);
  bench.connect(idle);  // is sent nothing that it could acknowledge
  bench.server.taken();
  ASSERT_TRUE(bench.server.send(1, std::string(3000, 'a')));
  ASSERT_TRUE(bench.server.send(2, std::string(3000, 'a')));
  slow.send("\0\x02\0\x08\0\0\0\x01"s);  // of the first fragment of three
  for (int i = 0; i < 49; ++i) {
    bad.send(unreliable(i, "garbage"));
    bench.tick(0.1);
  }
  EXPECT_EQ(bench.server.endpoint.connections(), 3u);
  bench.server.taken();
  bench.tick(0.2);
  bench.tick(60);
  EXPECT_THAT(bench.server.taken(), ElementsAre("-1 does not answer"));
  EXPECT_EQ(bench.server.endpoint.connections(), 2u);
}

// A crashed client may come back from another port while its old connection still waits for packets.
TEST(ServerEndpoint, FullServerReplacesSilentConnectionOfSameHost) {
  Bench bench({.max_connections = 2});
  BarePeer crashed(bench.network, host(2, 1)), lively(bench.network, host(3, 1));
  bench.connect(crashed);
  bench.connect(lively);
  bench.server.taken();
  bench.tick(9);
  lively.send(unreliable(0, ""));
  BarePeer early(bench.network, host(2, 2)), outsider(bench.network, host(4, 1)),
      back(bench.network, host(2, 3)), neighbor(bench.network, host(3, 2));
  early.send(kConnect);
  bench.tick(0);
  EXPECT_THAT(early.received(), ElementsAre(HasSubstr("Server is full.")));
  bench.tick(2);
  for (BarePeer* peer : {&outsider, &neighbor}) {
    bench.connect(*peer);
    bench.tick();
  }
  EXPECT_EQ(bench.server.endpoint.peer_address(ConnectionId{1}), host(2, 1));
  // A forged request changes nothing before its acknowledgment.
  back.send(kConnect);
  bench.tick();
  EXPECT_EQ(bench.server.endpoint.peer_address(ConnectionId{1}), host(2, 1));
  bench.server.taken();
  back.send(kAck);
  bench.tick();
  EXPECT_THAT(bench.server.taken(), ElementsAre("-1 replaced by a new connection from its address", "+3"));
  EXPECT_EQ(bench.server.endpoint.peer_address(ConnectionId{2}), host(3, 1));
}

TEST(ServerEndpoint, BansRejectAndDisconnect) {
  Bench bench;
  BarePeer bad(bench.network, host(2, 1)), worse(bench.network, host(2, 2)),
      good(bench.network, host(300, 1));
  bench.connect(bad);
  bench.connect(good);
  bench.server.taken();
  bench.server.endpoint.ban(*parse_prefix("10.0.0.0/24"));
  bench.server.endpoint.ban(*parse_prefix("10.0.0.0/24"));
  bench.tick();
  EXPECT_THAT(bench.server.taken(), ElementsAre("-1 banned"));
  worse.send(kConnect);
  bench.tick();
  EXPECT_THAT(worse.received(), ElementsAre(HasSubstr("You are banned.")));
  EXPECT_EQ(bench.server.endpoint.connections(), 1u);
  EXPECT_TRUE(bench.server.endpoint.unban(*parse_prefix("10.0.0.0/24")));
  EXPECT_FALSE(bench.server.endpoint.unban(*parse_prefix("10.0.0.0/24")));
  bench.connect(worse);
  EXPECT_THAT(bench.server.taken(), ElementsAre("+3"));
}

TEST(ServerEndpoint, ExplainsToQuakeWorldClientsThatTheyCannotJoin) {
  Bench bench;
  BarePeer asker(bench.network, host(2, 1));
  asker.send("\xff\xff\xff\xffgetchallenge\n"s);
  asker.send("\xff\xff\xff\xffstatus\n"s);  // of server lists, which must not show this server
  asker.send("\xff\xff\xff\xffgetstatus\n"s);
  asker.send("\xff\xff\xff\xff"s);
  bench.tick();
  EXPECT_THAT(asker.received(),
              ElementsAre("\xff\xff\xff\xffnThis is a Quake server. QuakeWorld clients cannot "
                          "join it: use a Quake client.\n"));
  EXPECT_EQ(bench.server.endpoint.statistics().malformed, 2u) << "our own clients ask for the status, too";
}

TEST(ServerEndpoint, RepliesToQueries) {
  Bench bench;
  BarePeer asker(bench.network, host(2, 1));
  asker.send(kInfo);
  asker.send("\x80\0\0\x06\x03\0"s);
  asker.send("\x80\0\0\x06\x03\x01"s);  // no such player
  asker.send("\x80\0\0\x06\x04\0"s);
  asker.send(
      "\x80\0\0\x0f\x04"
      "fraglimit\0"s);
  asker.send(
      "\x80\0\0\x0f\x04"
      "timelimit\0"s);
  asker.send(
      "\x80\0\0\x08\x04"
      "xx\0"s);
  bench.tick();
  EXPECT_THAT(asker.received(),
              ElementsAre("\x80\0\0\x22\x83"
                          "10.0.0.1:26000\0a host\0dm1\0\x01\x10\x03"s,
                          "\x80\0\0\x1e\x84\0bob\0\x4d\0\0\0\xfe\xff\xff\xff\x3d\0\0\0private\0"s,
                          "\x80\0\0\x12\x85"
                          "fraglimit\0"
                          "20\0"s,
                          "\x80\0\0\x12\x85"
                          "timelimit\0"
                          "10\0"s,
                          "\x80\0\0\x05\x85"s));
}

TEST(ServerEndpoint, RunsRemoteCommandsWithPassword) {
  Bench bench;
  BarePeer master(bench.network, host(2, 1));
  const std::string say = "\x80\0\0\x13\x05secret\0status\0"s;
  master.send(say);
  bench.tick();
  EXPECT_THAT(bench.server.taken(), IsEmpty());
  bench.server.endpoint.set_remote_password("secret");
  bench.tick(60);
  master.send(say);
  bench.tick();
  EXPECT_THAT(bench.server.taken(), ElementsAre("rcon status"));
  EXPECT_THAT(master.received(), ElementsAre("\x80\0\0\x0a\x86"
                                             "done\0"s));
  for (int i = 0; i < 1000; ++i) master.send("\x80\0\0\x13\x05sEcret\0status\0"s);
  master.send(say);  // ignored after too many wrong passwords
  bench.tick();
  EXPECT_THAT(bench.server.taken(), IsEmpty());
  EXPECT_THAT(master.received(), IsEmpty());
}

TEST(ServerEndpoint, SplitsRemoteCommandReplies) {
  Bench bench;
  BarePeer master(bench.network, host(2, 1));
  bench.server.endpoint.reply_to_remote_command({host(2, 1), 0, {}}, std::string(100000, 'x'));
  std::size_t bytes = 0;
  for (const std::string& packet : master.received()) bytes += packet.size() - 6;
  EXPECT_EQ(bytes, ServerEndpoint::kMaxRemoteReplyBytes);
}

TEST(ServerEndpoint, MessageLimitsFollowProtocol) {
  Bench bench;
  BarePeer client(bench.network, host(2, 1));
  bench.connect(client);
  const base::ByteVector large(1400);
  EXPECT_FALSE(bench.server.endpoint.send_unreliable(ConnectionId{1}, large).ok());
  bench.server.endpoint.set_protocol(Protocol::kFitzQuake);
  EXPECT_TRUE(bench.server.endpoint.send_unreliable(ConnectionId{1}, large).ok());
  EXPECT_EQ(bench.server.endpoint.message_limits(ConnectionId{1}).reliable_bytes, 64000u);
}

TEST(HostileClient, EndlessMessageEndsConnection) {
  Bench bench;
  BarePeer bad(bench.network, host(2, 1)), good(bench.network, host(3, 1));
  bench.connect(bad);
  bench.connect(good);
  bench.server.taken();
  for (int i = 0; i < 64; ++i) {
    std::string packet = "\0\x01\x04\x08\0\0\0"s + static_cast<char>(i) + std::string(1024, 'a');
    bad.send(packet);
    bench.tick();
  }
  EXPECT_THAT(bench.server.taken(), ElementsAre("-1 reliable message exceeds 8192 bytes"));
  good.send(unreliable(0, "x"));
  bench.tick();
  EXPECT_THAT(bench.server.taken(), ElementsAre("2U:x"));
}

TEST(HostileClient, FloodIsRateLimitedAndOthersAreServed) {
  Bench bench;
  BarePeer bad(bench.network, host(2, 1)), good(bench.network, host(3, 1));
  bench.connect(bad);
  bench.connect(good);
  bench.server.taken();
  std::size_t from_bad = 0, from_good = 0;
  for (int tick = 0; tick < 72; ++tick) {
    for (int i = 0; i < 200; ++i) bad.send(unreliable(tick * 200 + i, "x"));
    good.send(unreliable(tick, "y"));
    bench.tick(1 / 72.0);
    for (const std::string& line : bench.server.taken()) ++(line == "2U:y" ? from_good : from_bad);
  }
  EXPECT_EQ(from_good, 72u);
  const Rate rate = ServerEndpointSettings{}.packets_per_connection;
  EXPECT_LE(static_cast<double>(from_bad), rate.burst + rate.per_second + 1);
  EXPECT_GT(bench.server.endpoint.statistics().rate_limited, 10000u);
}

TEST(HostileClient, ThousandPortsRequestConnections) {
  Bench bench;
  BarePeer player(bench.network, host(2, 1));
  bench.connect(player);
  bench.server.taken();
  std::vector<std::unique_ptr<platform::DatagramSocket>> ports;
  for (unsigned port = 1; port <= 1000; ++port) ports.push_back(bench.network.open(host(8, port)));
  for (int tick = 0; tick < 720; ++tick) {
    for (const auto& port : ports) port->send(kServer, base::as_bytes(kConnect));
    player.send(unreliable(tick, "y"));
    bench.tick(1 / 72.0);
    ASSERT_THAT(bench.server.taken(), ElementsAre("1U:y")) << tick;
  }
  std::uint64_t sent = 0;
  for (unsigned port = 1; port <= 1000; ++port) sent += bench.network.bytes_sent_to(host(8, port));
  EXPECT_LT(sent, 720 * 1000 * kConnect.size() / 100);
  // Another host can still connect.
  BarePeer late(bench.network, host(4, 1));
  bench.connect(late);
  EXPECT_THAT(bench.server.taken(), ElementsAre("+2"));
}

TEST(HostileClient, ForgedQueriesSendVictimLittle) {
  Bench bench;
  const platform::Address victim = host(7, 1);
  const auto forged = bench.network.open(victim);
  for (int tick = 0; tick < 7200; ++tick) {
    for (int i = 0; i < 20; ++i) forged->send(kServer, base::as_bytes(i % 2 ? kInfo : kConnect));
    bench.tick(1 / 72.0);
  }
  const std::uint64_t asked = 7200 * 20 * kInfo.size();
  EXPECT_LT(bench.network.bytes_sent_to(victim), asked / 10);
  EXPECT_GT(bench.server.endpoint.statistics().unanswered, 100000u);
}

// Only replies to queries are larger than their request.
TEST(HostileClient, UnverifiedPeerGetsNothingLargerThanItsRequest) {
  Bench bench;
  BarePeer peer(bench.network, host(2, 1));
  peer.send(kConnect);
  for (int i = 0; i < 100; ++i) bench.tick(0.2);
  for (const std::string& packet : peer.received()) EXPECT_LE(packet.size(), kConnect.size());
  for (std::size_t size = 1; size < 2000; size += 7) peer.send(std::string(size, '\0'));
  peer.send(reliable(0, "x"));
  bench.tick();
  EXPECT_THAT(peer.received(), IsEmpty());
}

TEST(HostileClient, RandomAndDamagedPacketsHarmNobodyElse) {
  Bench bench;
  BarePeer good(bench.network, host(3, 1));
  bench.connect(good);
  std::vector<std::unique_ptr<BarePeer>> others;
  for (unsigned i = 0; i < 8; ++i) {
    others.push_back(std::make_unique<BarePeer>(bench.network, host(10 + i, 1)));
    bench.connect(*others.back());
  }
  bench.server.taken();
  test::Random random(5);
  const std::string valid[] = {kConnect, kInfo, kAck, reliable(0, "x"), unreliable(1, "y")};
  for (int tick = 0; tick < test::effort(5000, 500); ++tick) {
    for (auto& other : others) {
      const base::ByteVector bytes =
          random.chance(0.7)
              ? test::with_flipped_bits(base::as_bytes(valid[random.below(std::size(valid))]), random)
              : test::random_bytes(random, random.below(1500));
      other->send(base::as_text(bytes));
    }
    good.send(unreliable(tick, "!"));
    bench.tick(1 / 72.0);
    const auto lines = bench.server.taken();
    ASSERT_EQ(std::count(lines.begin(), lines.end(), "1U:!"), 1) << tick;
  }
  EXPECT_LE(bench.server.endpoint.connections(), 16u);
}

}  // namespace
}  // namespace temblor::net
