// How the state of a game gets to its players: five methods, on the same recorded world and the same bad
// network. Michael Abrash ("Quake's 3-D Engine: The Big Picture") reports that Quake first sent everything
// reliably, and why it stopped.
//
//   world     one tick after another: the stock messages of its state             wire/world.cpp
//   network   virtual time, delay, jitter, loss; the same for a seed              wire/network.h
//   nodes     a server and a client, or peers, for each method                    wire/methods.h
//   record    when each tick's state was shown, and each input was played         wire/record.h
//
// Every byte that a client shows was decoded from packets, and is compared with the recorded world. The
// encoders are the engine's (net/transport, net/delta). Nothing waits, and no clock is read.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "net/delta/snapshot_state.h"
#include "net/protocol/protocol.h"

namespace temblor::lab::wire {

// The state that a player was sent in a tick: time, client data, and entity updates. Sounds and other events
// are left out, because all methods would send the same bytes for them.
struct WorldTick {
  float time_s = 0;           // of the server; grows from tick to tick
  base::ByteVector messages;  // stock messages
  net::SnapshotState state;   // the same as words, for deltas
};

struct World {
  net::Dialect dialect{};
  double tick_s = 1.0 / 72;
  std::vector<WorldTick> ticks;
};

// Keeps the state of a stock datagram. kMalformed if it does not begin with a time, or if its state cannot be
// restored from words.
base::Result<WorldTick> keep_state(base::Bytes datagram, const net::Dialect& dialect);

// A world that needs no game: players run and turn, monsters move in steps, missiles fly, and items lie
// still. `players`: at least 1.
World make_built_in_world(double seconds, int players);

// Every `interval`-th tick of a world, as if its server were slower.
World make_slower(const World& world, std::size_t interval);

// One way between two nodes, the same for all.
struct Link {
  double delay_s = 0;
  double jitter_s = 0;  // added to the delay, uniform in [0, jitter_s)
  double loss = 0;      // probability, for each packet
};

enum class Method : std::uint8_t { kReliable, kWindow, kWholeState, kDeltas, kLockstep };

struct MethodInfo {
  Method method;
  std::string_view name, title, summary;
};
std::span<const MethodInfo> list_methods();

// Bytes of the IP and UDP headers, which count in each packet.
constexpr std::size_t kInternetHeaderBytes = 28;

struct Setup {
  Method method = Method::kWholeState;
  Link link{};
  int players = 2;  // peers of lockstep; 2 to kMaxPeers
  std::uint64_t seed = 1;
  // Losses, traffic, and inputs count from here on: by then, both ends know the round trip.
  double warm_s = 2;
  // Loses the first packet after this time that is sent to the viewer and is no mere acknowledgment.
  std::optional<double> lose_one_at_s{};
};
constexpr int kMaxPeers = 4;

// The client, or the second peer, decoded this tick's state.
struct Shown {
  double at_s = 0;
  std::size_t tick = 0;
  bool operator==(const Shown&) const = default;
};
// Input of the same player, and the first tick whose state follows it.
struct PlayedInput {
  double at_s = 0;
  std::size_t tick = 0;
  bool operator==(const PlayedInput&) const = default;
};
// Packets that were sent, lost ones included, with kInternetHeaderBytes each.
struct Traffic {
  std::uint64_t bytes = 0, packets = 0;
  bool operator==(const Traffic&) const = default;
};

struct Transcript {
  std::vector<Shown> shown{};  // in the order of time
  std::vector<PlayedInput> inputs{};
  Traffic to_viewer{}, from_viewer{};  // from Setup::warm_s to end_s
  std::uint64_t lost = 0;              // packets
  // Faults, all 0 if the method works: states that differ from the recorded world, packets that cannot be
  // read, and ticks of lockstep played without the inputs that its peers sent.
  std::uint64_t wrong_states = 0, unreadable = 0, wrong_inputs = 0;
  double end_s = 0;  // when the world ends
  bool operator==(const Transcript&) const = default;
};

// Sends the whole world. The same setup gives the same transcript. CHECKs that the world has ticks, and the
// number of players.
Transcript simulate(const World& world, const Setup& setup);

}  // namespace temblor::lab::wire
