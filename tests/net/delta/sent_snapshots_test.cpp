// Updates told as differences over a network that loses, doubles and reorders, against the stock datagrams
// that they stand for.
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

// Players and monsters that come, go, walk and stand, as messages.
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

  // Fills in the state, and returns the stock datagram.
  base::ByteVector tell(SnapshotState& out_state) {
    const base::ByteVector time = test::written(Time{time_s_}, dialect_);
    const base::ByteVector damage = test::written(Damage{1, 2}, dialect_);
    const base::ByteVector data = test::written(ClientData{.health = health_}, dialect_);
    const base::ByteVector event = test::written(TempEntity{.origin = random_.in_cube(100)}, dialect_);
    std::string line;
    write_line(MoveAcknowledgement{.number = ++moves_, .origin = {time_s_, 0, 0}}, line);
    const base::ByteVector moves = test::written(StuffText{line}, dialect_);
    const UpdateParts parts{.time = time,
                            .once = random_.chance(0.1) ? base::Bytes(damage) : base::Bytes{},
                            .client_data = data,
                            .acknowledgement = random_.chance(0.9) ? base::Bytes(moves) : base::Bytes{},
                            .events = random_.chance(0.1) ? base::Bytes(event) : base::Bytes{}};
    EXPECT_TRUE(take_apart(parts, dialect_, out_state));
    base::ByteWriter whole;
    for (const base::Bytes part : {parts.time, parts.once, parts.client_data, parts.acknowledgement})
      whole.bytes(part);
    for (const auto& [number, entity] : entities_) {
      const base::ByteVector update = test::written(entity, dialect_);
      EXPECT_TRUE(take_apart(update, dialect_, out_state.entities.emplace_back()));
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

struct Packet {
  base::ByteVector difference, stock;
};

Packet tell(Crowd& io_crowd, SentSnapshots& io_told) {
  io_crowd.step();
  Packet packet;
  packet.stock = io_crowd.tell(io_told.next());
  base::ByteWriter writer;
  io_told.write(writer);
  io_told.tell();
  packet.difference = std::move(writer).take();
  return packet;
}

// The stock messages; nothing where the packet is to be passed over.
std::optional<base::ByteVector> read(ReceivedSnapshots& io_known, const base::ByteVector& packet,
                                     const Dialect& dialect = kDialect) {
  const auto stock = io_known.read(packet, dialect);
  EXPECT_TRUE(stock.ok()) << stock.error().message();
  if (!stock.ok() || !*stock) return std::nullopt;
  return base::ByteVector((*stock)->begin(), (*stock)->end());
}

class SentSnapshotsIn : public ::testing::TestWithParam<Dialect> {};

// Packets and acknowledgements arrive late by a random number of ticks each, in any order, twice, or never.
TEST_P(SentSnapshotsIn, AnyNetworkBecomeTheStockDatagrams) {
  for (std::uint64_t seed = 0; seed < test::effort(20, 4); ++seed) {
    Crowd crowd(seed, GetParam());
    test::Random& random = crowd.random();
    SentSnapshots told;
    ReceivedSnapshots known;
    std::multimap<int, Packet> packets;
    std::multimap<int, std::uint16_t> acknowledgements;
    const double loss = random.uniform(0, 0.5);
    const std::size_t latest = 1 + random.below(90);  // longer than updates are kept, too
    std::size_t read_count = 0;
    for (int tick = 0; tick < 1500; ++tick) {
      const Packet packet = tell(crowd, told);
      for (int copy = 0; copy < 2; ++copy)
        if (!random.chance(copy == 0 ? loss : 0.95))
          packets.emplace(tick + static_cast<int>(random.below(latest)), packet);
      for (; !packets.empty() && packets.begin()->first <= tick; packets.erase(packets.begin())) {
        const Packet& arrived = packets.begin()->second;
        const auto stock = read(known, arrived.difference, GetParam());
        if (!stock) continue;
        ASSERT_EQ(*stock, arrived.stock) << "seed " << seed << ", tick " << tick;
        ++read_count;
      }
      if (known.latest() && !random.chance(loss))
        acknowledgements.emplace(tick + static_cast<int>(random.below(latest)), *known.latest());
      for (; !acknowledgements.empty() && acknowledgements.begin()->first <= tick;
           acknowledgements.erase(acknowledgements.begin()))
        told.acknowledge(acknowledgements.begin()->second);
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

// Packets in order, as the channel brings them, some lost: each that comes is understood, whatever was lost.
TEST(SentSnapshots, ALostPacketCostsItsOwnTickOnly) {
  Crowd crowd(1, kDialect);
  SentSnapshots told;
  ReceivedSnapshots known;
  std::deque<std::uint16_t> late;
  for (int tick = 0; tick < 3000; ++tick) {
    const Packet packet = tell(crowd, told);
    if (crowd.random().chance(0.3)) continue;
    ASSERT_EQ(read(known, packet.difference), packet.stock) << tick;
    late.push_back(*known.latest());
    if (late.size() > 10) {
      told.acknowledge(late.front());
      late.pop_front();
    }
  }
}

TEST(SentSnapshots, WhatDoesNotChangeCostsNearlyNothing) {
  Crowd crowd(2, kDialect);
  for (int i = 0; i < 300; ++i) crowd.step();
  SentSnapshots told;
  ReceivedSnapshots known;
  Packet last;
  for (int i = 0; i < 100; ++i) {
    last.stock = crowd.tell(told.next());
    base::ByteWriter writer;
    told.write(writer);
    told.tell();
    last.difference = std::move(writer).take();
    ASSERT_EQ(read(known, last.difference), last.stock);
    told.acknowledge(*known.latest());
  }
  EXPECT_GT(last.stock.size(), 500u);
  EXPECT_LT(last.difference.size(), 40u);
}

TEST(SentSnapshots, ForgedAcknowledgementsChangeNothing) {
  Crowd crowd(3, kDialect);
  SentSnapshots told;
  ReceivedSnapshots known;
  for (const int forged : {0, 1, 77, 65535}) told.acknowledge(static_cast<std::uint16_t>(forged));
  for (int tick = 0; tick < 400; ++tick) {
    const Packet packet = tell(crowd, told);
    ASSERT_EQ(read(known, packet.difference), packet.stock);
    const std::uint16_t latest = *known.latest();
    told.acknowledge(latest);
    // Of the future, of what is forgotten, of half a turn of the numbers away, and older than the last.
    for (const int away : {1, 2, 1000, 32768, -static_cast<int>(kReferenceSnapshots), -1000, -3})
      told.acknowledge(static_cast<std::uint16_t>(latest + away));
  }
}

TEST(SentSnapshots, NumbersGoAroundAndLevelsBegin) {
  Crowd crowd(4, kDialect);
  SentSnapshots told;
  ReceivedSnapshots known;
  for (int tick = 0; tick < 70'000; ++tick) {
    // Only a few of them in full: there are many.
    SnapshotState& state = told.next();
    state.has_time = true;
    state.time = static_cast<std::uint32_t>(tick);
    base::ByteWriter writer;
    told.write(writer);
    told.tell();
    const auto stock = read(known, writer.view());
    ASSERT_TRUE(stock.has_value()) << tick;
    ASSERT_EQ(base::ByteReader(base::Bytes(*stock).subspan(1)).u32(), state.time);
    told.acknowledge(*known.latest());
  }
  const Packet late = tell(crowd, told);
  told.forget();
  known.forget();
  EXPECT_FALSE(known.latest().has_value());
  EXPECT_FALSE(read(known, late.difference).has_value()) << "it is told against what is forgotten";
  told.acknowledge(65535);
  for (int tick = 0; tick < 10; ++tick) {
    const Packet packet = tell(crowd, told);
    ASSERT_EQ(read(known, packet.difference), packet.stock);
    told.acknowledge(*known.latest());
  }
}

TEST(SentSnapshots, APacketThatWasNotSentAfterAllIsNeverAToldOne) {
  Crowd crowd(5, kDialect);
  SentSnapshots told;
  ReceivedSnapshots known;
  for (int tick = 0; tick < 200; ++tick) {
    crowd.step();
    crowd.tell(told.next());
    base::ByteWriter writer;
    told.write(writer);  // and not tell()
    const Packet packet = tell(crowd, told);
    ASSERT_EQ(read(known, packet.difference), packet.stock);
    told.acknowledge(static_cast<std::uint16_t>(*known.latest() + 1));
    told.acknowledge(*known.latest());
  }
}

// Bounded in time and memory, and nothing is read outside of the bytes (the address sanitizer looks on).
TEST(SentSnapshots, WithstandAnyBytes) {
  test::Random random(6);
  Crowd crowd(6, kDialect);
  SentSnapshots told;
  ReceivedSnapshots known;
  std::size_t refused = 0, read_count = 0;
  for (std::size_t i = 0; i < test::effort(5000, 300); ++i) {
    base::ByteVector bytes =
        random.chance(0.3) ? test::random_bytes(random, 4 + random.below(200)) : tell(crowd, told).difference;
    if (random.chance(0.5)) bytes = test::with_flipped_bits(bytes, random);
    bytes[0] = std::byte{kDeltaPacket};
    const auto stock = known.read(bytes, kDialect);
    refused += !stock.ok();
    read_count += stock.ok() && stock->has_value();
    if (stock.ok() && *stock) {
      EXPECT_LT((*stock)->size(), std::size_t{70'000});
    }
    if (known.latest() && random.chance(0.3)) told.acknowledge(*known.latest());
  }
  EXPECT_GT(refused, 10u);
  EXPECT_GT(read_count, 10u);
  const base::ByteVector whole = tell(crowd, told).difference;
  for (std::size_t size = 0; size < 4; ++size)
    EXPECT_FALSE(known.read(base::Bytes(whole).first(size), kDialect).ok()) << size;
  base::ByteVector far = whole;
  far[3] = std::byte{kReferenceSnapshots};
  EXPECT_FALSE(known.read(far, kDialect).ok());
}

}  // namespace
}  // namespace temblor::net
