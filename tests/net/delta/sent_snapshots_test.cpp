// Delta-compressed snapshots over a network that loses, duplicates, and reorders, compared with the stock
// messages.
#include "net/delta/sent_snapshots.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <map>

#include "net/protocol/dialects.h"
#include "net/protocol/random_message.h"
#include "support/effort.h"
#include "support/mutations.h"

namespace temblor::net {
namespace {

constexpr Dialect kDialect{Protocol::kFitzQuake, 0};

// Messages of players and monsters that appear, vanish, move, and stand.
class Crowd {
 public:
  Crowd(std::uint64_t seed, const Dialect& dialect) : random_(seed), dialect_(dialect) {}

  void step() {
    time_s_ += 1.0f / 72;
    for (int i = 0; i < 3; ++i) {
      const auto number = static_cast<std::uint16_t>(1 + random_.below(400));
      if (random_.chance(0.05)) entities_.erase(number);
      if (random_.chance(0.1)) entities_[number] = {.number = number, .model = std::uint16_t{3}};
    }
    for (auto& [number, entity] : entities_) {
      if (number % 3 == 0 && random_.chance(0.9)) continue;
      entity.frame = static_cast<std::uint16_t>((entity.frame.value_or(0) + 1) % 20);
      if (number % 3 == 1) continue;
      entity.origin[0] = std::remainder(entity.origin[0].value_or(0.0f) + 4.5f, 8000.0f);
      entity.origin[1] = std::remainder(entity.origin[1].value_or(0.0f) + 100.0f, 8000.0f);
      if (random_.chance(0.1)) entity.angles_deg[1] = static_cast<float>(random_.below(360));
    }
    health_ = static_cast<std::int16_t>(random_.chance(0.1) ? random_.below(100) : health_);
  }

  // Fills in the state, and returns the stock messages.
  base::ByteVector send(SnapshotState& out_state) {
    const base::ByteVector time = test::written(Time{time_s_}, dialect_);
    const base::ByteVector damage = test::written(Damage{1, 2}, dialect_);
    const base::ByteVector data = test::written(ClientData{.health = health_}, dialect_);
    const base::ByteVector event = test::written(TempEntity{.origin = random_.in_cube(100)}, dialect_);
    std::string line;
    write_acknowledgment(MoveAcknowledgment{.number = ++moves_, .origin = {time_s_, 0, 0}}, line);
    const base::ByteVector moves = test::written(StuffText{line}, dialect_);
    const SnapshotParts parts{.time = time,
                              .once = random_.chance(0.1) ? base::Bytes(damage) : base::Bytes{},
                              .client_data = data,
                              .acknowledgment = random_.chance(0.9) ? base::Bytes(moves) : base::Bytes{},
                              .events = random_.chance(0.1) ? base::Bytes(event) : base::Bytes{}};
    EXPECT_TRUE(parse_snapshot(parts, dialect_, out_state));
    base::ByteWriter whole;
    for (const base::Bytes part : {parts.time, parts.once, parts.client_data, parts.acknowledgment})
      whole.bytes(part);
    for (const auto& [number, entity] : entities_) {
      const base::ByteVector update = test::written(entity, dialect_);
      EXPECT_TRUE(parse_entity_update(update, dialect_, out_state.entities.emplace_back()));
      whole.bytes(update);
    }
    whole.bytes(parts.events);
    return std::move(whole).take();
  }
  test::Random& random() { return random_; }

 private:
  test::Random random_;
  Dialect dialect_;
  std::map<std::uint16_t, EntityUpdate> entities_;
  float time_s_ = 1;
  std::uint32_t moves_ = 0;
  std::int16_t health_ = 100;
};

struct SentPacket {
  base::ByteVector delta, stock;
};

SentPacket send(Crowd& io_crowd, SentSnapshots& io_sent) {
  io_crowd.step();
  SentPacket packet;
  packet.stock = io_crowd.send(io_sent.begin_snapshot());
  base::ByteWriter writer;
  io_sent.write(writer);
  io_sent.mark_sent();
  packet.delta = std::move(writer).take();
  return packet;
}

// The stock messages; nullopt if the reference is missing.
std::optional<base::ByteVector> read(ReceivedSnapshots& io_received, const base::ByteVector& packet,
                                     const Dialect& dialect = kDialect) {
  const auto stock = io_received.read(packet, dialect);
  EXPECT_TRUE(stock.ok()) << stock.error().message();
  if (!stock.ok() || !*stock) return std::nullopt;
  return base::ByteVector((*stock)->begin(), (*stock)->end());
}

class SentSnapshotsIn : public ::testing::TestWithParam<Dialect> {};

// Packets and acknowledgments are delayed by random numbers of ticks, reordered, duplicated, or lost.
TEST_P(SentSnapshotsIn, AnyNetworkRestoreStockMessages) {
  for (std::uint64_t seed = 0; seed < test::effort(20, 4); ++seed) {
    Crowd crowd(seed, GetParam());
    test::Random& random = crowd.random();
    SentSnapshots sent;
    ReceivedSnapshots received;
    std::multimap<int, SentPacket> packets;
    std::multimap<int, std::uint16_t> acknowledgments;
    const double loss = random.uniform(0, 0.5);
    const std::size_t latest = 1 + random.below(90);  // sometimes longer than snapshots are kept
    std::size_t read_count = 0;
    for (int tick = 0; tick < 1500; ++tick) {
      const SentPacket packet = send(crowd, sent);
      for (int copy = 0; copy < 2; ++copy)
        if (!random.chance(copy == 0 ? loss : 0.95))
          packets.emplace(tick + static_cast<int>(random.below(latest)), packet);
      for (; !packets.empty() && packets.begin()->first <= tick; packets.erase(packets.begin())) {
        const SentPacket& arrived = packets.begin()->second;
        const auto stock = read(received, arrived.delta, GetParam());
        if (!stock) continue;
        ASSERT_EQ(*stock, arrived.stock) << "seed " << seed << ", tick " << tick;
        ++read_count;
      }
      if (received.latest() && !random.chance(loss))
        acknowledgments.emplace(tick + static_cast<int>(random.below(latest)), *received.latest());
      for (; !acknowledgments.empty() && acknowledgments.begin()->first <= tick;
           acknowledgments.erase(acknowledgments.begin()))
        sent.acknowledge(acknowledgments.begin()->second);
    }
    EXPECT_GT(read_count, 300u) << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Dialects, SentSnapshotsIn,
                         ::testing::Values(Dialect{Protocol::kNetQuake, 0}, Dialect{Protocol::kFitzQuake, 0},
                                           Dialect{Protocol::kRmq, kFloatCoord | kFloatAngle},
                                           Dialect{Protocol::kRmq, k24BitCoord | kShortAngle}),
                         [](const auto& dialect) {
                           return std::to_string(static_cast<int>(dialect.param.protocol)) + "_" +
                                  std::to_string(dialect.param.flags);
                         });

// Packets arrive in order with losses: every one that arrives can be decoded.
TEST(SentSnapshots, LostPacketCostsOnlyItsTick) {
  Crowd crowd(1, kDialect);
  SentSnapshots sent;
  ReceivedSnapshots received;
  std::deque<std::uint16_t> late;
  for (int tick = 0; tick < 3000; ++tick) {
    const SentPacket packet = send(crowd, sent);
    if (crowd.random().chance(0.3)) continue;
    ASSERT_EQ(read(received, packet.delta), packet.stock) << tick;
    late.push_back(*received.latest());
    if (late.size() > 10) {
      sent.acknowledge(late.front());
      late.pop_front();
    }
  }
}

TEST(SentSnapshots, UnchangedStateCostsAlmostNothing) {
  Crowd crowd(2, kDialect);
  for (int i = 0; i < 300; ++i) crowd.step();
  SentSnapshots sent;
  ReceivedSnapshots received;
  SentPacket last;
  for (int i = 0; i < 100; ++i) {
    last.stock = crowd.send(sent.begin_snapshot());
    base::ByteWriter writer;
    sent.write(writer);
    sent.mark_sent();
    last.delta = std::move(writer).take();
    ASSERT_EQ(read(received, last.delta), last.stock);
    sent.acknowledge(*received.latest());
  }
  EXPECT_GT(last.stock.size(), 500u);
  EXPECT_LT(last.delta.size(), 40u);
}

TEST(SentSnapshots, IgnoresForgedAcknowledgments) {
  Crowd crowd(3, kDialect);
  SentSnapshots sent;
  ReceivedSnapshots received;
  for (const int forged : {0, 1, 77, 65535}) sent.acknowledge(static_cast<std::uint16_t>(forged));
  for (int tick = 0; tick < 400; ++tick) {
    const SentPacket packet = send(crowd, sent);
    ASSERT_EQ(read(received, packet.delta), packet.stock);
    const std::uint16_t latest = *received.latest();
    sent.acknowledge(latest);
    // From the future, expired, half of the number range away, and older than the last.
    for (const int away : {1, 2, 1000, 32768, -static_cast<int>(kReferenceSnapshots), -1000, -3})
      sent.acknowledge(static_cast<std::uint16_t>(latest + away));
  }
}

TEST(SentSnapshots, NumbersWrapAroundAndSurviveReset) {
  Crowd crowd(4, kDialect);
  SentSnapshots sent;
  ReceivedSnapshots received;
  for (int tick = 0; tick < 70'000; ++tick) {
    // Fill in only a few: there are many.
    SnapshotState& state = sent.begin_snapshot();
    state.has_time = true;
    state.time = static_cast<std::uint32_t>(tick);
    base::ByteWriter writer;
    sent.write(writer);
    sent.mark_sent();
    const auto stock = read(received, writer.view());
    ASSERT_TRUE(stock.has_value()) << tick;
    ASSERT_EQ(base::ByteReader(base::Bytes(*stock).subspan(1)).u32(), state.time);
    sent.acknowledge(*received.latest());
  }
  const SentPacket late = send(crowd, sent);
  sent.reset();
  received.reset();
  EXPECT_FALSE(received.latest().has_value());
  EXPECT_FALSE(read(received, late.delta).has_value()) << "its reference is forgotten";
  sent.acknowledge(65535);
  for (int tick = 0; tick < 10; ++tick) {
    const SentPacket packet = send(crowd, sent);
    ASSERT_EQ(read(received, packet.delta), packet.stock);
    sent.acknowledge(*received.latest());
  }
}

TEST(SentSnapshots, UnsentSnapshotIsNeverReference) {
  Crowd crowd(5, kDialect);
  SentSnapshots sent;
  ReceivedSnapshots received;
  for (int tick = 0; tick < 200; ++tick) {
    crowd.step();
    crowd.send(sent.begin_snapshot());
    base::ByteWriter writer;
    sent.write(writer);  // without mark_sent()
    const SentPacket packet = send(crowd, sent);
    ASSERT_EQ(read(received, packet.delta), packet.stock);
    sent.acknowledge(static_cast<std::uint16_t>(*received.latest() + 1));
    sent.acknowledge(*received.latest());
  }
}

// Time and memory are bounded, and reads stay in bounds (checked by the address sanitizer).
TEST(SentSnapshots, SurviveRandomBytes) {
  test::Random random(6);
  Crowd crowd(6, kDialect);
  SentSnapshots sent;
  ReceivedSnapshots received;
  std::size_t refused = 0, read_count = 0;
  for (std::size_t i = 0; i < test::effort(5000, 300); ++i) {
    base::ByteVector bytes =
        random.chance(0.3) ? test::random_bytes(random, 4 + random.below(200)) : send(crowd, sent).delta;
    if (random.chance(0.5)) bytes = test::with_flipped_bits(bytes, random);
    bytes[0] = std::byte{kDeltaPacket};
    const auto stock = received.read(bytes, kDialect);
    refused += !stock.ok();
    read_count += stock.ok() && stock->has_value();
    if (stock.ok() && *stock) {
      EXPECT_LT((*stock)->size(), std::size_t{70'000});
    }
    if (received.latest() && random.chance(0.3)) sent.acknowledge(*received.latest());
  }
  EXPECT_GT(refused, 10u);
  EXPECT_GT(read_count, 10u);
  const base::ByteVector whole = send(crowd, sent).delta;
  for (std::size_t size = 0; size < 4; ++size)
    EXPECT_FALSE(received.read(base::Bytes(whole).first(size), kDialect).ok()) << size;
  base::ByteVector far = whole;
  far[3] = std::byte{kReferenceSnapshots};
  EXPECT_FALSE(received.read(far, kDialect).ok());
}

}  // namespace
}  // namespace temblor::net
