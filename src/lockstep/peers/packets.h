// The datagrams between the host of a lockstep game and its guests. All inputs go through the host:
//
//   guest                                host
//     | Join ---------------------------> |   every half second
//     | <------------ Waiting or Refused  |
//     | <------------------------- Start  |   once all are there; until the first Inputs
//     | Inputs -------------------------> |   every tick: all that the host has not acknowledged
//     | <------------------------- Ticks  |   every tick: everybody's, all that the guest has not
//     acknowledged | <-------- EntityHashes ---------> |   after the games have become different |
//     <----------------- Leave -------> |
//
// Packets repeat what has not been acknowledged, so one that is lost delays the game by one packet. Each
// begins with four bytes, "TmLk", a version, and its kind. Everything is little endian.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/bytes.h"
#include "lockstep/game_start.h"
#include "lockstep/peers/client_input.h"

namespace temblor::lockstep {

// A player's input of one tick, and the hash of its game `delay_ticks` before: when the input was made.
struct StampedInput {
  ClientInput input{};
  std::uint32_t hash = 0;
};

// A guest's request to join. `id` tells guests apart that share an address.
struct Join {
  std::uint64_t id = 0;
  std::string program_version{};
};
struct Waiting {
  std::uint8_t joined = 0, players = 0;
};
struct Refused {
  std::string reason{};
};
struct Start {
  std::uint8_t player = 0;  // the guest's number; 0 is the host
  GameStart start{};
};
// The inputs of one guest.
struct Inputs {
  std::uint32_t next_tick = 0;   // the first tick that the guest has not received
  std::uint32_t first_tick = 0;  // of the inputs that follow
  std::vector<StampedInput> inputs{};
};
// The inputs of all players.
struct Ticks {
  std::uint32_t next_input = 0;  // the first tick for which the host has no input of the guest
  std::uint32_t first_tick = 0;
  std::vector<std::vector<StampedInput>> ticks{};  // by tick, then by player
};
// The hashes of a game's entities after a tick, from number `first` on.
struct EntityHashes {
  std::uint32_t tick = 0, first = 0, count = 0;  // count: of all entities
  std::vector<std::uint32_t> hashes{};
};
struct Leave {
  std::string reason{};
};

using Packet = std::variant<Join, Waiting, Refused, Start, Inputs, Ticks, EntityHashes, Leave>;

// Inputs and Ticks stop before this size; the rest follows when the first part has been acknowledged.
constexpr std::size_t kMaxPacketBytes = 1300;
// Entity hashes in one packet.
constexpr std::size_t kMaxHashesInPacket = 300;

// If the inputs do not fit, those of the last ticks are left out.
base::ByteVector make_packet(const Packet& packet);
// Nothing for other packets, and for damaged ones. `players`: of the game, for Ticks.
std::optional<Packet> read_packet(base::Bytes bytes, std::size_t players);

}  // namespace temblor::lockstep
