// Snapshots parsed into words and restored, compared with the bytes of message_writer.
#include "net/delta/snapshot_state.h"

#include <gtest/gtest.h>

#include <variant>

#include "net/protocol/dialects.h"
#include "net/protocol/random_message.h"
#include "support/effort.h"

namespace temblor::net {
namespace {

class SnapshotWords : public ::testing::TestWithParam<Dialect> {};

// The next random message of this type, as bytes.
template <typename Message>
base::ByteVector make_random_bytes(test::Random& random, const Dialect& dialect) {
  while (true) {
    const ServerMessage message = test::random_message(random, dialect);
    if (std::holds_alternative<Message>(message)) return test::written(message, dialect);
  }
}

TEST_P(SnapshotWords, RoundTrip) {
  const Dialect dialect = GetParam();
  SnapshotWriter update_writer;
  for (std::uint64_t seed = 0; seed < test::effort(300, 50); ++seed) {
    test::Random random(seed);
    const base::ByteVector time = test::written(Time{static_cast<float>(random.uniform(0, 1e5))}, dialect);
    const base::ByteVector damage = make_random_bytes<Damage>(random, dialect);
    const base::ByteVector client_data = make_random_bytes<ClientData>(random, dialect);
    const base::ByteVector events = make_random_bytes<TempEntity>(random, dialect);
    std::string line;
    write_acknowledgment(
        MoveAcknowledgment{.number = static_cast<std::uint32_t>(seed), .origin = random.in_cube(4096)}, line);
    const base::ByteVector moves = test::written(StuffText{line}, dialect);
    const auto maybe = [&](const base::ByteVector& bytes) {
      return random.chance(0.8) ? base::Bytes(bytes) : base::Bytes{};
    };
    const SnapshotParts parts{.time = maybe(time),
                              .once = maybe(damage),
                              .client_data = maybe(client_data),
                              .acknowledgment = maybe(moves),
                              .events = maybe(events)};
    SnapshotState state;
    ASSERT_TRUE(parse_snapshot(parts, dialect, state)) << "seed " << seed;
    base::ByteWriter whole, again;
    for (const base::Bytes part : {parts.time, parts.once, parts.client_data, parts.acknowledgment})
      whole.bytes(part);
    for (std::size_t i = random.below(10); i > 0; --i) {
      const base::ByteVector update = make_random_bytes<EntityUpdate>(random, dialect);
      ASSERT_TRUE(parse_entity_update(update, dialect, state.entities.emplace_back())) << "seed " << seed;
      whole.bytes(update);
    }
    whole.bytes(parts.events);
    update_writer.write(state, dialect, again);
    ASSERT_EQ(again.view(), whole.view()) << "seed " << seed;
  }
}

TEST_P(SnapshotWords, RejectOtherMessages) {
  const Dialect dialect = GetParam();
  test::Random random(1);
  const base::ByteVector time = test::written(Time{1}, dialect), nop = test::written(Nop{}, dialect);
  const base::ByteVector client_data = make_random_bytes<ClientData>(random, dialect);
  const base::ByteVector print = test::written(StuffText{"//a\n"}, dialect);
  const base::ByteVector much(SnapshotState::kMaxPlainBytes + 1);
  for (const SnapshotParts& parts :
       {SnapshotParts{.time = nop}, SnapshotParts{.time = base::Bytes(time).first(4)},
        SnapshotParts{.client_data = nop},
        SnapshotParts{.client_data = base::Bytes(client_data).first(client_data.size() - 1)},
        SnapshotParts{.acknowledgment = nop}, SnapshotParts{.acknowledgment = print},
        SnapshotParts{.once = much}, SnapshotParts{.events = much}}) {
    SnapshotState state;
    EXPECT_FALSE(parse_snapshot(parts, dialect, state));
  }
  SnapshotState::Entity entity;
  EXPECT_FALSE(parse_entity_update(base::Bytes{}, dialect, entity));
  EXPECT_FALSE(parse_entity_update(nop, dialect, entity));
  const base::ByteVector update = make_random_bytes<EntityUpdate>(random, dialect);
  EXPECT_FALSE(parse_entity_update(base::Bytes(update).first(update.size() - 1), dialect, entity));
}

INSTANTIATE_TEST_SUITE_P(Dialects, SnapshotWords,
                         ::testing::Values(Dialect{Protocol::kNetQuake, 0}, Dialect{Protocol::kFitzQuake, 0},
                                           Dialect{Protocol::kRmq, kShortAngle},
                                           Dialect{Protocol::kRmq, kInt32Coord},
                                           Dialect{Protocol::kRmq, k24BitCoord | kShortAngle},
                                           Dialect{Protocol::kRmq, kFloatCoord | kFloatAngle}),
                         [](const auto& dialect) {
                           return std::to_string(static_cast<int>(dialect.param.protocol)) + "_" +
                                  std::to_string(dialect.param.flags);
                         });

}  // namespace
}  // namespace temblor::net
