// Snapshots that are sent as deltas, in whole games: which clients get them, and what they decode.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "client_server/served_game.h"
#include "net/delta/sent_snapshots.h"
#include "net/protocol/dem_packets.h"
#include "net/transport/client_endpoint.h"
#include "support/programs/quakec.h"
#include "vfs/disk.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::uint8_t kTimeMessage = 7;

// A crowd that wanders around, comes and goes, and makes sounds.
std::string lively_program() {
  constexpr std::string_view kStill = "void() StartFrame = {};";
  std::string program = small_program(R"(
    void() wander = {
      self.nextthink = time + 0.1;
      self.frame = self.frame + 1;
      if (self.frame > 9) self.frame = 0;
      self.velocity_x = random() * 100 - 50;
      self.velocity_y = random() * 100 - 50;
      if (random() < 0.02) { self.effects = 2; sound(self, 1, "misc/hello.wav", 1, 1); }
      if (random() < 0.05) { if (self.skin) { setmodel(self, "progs/player.mdl"); self.skin = 0; }
                             else { self.model = ""; self.modelindex = 0; self.skin = 1; } }
    };
    void(vector at) wanderer = {
      local entity e;
      e = spawn(); e.movetype = 8; e.solid = 0;
      setmodel(e, "progs/player.mdl");
      setorigin(e, at);
      e.think = wander; e.nextthink = time + 0.1 + random();
    };
    float has_crowd;
    void() crowd = {
      local float i; local entity spot;
      if (has_crowd || time < 1.5) return;
      has_crowd = 1;
      spot = find(world, classname, "info_player_start");
      i = 0;
      while (i < 20) { wanderer(spot.origin); i = i + 1; }
    };
  )");
  const std::size_t at = program.find(kStill);
  CHECK(at != std::string::npos);
  return program.replace(at, kStill.size(), "void() StartFrame = { crowd(); };");
}

bool is_update(base::Bytes packet) {
  return !packet.empty() && std::to_integer<std::uint8_t>(packet[0]) == kTimeMessage;
}

std::vector<base::ByteVector> list_updates(base::Bytes recording) {
  std::vector<base::ByteVector> updates;
  for (const DemPacket& packet : dem_packets(recording))
    if (is_update(packet.bytes)) updates.emplace_back(packet.bytes.begin(), packet.bytes.end());
  return updates;
}

std::size_t pack_bytes(const std::vector<base::ByteVector>& packets) {
  std::size_t bytes = 0;
  for (const base::ByteVector& packet : packets) bytes += packet.size();
  return bytes;
}

// The snapshots that the server recorded for a player, without the signon of the recording.
std::vector<base::ByteVector> sent_snapshots(const ServedGame& served) {
  const auto recording = vfs::read_disk_file(served.folder().path() / "id1/film.dem");
  CHECK(recording.ok(), "{}", served.console());
  std::vector<base::ByteVector> updates = list_updates(*recording);
  updates.erase(updates.begin());
  return updates;
}

// A client made by hand: it joins, answers with `say_each_tick`, and stores unreliable messages.
class HandMadeClient {
 public:
  explicit HandMadeClient(ServedGame& io_served)
      : served_(io_served), endpoint_(io_served.network().open(platform::ip4_address({10, 0, 9, 9}, 4000))) {
    endpoint_.connect(kServedAddress, served_.now_s());
    for (int answered = 0; answered < 3; run(kTick_s, {})) {
      if (signon_ <= answered) continue;
      answered = signon_;
      constexpr std::array<std::string_view, 4> kAnswers = {"", "prespawn", "spawn", "begin"};
      base::ByteWriter writer;
      CHECK(net::write_client_message(net::StringCommand{kAnswers[static_cast<std::size_t>(answered)]},
                                      net::Protocol::kNetQuake, writer)
                .ok());
      CHECK(endpoint_.send_reliable(std::move(writer).take()).ok());
    }
  }

  // `head` precedes the move of each packet; empty: as in a stock client.
  void run(double seconds, const std::optional<net::NumberedPacket>& head) {
    for (const double until_s = served_.now_s() + seconds; served_.now_s() < until_s;) {
      served_.run(kTick_s);
      endpoint_.update(served_.now_s());
      while (const auto event = endpoint_.next_event(served_.now_s()))
        if (const auto* packet = std::get_if<net::FromServer>(&*event)) read(*packet);
      if (signon_ == 3) send_move(head);
    }
  }

  bool is_connected() const { return endpoint_.state() == net::ClientEndpoint::State::kConnected; }
  std::vector<base::ByteVector> packets;  // unreliable
  std::string stuffed;
  std::uint32_t moves = 0;

 private:
  void send_move(std::optional<net::NumberedPacket> head) {
    base::ByteWriter writer;
    if (head) {
      head->last_move = ++moves;
      CHECK(net::write_client_message(net::StringCommand{net::format_numbered_packet(*head)},
                                      net::Protocol::kNetQuake, writer)
                .ok());
    }
    CHECK(net::write_client_message(net::Move{.forward = 100}, net::Protocol::kNetQuake, writer).ok());
    CHECK(endpoint_.send_unreliable(std::move(writer).take()).ok());
  }
  void read(const net::FromServer& packet) {
    if (!packet.reliable) packets.emplace_back(packet.bytes.begin(), packet.bytes.end());
    reader_.begin(packet.bytes);
    for (auto message = reader_.next(); message.ok() && *message; message = reader_.next()) {
      if (const auto* number = std::get_if<net::SignonNumber>(&**message)) signon_ = number->number;
      if (const auto* text = std::get_if<net::StuffText>(&**message)) stuffed += text->text;
    }
  }

  ServedGame& served_;
  net::ClientEndpoint endpoint_;
  net::MessageReader reader_;
  int signon_ = 0;
};

// The client's demo holds the bytes that the server would have sent to a stock client, although only
// a small part of it was sent.
TEST(Differences, RecordingsOfBothEndsAreTheSame) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(lively_program());
  const std::size_t me = served.add_client("star");
  served.client(me).start_recording();
  ASSERT_TRUE(served.run_until_playing(me));
  served.run(3);
  served.command("record film");
  served.run(0.1);
  const platform::Address my_address = platform::ip4_address({10, 0, 0, 2}, 4000);
  const std::uint64_t sent_before = served.network().bytes_sent_to(my_address);
  for (int i = 0; i < 20; ++i)
    served.run(0.5, {.angles_deg = {0, static_cast<float>(i * 40), 0}, .forward = 300});
  const std::uint64_t sent = served.network().bytes_sent_to(my_address) - sent_before;
  served.command("stop");
  served.run(0.1);
  const auto own = served.client(me).finish_recording();
  ASSERT_TRUE(own.has_value());

  const std::vector<base::ByteVector> whole = sent_snapshots(served), got = list_updates(*own);
  ASSERT_GT(whole.size(), 700u);
  const auto begin = std::find(got.begin(), got.end(), whole.front());
  ASSERT_NE(begin, got.end());
  ASSERT_GE(static_cast<std::size_t>(got.end() - begin), whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i)
    ASSERT_EQ(begin[static_cast<std::ptrdiff_t>(i)], whole[i]) << i;
  EXPECT_GT(pack_bytes(whole), whole.size() * 200) << "else there is little to compress";
  EXPECT_LT(sent, pack_bytes(whole) / 4);
  ::testing::Test::RecordProperty("whole_bytes", static_cast<int>(pack_bytes(whole)));
  ::testing::Test::RecordProperty("sent_bytes", static_cast<int>(sent));
}

TEST(Differences, StockClientsAreSentTheSameAsEver) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(lively_program());
  HandMadeClient stock(served);
  served.command("record film");
  stock.run(0.1, {});
  stock.run(4, {});
  served.command("stop");
  stock.run(0.1, {});
  const std::vector<base::ByteVector> whole = sent_snapshots(served);
  ASSERT_GT(whole.size(), 250u);
  const auto begin = std::find(stock.packets.begin(), stock.packets.end(), whole.front());
  ASSERT_NE(begin, stock.packets.end());
  ASSERT_TRUE(std::equal(whole.begin(), whole.end(), begin));
  EXPECT_THAT(stock.stuffed, HasSubstr("//temblor moves"));
  EXPECT_THAT(stock.stuffed, Not(HasSubstr("differences")));
}

// A client that numbers its moves, but does not accept deltas.
TEST(Differences, AClientThatOnlyNumbersItsMovesGetsWholeSnapshots) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(lively_program());
  HandMadeClient client(served);
  client.run(3, net::NumberedPacket{});
  EXPECT_THAT(client.stuffed, HasSubstr(net::format_delta_offer()));
  EXPECT_GT(client.packets.size(), 200u);
  EXPECT_TRUE(std::all_of(client.packets.begin(), client.packets.end(), is_update));
}

TEST(Differences, ForgedAcknowledgmentsHarmNobody) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(lively_program());
  const std::size_t good = served.add_client("good");
  ASSERT_TRUE(served.run_until_playing(good));
  HandMadeClient forger(served);
  forger.run(1, net::NumberedPacket{});
  Random random(1);
  net::ReceivedSnapshots known;
  std::size_t read = 0;
  for (int i = 0; i < 1000; ++i) {
    net::NumberedPacket head{.accepts_deltas = true};
    head.received_snapshot = random.chance(0.5) && known.latest()
                                 ? static_cast<std::uint16_t>(*known.latest() + random.below(200) - 100)
                                 : static_cast<std::uint16_t>(random.below(65536));
    forger.packets.clear();
    forger.run(kTick_s, head);
    for (const base::ByteVector& packet : forger.packets) {
      if (!net::is_delta_packet(packet)) continue;
      const auto stock = known.read(packet, served.game().setup().dialect);
      ASSERT_TRUE(stock.ok()) << stock.error().message();
      read += stock->has_value();
    }
  }
  EXPECT_GT(read, 500u);
  EXPECT_TRUE(forger.is_connected());
  EXPECT_TRUE(served.client(good).is_playing());
}

// The level and its protocol change while packets are delayed, lost and duplicated.
TEST(Differences, LevelsAndProtocolsChangeInABadNetwork) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(
      lively_program(),
      {.conditions = {.loss = 0.1, .duplication = 0.05, .delay_s = 0.1, .jitter_s = 0.05}, .seed = 3});
  const std::size_t me = served.add_client("traveler"), other = served.add_client("other");
  ASSERT_TRUE(served.run_until_playing(me));
  ASSERT_TRUE(served.run_until_playing(other));
  const platform::Address my_address = platform::ip4_address({10, 0, 0, 2}, 4000);
  for (const std::string_view change :
       {"sv_protocol 666; changelevel small", "restart", "sv_protocol 999; map small",
        "sv_protocol 15; changelevel small", "reload"}) {
    served.command(change);
    served.run(8);
    ASSERT_TRUE(served.client(me).is_playing()) << change << ": " << served.client(me).disconnect_reason();
    ASSERT_TRUE(served.client(other).is_playing())
        << change << ": " << served.client(other).disconnect_reason();
    const std::uint64_t updates = served.client(me).updates();
    const std::uint64_t bytes = served.network().bytes_sent_to(my_address);
    served.run(4);
    EXPECT_GT(served.client(me).updates(), updates + 80) << change << ": late ones are ignored, as always";
    EXPECT_LT(served.network().bytes_sent_to(my_address) - bytes, 4u * 6000) << change;
  }
}

}  // namespace
}  // namespace temblor::test
