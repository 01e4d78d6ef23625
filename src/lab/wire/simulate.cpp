#include <array>
#include <cmath>

#include "base/check.h"
#include "lab/wire.h"
#include "lab/wire/methods.h"
#include "lab/wire/network.h"

namespace temblor::lab::wire {
namespace {

// After the world has ended, lost packets are resent for this time.
constexpr double kDrain_s = 8;

constexpr std::array kMethods{
    MethodInfo{Method::kReliable, "reliable", "Everything reliable, one message in flight",
               "Deltas from the state that was sent last. A lost one stops everything until it is resent."},
    MethodInfo{Method::kWindow, "window", "Everything reliable, resends in flight",
               "One delta per tick, resent if it is lost, and read in order, as with TCP."},
    MethodInfo{Method::kWholeState, "whole-state", "Whole states, unreliable",
               "Stock NetQuake: everything that differs from its first state, in each tick."},
    MethodInfo{Method::kDeltas, "acknowledged-deltas", "Deltas from acknowledged states, unreliable",
               "Temblor's own clients: each packet needs only a state that the client has."},
    MethodInfo{Method::kLockstep, "lockstep", "Lockstep",
               "Peers send only inputs. Each computes the world when it has all inputs of a tick."}};

Nodes make_nodes(const Parts& parts) {
  switch (parts.setup.method) {
    case Method::kReliable:
      return make_reliable_nodes(parts);
    case Method::kWindow:
      return make_window_nodes(parts);
    case Method::kWholeState:
      return make_whole_state_nodes(parts);
    case Method::kDeltas:
      return make_delta_nodes(parts);
    case Method::kLockstep:
      break;
  }
  return make_lockstep_nodes(parts);
}

// Input comes at any time within the tick before the step that sends it.
std::vector<double> choose_input_times(std::size_t steps, double tick_s, double phase_s, std::uint64_t seed) {
  RandomNumbers random(seed + 1);
  std::vector<double> times_s;
  for (std::size_t step = 0; step < steps; ++step)
    times_s.push_back((static_cast<double>(step) - random.fraction()) * tick_s + phase_s);
  return times_s;
}

}  // namespace

std::span<const MethodInfo> list_methods() {
  return kMethods;
}

net::Move make_move(std::size_t input, float time_s) {
  return {.time_s = time_s,
          .forward = static_cast<std::int16_t>(input & 0x7fff),
          .side = static_cast<std::int16_t>(input >> 15)};
}

std::size_t find_input(const net::Move& move) {
  return static_cast<std::size_t>(move.side) << 15 | static_cast<std::size_t>(move.forward);
}

Transcript simulate(const World& world, const Setup& setup) {
  CHECK(!world.ticks.empty());
  CHECK(setup.players >= 2 && setup.players <= kMaxPeers);
  const double tick_s = world.tick_s, end_s = static_cast<double>(world.ticks.size()) * tick_s;
  const std::size_t steps = world.ticks.size() + static_cast<std::size_t>(std::ceil(kDrain_s / tick_s));
  // Peers in lockstep count the same ticks. A client's clock has nothing to do with the server's.
  const double client_phase_s =
      setup.method == Method::kLockstep ? 0 : RandomNumbers(setup.seed + 2).fraction() * tick_s;
  Record record(world);
  const Nodes nodes = make_nodes({world, setup, record});
  Network network(setup, kViewer, end_s);
  const auto find_step_time = [&](std::size_t node, std::size_t number) {
    return static_cast<double>(number) * tick_s + (node == kViewer ? client_phase_s : 0);
  };
  for (std::size_t node = 0; node < nodes.size(); ++node) network.add_step(node, 0, find_step_time(node, 0));
  while (!network.is_empty()) {
    const Event event = network.take_next();
    const auto send = [&](std::size_t to, base::Bytes packet) {
      network.send(event.node, to, packet, event.at_s);
    };
    if (event.kind == Event::Kind::kArrival) {
      nodes[event.node]->receive(event.from, event.packet, event.at_s, send);
      continue;
    }
    nodes[event.node]->step(event.number, event.at_s, send);
    if (event.number + 1 < steps)
      network.add_step(event.node, event.number + 1, find_step_time(event.node, event.number + 1));
  }
  Transcript transcript = std::move(record).finish(
      choose_input_times(steps, tick_s, client_phase_s, setup.seed), setup.warm_s, end_s);
  network.report(transcript);
  return transcript;
}

}  // namespace temblor::lab::wire
