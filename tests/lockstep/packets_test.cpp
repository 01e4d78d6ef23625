// Encodings of inputs and packets: what is read is what was written, and damaged bytes do no harm.
#include "lockstep/peers/packets.h"

#include <gtest/gtest.h>

#include "support/effort.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using namespace lockstep;

// In steps of 65536ths of a turn, as they are sent.
float random_angle(Random& io_random) {
  return static_cast<float>(static_cast<int>(io_random.below(65536)) - 32768) * (360.0f / 65536);
}

net::Move random_move(Random& io_random) {
  net::Move move;
  const float pitch_deg = random_angle(io_random);
  const float yaw_deg = random_angle(io_random);
  move.angles_deg = {pitch_deg, yaw_deg, 0};
  move.forward = static_cast<std::int16_t>(io_random.uniform(-500, 500));
  move.up = static_cast<std::int16_t>(io_random.uniform(-32768, 32767));
  move.buttons = static_cast<std::uint8_t>(io_random.below(256));
  move.impulse = static_cast<std::uint8_t>(io_random.below(256));
  return move;
}

StampedInput random_input(Random& io_random, std::uint32_t& io_number) {
  StampedInput stamped{.hash = static_cast<std::uint32_t>(io_random.bits())};
  ClientInput& input = stamped.input;
  const std::size_t moves = io_random.chance(0.8) ? 1 : io_random.below(kMaxMovesInTick + 1);
  net::Move move = random_move(io_random);
  for (std::size_t i = 0; i < moves; ++i) {
    if (io_random.chance(0.3)) move = random_move(io_random);
    input.moves.push_back(move);
  }
  io_number += static_cast<std::uint32_t>(moves) + (io_random.chance(0.1) ? 3u : 0u);
  if (moves > 0) input.last_number = io_number;
  const std::size_t commands = io_random.chance(0.9) ? 0 : io_random.below(4);
  for (std::size_t i = 0; i < commands; ++i) input.commands.emplace_back(io_random.below(100), 'x');
  input.leaves = io_random.chance(0.05);
  return stamped;
}

void expect_equal(const net::Move& a, const net::Move& b) {
  EXPECT_EQ(a.angles_deg, b.angles_deg);
  EXPECT_EQ(a.forward, b.forward);
  EXPECT_EQ(a.side, b.side);
  EXPECT_EQ(a.up, b.up);
  EXPECT_EQ(a.buttons, b.buttons);
  EXPECT_EQ(a.impulse, b.impulse);
}

void expect_equal(const StampedInput& a, const StampedInput& b) {
  EXPECT_EQ(a.hash, b.hash);
  EXPECT_EQ(a.input.last_number, b.input.last_number);
  EXPECT_EQ(a.input.commands, b.input.commands);
  EXPECT_EQ(a.input.leaves, b.input.leaves);
  ASSERT_EQ(a.input.moves.size(), b.input.moves.size());
  for (std::size_t i = 0; i < a.input.moves.size(); ++i) expect_equal(a.input.moves[i], b.input.moves[i]);
}

Ticks random_ticks(Random& io_random, std::size_t players, std::size_t count) {
  Ticks ticks{.next_input = 17, .first_tick = 12};
  std::vector<std::uint32_t> numbers(players);
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<StampedInput>& tick = ticks.ticks.emplace_back();
    for (std::uint32_t& number : numbers) tick.push_back(random_input(io_random, number));
  }
  return ticks;
}

TEST(LockstepPackets, ReadWhatWasWritten) {
  for (int seed = 0; seed < effort(500, 50); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const std::size_t players = 1 + random.below(kMaxPlayers);
    const Ticks ticks = random_ticks(random, players, 1 + random.below(6));
    const base::ByteVector bytes = make_packet(ticks);
    const auto packet = read_packet(bytes, players);
    ASSERT_TRUE(packet.has_value()) << seed;
    const auto& read = std::get<Ticks>(*packet);
    EXPECT_EQ(read.next_input, ticks.next_input);
    EXPECT_EQ(read.first_tick, ticks.first_tick);
    // A packet that would be too large leaves the last ticks out.
    ASSERT_LE(read.ticks.size(), ticks.ticks.size());
    ASSERT_GT(read.ticks.size(), 0u);
    if (bytes.size() < kMaxPacketBytes) {
      EXPECT_EQ(read.ticks.size(), ticks.ticks.size());
    }
    for (std::size_t i = 0; i < read.ticks.size(); ++i)
      for (std::size_t player = 0; player < players; ++player)
        expect_equal(read.ticks[i][player], ticks.ticks[i][player]);
    EXPECT_FALSE(read_packet(bytes, players + 1).has_value() && players < kMaxPlayers) << seed;
  }
}

TEST(LockstepPackets, LongPacketsLeaveTheLastTicksOut) {
  Random random(5);
  const base::ByteVector bytes = make_packet(random_ticks(random, 4, 300));
  EXPECT_LT(bytes.size(), kMaxPacketBytes + 2000);
  EXPECT_GT(std::get<Ticks>(*read_packet(bytes, 4)).ticks.size(), 5u);
}

TEST(LockstepPackets, AStandingPlayerTakesFewBytes) {
  Inputs inputs{.next_tick = 1, .first_tick = 2};
  for (std::uint32_t i = 0; i < 100; ++i)
    inputs.inputs.push_back({.input = {.last_number = 5 + i, .moves = {net::Move{}}}});
  EXPECT_LT(make_packet(inputs).size(), 100u * (4 + 1 + 1) + 30);
}

TEST(LockstepPackets, OthersReadWhatWasWritten) {
  const GameStart start{.program_version = "Temblor 1",
                        .map = "e1m1",
                        .seed = 5,
                        .players = 3,
                        .slots = 5,
                        .delay_ticks = 4,
                        .code_hash = 6,
                        .level_hash = 7,
                        .variables = {{"skill", "2"}, {"hostname", "a b"}}};
  const auto read = std::get<Start>(*read_packet(make_packet(Start{2, start}), 0));
  EXPECT_EQ(read.player, 2);
  EXPECT_EQ(read.start.program_version, start.program_version);
  EXPECT_EQ(read.start.map, start.map);
  EXPECT_EQ(read.start.seed, start.seed);
  EXPECT_EQ(read.start.players, start.players);
  EXPECT_EQ(read.start.slots, start.slots);
  EXPECT_EQ(read.start.delay_ticks, start.delay_ticks);
  EXPECT_EQ(read.start.code_hash, start.code_hash);
  EXPECT_EQ(read.start.level_hash, start.level_hash);
  EXPECT_EQ(read.start.variables, start.variables);
  EXPECT_FALSE(read_packet(make_packet(Start{3, start}), 0).has_value()) << "there are only three players";
  const auto join = std::get<Join>(*read_packet(make_packet(Join{9, "Temblor 1"}), 0));
  EXPECT_EQ(join.id, 9u);
  EXPECT_EQ(join.program_version, "Temblor 1");
  const auto waiting = std::get<Waiting>(*read_packet(make_packet(Waiting{2, 4}), 0));
  EXPECT_EQ(waiting.joined, 2);
  EXPECT_EQ(waiting.players, 4);
  const auto hashes =
      std::get<EntityHashes>(*read_packet(make_packet(EntityHashes{4, 300, 700, {1, 2, 3}}), 0));
  EXPECT_EQ(hashes.tick, 4u);
  EXPECT_EQ(hashes.first, 300u);
  EXPECT_EQ(hashes.count, 700u);
  EXPECT_EQ(hashes.hashes, (std::vector<std::uint32_t>{1, 2, 3}));
  EXPECT_EQ(std::get<Refused>(*read_packet(make_packet(Refused{"no"}), 0)).reason, "no");
  EXPECT_EQ(std::get<Leave>(*read_packet(make_packet(Leave{"bye"}), 0)).reason, "bye");
}

TEST(LockstepPackets, DamagedPacketsAreIgnored) {
  Random random(1);
  const base::ByteVector whole = make_packet(random_ticks(random, 2, 4));
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_FALSE(read_packet(base::Bytes(whole).first(size), 2).has_value()) << size;
  for (int i = 0; i < effort(20000, 2000); ++i) {
    base::ByteVector damaged = whole;
    for (int flips = 0; flips < 3; ++flips) {
      const std::size_t at = random.below(damaged.size());
      damaged[at] ^= static_cast<std::byte>(1 + random.below(255));
    }
    damaged[5] = static_cast<std::byte>(random.below(9));
    const std::size_t players = random.below(5);
    static_cast<void>(read_packet(damaged, players));
  }
}

}  // namespace
}  // namespace temblor::test
