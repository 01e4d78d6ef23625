// The methods of the wire: each rebuilds the recorded world from bytes, in order, whatever the network does,
// and freezes as long as its definition says.
#include "lab/wire.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lab/wire/methods.h"
#include "lab/wire/window.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::test {
namespace {

namespace wire = lab::wire;
using wire::Link;
using wire::Method;
using wire::Setup;
using wire::Transcript;

constexpr double kWireTick_s = 1.0 / 72;

const wire::World& short_world() {
  static const wire::World world = wire::make_built_in_world(6, 3);
  return world;
}

Transcript run_wire(Method method, const Link& link, std::uint64_t seed = 1) {
  return wire::simulate(short_world(), {.method = method, .link = link, .players = 3, .seed = seed});
}

std::vector<std::size_t> list_shown_ticks(const Transcript& transcript) {
  std::vector<std::size_t> ticks;
  for (const wire::Shown& shown : transcript.shown) ticks.push_back(shown.tick);
  return ticks;
}

std::vector<std::size_t> list_all_ticks() {
  std::vector<std::size_t> ticks(short_world().ticks.size());
  for (std::size_t tick = 0; tick < ticks.size(); ++tick) ticks[tick] = tick;
  return ticks;
}

bool is_strictly_rising(const std::vector<std::size_t>& ticks) {
  return std::ranges::adjacent_find(ticks, std::greater_equal<>()) == ticks.end();
}

// The longest time without a newer state.
double find_longest_gap(const Transcript& transcript, double from_s) {
  double longest_s = 0;
  for (std::size_t i = 1; i < transcript.shown.size(); ++i)
    if (transcript.shown[i].at_s >= from_s && transcript.shown[i].at_s < transcript.end_s)
      longest_s = std::max(longest_s, transcript.shown[i].at_s - transcript.shown[i - 1].at_s);
  return longest_s;
}

// By definition, nothing is faster than the way there.
void expect_possible(const Transcript& transcript, double delay_s, double tick_s) {
  for (const wire::Shown& shown : transcript.shown)
    ASSERT_GE(shown.at_s - static_cast<double>(shown.tick) * tick_s, delay_s - 1e-9) << shown.tick;
}

TEST(Wire, TheBuiltInWorldMoves) {
  const wire::World& world = short_world();
  ASSERT_EQ(world.ticks.size(), 6u * 72);
  for (std::size_t tick = 1; tick < world.ticks.size(); ++tick) {
    EXPECT_GT(world.ticks[tick].time_s, world.ticks[tick - 1].time_s);
    EXPECT_NE(world.ticks[tick].messages, world.ticks[tick - 1].messages);
    EXPECT_LE(world.ticks[tick].messages.size(), 1024u) << "else a stock client could not read it";
    const auto& entities = world.ticks[tick].state.entities;
    EXPECT_EQ(entities.size(), 3u + 12 + 4 + 16);
    EXPECT_EQ(std::ranges::count_if(entities, net::SnapshotState::is_stepping), 12);
  }
  const wire::World slower = wire::make_slower(world, 4);
  EXPECT_EQ(slower.ticks.size(), 108u);
  EXPECT_EQ(slower.ticks[3].messages, world.ticks[12].messages);
  EXPECT_NEAR(slower.tick_s, 4 * kWireTick_s, 1e-12);
}

TEST(Wire, AStateIsKeptWithoutEvents) {
  const wire::WorldTick& tick = short_world().ticks[10];
  base::ByteVector datagram = tick.messages;
  for (const int byte : {27, 3}) datagram.push_back(static_cast<std::byte>(byte));  // svc_killedmonster, bad
  EXPECT_FALSE(wire::keep_state(datagram, short_world().dialect).ok());
  datagram.pop_back();
  const auto kept = wire::keep_state(datagram, short_world().dialect);
  ASSERT_TRUE(kept.ok()) << kept.error().message();
  EXPECT_EQ(kept->messages, tick.messages);
  EXPECT_EQ(kept->time_s, tick.time_s);
  EXPECT_FALSE(wire::keep_state({}, short_world().dialect).ok());
}

TEST(Wire, TheSameSeedGivesTheSameTranscript) {
  const Link link{.delay_s = 0.07, .jitter_s = 0.004, .loss = 0.05};
  for (const wire::MethodInfo& info : wire::list_methods()) {
    const Transcript first = run_wire(info.method, link, 7);
    EXPECT_EQ(first, run_wire(info.method, link, 7)) << info.name;
    EXPECT_NE(first, run_wire(info.method, link, 8)) << info.name;
    EXPECT_GT(first.lost, 5u) << info.name;
  }
}

TEST(Wire, WithoutLossEveryMethodShowsEveryStateInOrder) {
  for (const wire::MethodInfo& info : wire::list_methods())
    for (const double delay_s : {0.0, 0.05, 0.15}) {
      // A message at a time needs a round trip within a tick to show every state.
      if (info.method == Method::kReliable && delay_s > 0) continue;
      const Transcript transcript = run_wire(info.method, {.delay_s = delay_s});
      EXPECT_EQ(list_shown_ticks(transcript), list_all_ticks()) << info.name << ", " << delay_s;
      EXPECT_EQ(transcript.wrong_states + transcript.unreadable + transcript.wrong_inputs, 0u) << info.name;
      EXPECT_EQ(transcript.lost, 0u);
      expect_possible(transcript, info.method == Method::kLockstep ? 0 : delay_s, kWireTick_s);
    }
}

// The moment at which each state would arrive without loss bounds the rest.
TEST(Wire, OneMessageInFlightShowsAStateForEachRoundTrip) {
  const Transcript transcript = run_wire(Method::kReliable, {.delay_s = 0.1});
  // 200 ms are 14.4 ticks, so a message leaves at each 15th.
  EXPECT_NEAR(find_longest_gap(transcript, 3), 15 * kWireTick_s, 1e-9);
  EXPECT_TRUE(is_strictly_rising(list_shown_ticks(transcript)));
}

// Each method, on random links, from perfect to worse than any that people play on.
TEST(Wire, AnyLinkShowsRecordedStatesInOrder) {
  for (int seed = 0; seed < effort(40, 4); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    Link link;
    link.delay_s = random.uniform(0, 0.25);
    link.jitter_s = random.chance(0.5) ? random.uniform(0, 0.06) : 0;
    link.loss = random.uniform(0, 0.3);
    for (const wire::MethodInfo& info : wire::list_methods()) {
      const Transcript transcript = run_wire(info.method, link, static_cast<std::uint64_t>(seed));
      const std::vector<std::size_t> ticks = list_shown_ticks(transcript);
      const auto where = [&] { return std::string(info.name) + ", seed " + std::to_string(seed); };
      EXPECT_EQ(transcript.wrong_states, 0u) << where();
      EXPECT_EQ(transcript.unreadable, 0u) << where();
      EXPECT_EQ(transcript.wrong_inputs, 0u) << where();
      ASSERT_TRUE(is_strictly_rising(ticks)) << where();
      if (info.method == Method::kWindow || info.method == Method::kLockstep) {
        EXPECT_EQ(ticks, list_all_ticks()) << where();
      }
      EXPECT_GT(ticks.size(), info.method == Method::kReliable ? 5u : 200u) << where();
      if (info.method != Method::kReliable) {
        EXPECT_GE(transcript.shown.back().tick, 426u) << where() << ": it ended early";
      }
      expect_possible(transcript, info.method == Method::kLockstep ? 0 : link.delay_s, kWireTick_s);
    }
  }
}

// Loses the first state after 3.5 s on a link without jitter.
Transcript lose_one(Method method, double delay_s) {
  return wire::simulate(short_world(),
                        {.method = method, .link = {.delay_s = delay_s}, .players = 3, .lose_one_at_s = 3.5});
}

TEST(Wire, ALostStateFreezesAsItsMethodImplies) {
  for (const double delay_s : {0.02, 0.05, 0.1, 0.15}) {
    const auto gap_s = [&](Method method) {
      const Transcript transcript = lose_one(method, delay_s);
      EXPECT_EQ(transcript.lost, 1u);
      return find_longest_gap(transcript, 3);
    };
    const double round_trip_s = 2 * delay_s;
    EXPECT_NEAR(gap_s(Method::kWholeState), 2 * kWireTick_s, 1e-9) << "one tick is missed";
    EXPECT_NEAR(gap_s(Method::kDeltas), 2 * kWireTick_s, 1e-9);
    // The timeout: once the round trip has been steady, little more than that, and at least 0.1 s. Then both
    // the message before it and the resent one took a round trip, or the rest of a tick more.
    const double timeout_s = std::max(0.1, round_trip_s);
    EXPECT_GT(gap_s(Method::kReliable), timeout_s + round_trip_s - kWireTick_s);
    EXPECT_LT(gap_s(Method::kReliable), timeout_s + round_trip_s + 4 * kWireTick_s);
    // Three later ones must arrive, and their acknowledgment return, or the timeout passes.
    EXPECT_GT(gap_s(Method::kWindow), round_trip_s);
    EXPECT_LT(gap_s(Method::kWindow), round_trip_s + 5 * kWireTick_s);
    EXPECT_NEAR(gap_s(Method::kLockstep), kWireTick_s, 1e-9) << "the next packet repeats the input in time";
  }
}

TEST(Wire, LockstepWaitsForAllInputs) {
  for (const double delay_s : {0.0, 0.05, 0.13}) {
    const Link link{.delay_s = delay_s, .jitter_s = 0.003};
    const std::size_t delay_ticks = wire::find_input_delay(link, kWireTick_s);
    EXPECT_GE(static_cast<double>(delay_ticks - 1) * kWireTick_s, delay_s);
    for (const double loss : {0.0, 0.3}) {
      Link lossy = link;
      lossy.loss = loss;
      const Transcript transcript = run_wire(Method::kLockstep, lossy, 3);
      for (const wire::Shown& shown : transcript.shown) {
        const auto tick = static_cast<double>(shown.tick);
        ASSERT_GE(shown.at_s, tick * kWireTick_s - 1e-9);
        // The input of this tick was given `delay_ticks` earlier.
        ASSERT_GE(shown.at_s, (tick - static_cast<double>(delay_ticks)) * kWireTick_s + delay_s - 1e-9);
      }
      EXPECT_EQ(transcript.wrong_inputs, 0u);
      if (loss > 0) {
        EXPECT_GT(find_longest_gap(transcript, 2), kWireTick_s * 1.5) << "it never waited";
      } else
        for (const wire::Shown& shown : transcript.shown)
          ASSERT_NEAR(shown.at_s, static_cast<double>(shown.tick) * kWireTick_s, 1e-9)
              << "all in the same tick";
    }
  }
}

TEST(Wire, InputsNeedARoundTripOrTheInputDelay) {
  const Link link{.delay_s = 0.1};
  for (const wire::MethodInfo& info : wire::list_methods()) {
    const Transcript transcript = run_wire(info.method, link);
    ASSERT_GT(transcript.inputs.size(), 200u) << info.name;
    for (const wire::PlayedInput& input : transcript.inputs) {
      const double played_s = static_cast<double>(input.tick) * kWireTick_s;
      ASSERT_GE(played_s, input.at_s + (info.method == Method::kLockstep ? 0 : link.delay_s)) << info.name;
      if (info.method != Method::kReliable) {
        ASSERT_LE(played_s, input.at_s + link.delay_s + 4 * kWireTick_s) << info.name;
      }
    }
  }
}

TEST(Wire, TrafficIsThatOfRealPackets) {
  const auto rate = [](const wire::Traffic& traffic) {
    return static_cast<double>(traffic.bytes) / static_cast<double>(traffic.packets);
  };
  const Link link{.delay_s = 0.05};
  double state_bytes = 0;
  for (const wire::WorldTick& tick : short_world().ticks)
    state_bytes += static_cast<double>(tick.messages.size());
  state_bytes /= static_cast<double>(short_world().ticks.size());
  const Transcript whole = run_wire(Method::kWholeState, link), deltas = run_wire(Method::kDeltas, link);
  EXPECT_EQ(whole.to_viewer.packets, 4u * 72);
  EXPECT_NEAR(rate(whole.to_viewer), 28 + 8 + state_bytes, 5);
  EXPECT_EQ(rate(whole.from_viewer), 28 + 8 + 16) << "a stock move";
  EXPECT_LT(deltas.to_viewer.bytes, whole.to_viewer.bytes / 2);
  EXPECT_GT(rate(deltas.to_viewer), 28 + 8 + 4);
  EXPECT_GT(rate(deltas.from_viewer), 28 + 8 + 4 * 16);
  // With no delay, a message leaves in each tick, a little larger than a delta's, and its acknowledgment.
  const Transcript reliable = run_wire(Method::kReliable, {}), near_deltas = run_wire(Method::kDeltas, {});
  EXPECT_EQ(reliable.to_viewer.packets, 2 * 4u * 72);
  EXPECT_NEAR(static_cast<double>(reliable.to_viewer.bytes),
              static_cast<double>(near_deltas.to_viewer.bytes) + 4 * 72 * 36, 1000);
  // A window sends the same deltas with 12 more bytes, and no acknowledgments of their own.
  const Transcript window = run_wire(Method::kWindow, link);
  EXPECT_EQ(window.to_viewer.packets, 4u * 72);
  EXPECT_NEAR(static_cast<double>(window.to_viewer.bytes),
              static_cast<double>(near_deltas.to_viewer.bytes) + 4 * 72 * 12, 1000);
  const Transcript two =
      wire::simulate(short_world(), {.method = Method::kLockstep, .link = link, .players = 2});
  const Transcript four =
      wire::simulate(short_world(), {.method = Method::kLockstep, .link = link, .players = 4});
  EXPECT_EQ(four.to_viewer.bytes, 3 * two.to_viewer.bytes);
  EXPECT_EQ(two.to_viewer.packets, 4u * 72);
  EXPECT_EQ(rate(two.to_viewer), 28 + 8 + 12 + 5 + 4 * 16);
}

// All other tests rely on it.
TEST(Wire, ARecordNoticesWrongStates) {
  const base::ByteVector& right = short_world().ticks[20].messages;
  for (std::size_t byte = 0; byte < right.size(); ++byte) {
    base::ByteVector wrong = right;
    wrong[byte] ^= std::byte{1};
    wire::Record record(short_world());
    record.show(wrong, 1);
    const Transcript transcript = std::move(record).finish({}, 0, 1);
    EXPECT_EQ(transcript.wrong_states, 1u) << byte;
    EXPECT_TRUE(transcript.shown.empty());
  }
  wire::Record record(short_world());
  record.show(right, 1);
  record.show(base::Bytes(right).first(3), 1);
  const Transcript transcript = std::move(record).finish({}, 0, 1);
  EXPECT_EQ(transcript.shown, (std::vector<wire::Shown>{{1, 20}}));
  EXPECT_EQ(transcript.wrong_states, 1u);
}

// One end of a window, and what it has sent and received.
struct WindowEnd {
  wire::Window window;
  std::vector<base::ByteVector> packets;
  std::string read;

  auto sink() {
    return [this](base::Bytes packet) { packets.emplace_back(packet.begin(), packet.end()); };
  }
  void send(char letter, double now_s) {
    window.send(base::as_bytes(std::string_view(&letter, 1)), now_s, sink());
  }
  void resend(double now_s) { window.resend(now_s, sink()); }
  void acknowledge() { window.acknowledge(sink()); }
  void receive(const base::ByteVector& packet, double now_s) {
    EXPECT_TRUE(
        window.receive(packet, now_s, [this](base::Bytes message) { read += base::as_text(message); }).ok());
  }
  // The last packet that this end has sent.
  const base::ByteVector& last() const { return packets.back(); }
};

TEST(WireWindow, DeliversInOrderAndOnce) {
  WindowEnd here, there;
  for (const char letter : std::string("abcd")) here.send(letter, 0);
  for (const std::size_t packet : {1, 3, 0, 1, 2, 2, 0}) there.receive(here.packets[packet], 0.1);
  EXPECT_EQ(there.read, "abcd");
}

TEST(WireWindow, ResendsWhatThreeLaterOnesHaveOvertaken) {
  WindowEnd here, there;
  for (const char letter : std::string("abcd")) here.send(letter, 0);
  for (const std::size_t packet : {1, 2}) there.receive(here.packets[packet], 0.1);
  there.acknowledge();
  here.receive(there.last(), 0.11);
  here.resend(0.11);
  EXPECT_EQ(here.packets.size(), 4u) << "two may just have taken another way";
  there.receive(here.packets[3], 0.12);
  there.acknowledge();
  here.receive(there.last(), 0.13);
  here.resend(0.13);
  ASSERT_EQ(here.packets.size(), 5u);
  here.resend(0.14);
  EXPECT_EQ(here.packets.size(), 5u) << "not again at once";
  there.receive(here.last(), 0.15);
  EXPECT_EQ(there.read, "abcd");
}

// Karn's rule: the answer to a resent message does not say which one it answers.
TEST(WireWindow, WaitsForTheRoundTripOfMessagesSentOnce) {
  WindowEnd here, there;
  here.send('a', 0);
  here.resend(0.99);
  EXPECT_EQ(here.packets.size(), 1u);
  here.resend(1.01);
  EXPECT_EQ(here.packets.size(), 2u) << "a second, as long as the round trip is unknown";
  const auto answer = [&](double now_s) {
    there.receive(here.last(), now_s);
    there.acknowledge();
    here.receive(there.last(), now_s);
  };
  answer(1.02);  // perhaps to the first one
  here.send('b', 2);
  answer(2.05);
  here.send('c', 3);  // is lost
  here.resend(3.14);
  EXPECT_EQ(here.packets.size(), 4u);
  here.resend(3.16);
  EXPECT_EQ(here.packets.size(), 5u) << "a round trip of 0.05 s, and four deviations of half of it";
  EXPECT_EQ(there.read, "ab");
}

TEST(WireWindow, RejectsForeignPackets) {
  WindowEnd end;
  end.send('a', 0);
  const auto ignore = [](base::Bytes) { ADD_FAILURE(); };
  for (std::size_t size = 0; size < end.last().size() - 1; ++size)
    EXPECT_FALSE(end.window.receive(base::Bytes(end.last()).first(size), 0, ignore).ok()) << size;
}

}  // namespace
}  // namespace temblor::test
