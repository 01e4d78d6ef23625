// Moves that arrive late, twice, never, or too many at a time: each number is played once and in order.
#include "server/session/move_queue.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/random.h"

namespace temblor::server {
namespace {

// The move with this number. The yaw of its view angles tells moves apart.
PlayerInput move(std::uint32_t number, std::uint8_t impulse = 0) {
  return {.command = {.view_angles_deg = {0, static_cast<float>(number), 0}}, .impulse = impulse};
}
std::uint32_t move_number(const PlayerInput& input) {
  return static_cast<std::uint32_t>(input.command.view_angles_deg.y);
}
void add(MoveQueue& io_queue, std::uint32_t first, std::uint32_t last) {
  std::vector<PlayerInput> moves;
  for (std::uint32_t number = first; number <= last; ++number) moves.push_back(move(number));
  io_queue.add(last, moves);
}

TEST(MoveQueue, OneATick) {
  MoveQueue queue;
  for (std::uint32_t number = 10; number < 100; ++number) {
    add(queue, number - 2, number);
    const auto turn = queue.take_due();
    // The first packet brings two more, which stay as a reserve until they prove to be too many.
    ASSERT_GE(turn.size(), 1u);
    EXPECT_EQ(move_number(turn.back()), queue.last_played());
  }
  EXPECT_EQ(queue.last_played(), 99u);
}

TEST(MoveQueue, EachOnceAndInOrderOverABadNetwork) {
  test::Random random(7);
  for (int round = 0; round < 20; ++round) {
    MoveQueue queue;
    std::vector<std::uint32_t> played;
    std::uint32_t sent = 3, arrived = 3;
    int lost_in_a_row = 0;
    add(queue, 1, arrived);  // before the first packet with numbers, the queue plays the held move
    for (int tick = 0; tick < 2000; ++tick) {
      ++sent;
      // Packets come in bursts; no more than two in a row are lost.
      while (arrived < sent && (sent - arrived > 10 || random.chance(0.5))) {
        ++arrived;
        const bool is_lost = lost_in_a_row < 2 && random.chance(0.1);
        lost_in_a_row = is_lost ? lost_in_a_row + 1 : 0;
        if (!is_lost) add(queue, arrived - 2, arrived);
        if (!is_lost && random.chance(0.05)) add(queue, arrived - 2, arrived);  // twice
      }
      for (const PlayerInput& input : queue.take_due()) played.push_back(move_number(input));
    }
    for (std::size_t i = 1; i < played.size(); ++i)
      ASSERT_EQ(played[i], played[i - 1] + 1) << "at " << i << ", round " << round;
    EXPECT_GE(played.back() + 40, sent);
  }
}

TEST(MoveQueue, WithoutMovesThePlayerWaitsThenRepeatsTheLast) {
  MoveQueue queue;
  const std::vector<PlayerInput> last = {move(5, 9)};
  queue.add(5, last);
  ASSERT_EQ(queue.take_due().size(), 1u);
  for (int tick = 0; tick < MoveQueue::kMaxHeldTicks; ++tick) EXPECT_TRUE(queue.take_due().empty());
  for (int tick = 0; tick < 100; ++tick) {
    const auto turn = queue.take_due();
    ASSERT_EQ(turn.size(), 1u);
    EXPECT_EQ(move_number(turn[0]), 5u);
    EXPECT_EQ(turn[0].impulse, 0) << "an impulse is played once";
    EXPECT_EQ(queue.last_played(), 5u);
  }
}

TEST(MoveQueue, SendingMoreMovesThanTicksGainsNothing) {
  MoveQueue queue;
  std::size_t played = 0;
  std::uint32_t number = 8;
  constexpr int kTicks = 5000;
  for (int tick = 0; tick < kTicks; ++tick, number += 8) {
    add(queue, number - 7, number);
    played += queue.take_due().size();
  }
  EXPECT_LE(static_cast<double>(played), kTicks * 1.01 + 21);
}

TEST(MoveQueue, ImpulsesSurviveAFullQueue) {
  MoveQueue queue;
  const std::vector<PlayerInput> first = {move(1, 7)};
  queue.add(1, first);
  for (std::uint32_t number = 2; number < 200; ++number) add(queue, number, number);
  int impulses = 0;
  for (int tick = 0; tick < 300; ++tick)
    for (const PlayerInput& input : queue.take_due()) impulses += input.impulse == 7;
  EXPECT_EQ(impulses, 1);
  EXPECT_EQ(queue.last_played(), 199u);
}

TEST(MoveQueue, LostOnesAreReplacedByTheOneBefore) {
  MoveQueue queue;
  add(queue, 1, 1);
  add(queue, 4, 5);
  std::vector<std::uint32_t> played;
  for (int tick = 0; tick < 5; ++tick)
    for (const PlayerInput& input : queue.take_due()) played.push_back(move_number(input));
  EXPECT_EQ(played, (std::vector<std::uint32_t>{1, 1, 1, 4, 5}));
}

TEST(MoveQueue, HostileNumbersAreHarmless) {
  test::Random random(9);
  MoveQueue queue;
  for (int i = 0; i < 20000; ++i) {
    const auto number = static_cast<std::uint32_t>(random.bits() >> random.below(64));
    const std::vector<PlayerInput> moves(random.below(9), move(0));
    queue.add(number, moves);
    EXPECT_LE(queue.take_due().size(), 4u);
  }
}

TEST(MoveQueue, MovesOfAPausedGameAreSkipped) {
  MoveQueue queue;
  add(queue, 1, 3);
  queue.skip();
  EXPECT_EQ(queue.last_played(), 3u);
  EXPECT_TRUE(queue.take_due().empty());
}

// A client that alternates numbered and other moves, so that the numbering keeps restarting, plays no more
// moves.
TEST(MoveQueue, RestartingTheNumbersGainsNothing) {
  MoveQueue queue;
  std::uint32_t number = 1;
  std::size_t played = 0;
  constexpr int kTicks = 720;
  for (int tick = 0; tick < kTicks; ++tick) {
    queue.add(std::nullopt, std::vector<PlayerInput>(1));
    const std::vector<PlayerInput> moves(16);
    queue.add(number + 15, moves);
    number += 16;
    played += queue.take_due().size();
  }
  EXPECT_LE(played, kTicks * 1.01 + 5);
}

// The time of a client that sends a move only now and then does not run at a fraction of its speed.
TEST(MoveQueue, ASilentClientIsNotHeldForLong) {
  MoveQueue queue;
  std::uint32_t number = 1;
  std::size_t played = 0;
  constexpr int kTicks = 720;
  for (int tick = 0; tick < kTicks; ++tick) {
    if (tick % 19 == 0) queue.add(number++, std::vector<PlayerInput>(1));
    played += queue.take_due().size();
  }
  EXPECT_GT(played, kTicks * 9 / 10);
}

}  // namespace
}  // namespace temblor::server
