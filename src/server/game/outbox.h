// The messages of one tick, before the server decides which client gets which. QuakeC and physics fill it,
// and send_snapshots() (session/stages.h) reads it when the tick ends.
//
//   broadcast     unreliable, to all             reliable      reliable, to all
//   placed        unreliable, to players         reliable_to   reliable, to one player
//                 who can see the place          signon        reliable, to everyone who joins this level
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/bytes.h"
#include "net/protocol/server_message.h"
#include "vm/program.h"

namespace temblor::server {

// Clients of protocol 15 know only entities with numbers below this.
constexpr std::uint32_t kMaxEntitiesOfProtocol15 = 600;

// The destinations of QuakeC's Write functions, with their numbers.
enum class Destination : int { kBroadcast = 0, kOne = 1, kAll = 2, kInit = 3 };

class Outbox {
 public:
  // The limit for each of the buffers. Writing more is an error of QuakeC (see has_room()); whole messages
  // past it are dropped and counted.
  static constexpr std::size_t kMaxBytes = std::size_t{1} << 20;

  // Entities 1 to `client_count` are players.
  Outbox(const net::Dialect& dialect, std::uint32_t client_count);

  const net::Dialect& dialect() const { return dialect_; }
  std::uint32_t client_count() const { return static_cast<std::uint32_t>(players_.size()); }

  // To everyone, unreliable.
  base::ByteWriter& broadcast() { return broadcast_; }
  // To everyone, reliable.
  base::ByteWriter& reliable() { return reliable_; }
  // To one player, reliable. Null: the entity is not a player.
  base::ByteWriter* reliable_to(vm::EntityIndex player);
  // To everyone who joins this level, before the first snapshot.
  base::ByteWriter& signon() { return signon_; }

  static bool has_room(const base::ByteWriter& writer, std::size_t bytes) {
    return writer.size() <= kMaxBytes && bytes <= kMaxBytes - writer.size();
  }

  // Writes a message into one of these. A message that the dialect cannot express is dropped and counted.
  void write(const net::ServerMessage& message, base::ByteWriter& io_writer);
  // Writes an unreliable message to the players whose PVS contains `place`. Without a place, to all.
  void write_at_place(const net::ServerMessage& message, std::optional<math::Vec3> place);
  // Writes a sound to the players within earshot, also behind walls: a door around the corner can be heard.
  void write_sound(const net::Sound& sound);

  struct Placed {
    std::optional<math::Vec3> place{};
    std::optional<float> earshot_units{};  // of a sound, which does not need to be in the PVS
    std::size_t begin = 0, end = 0;        // of placed_bytes()
  };
  const std::vector<Placed>& placed() const { return placed_; }
  base::Bytes placed_bytes() const { return placed_bytes_.view(); }
  // Messages that were dropped since the level started.
  std::size_t dropped() const { return dropped_; }

  // Ends the tick: clears everything except the signon.
  void clear_tick();

 private:
  void write_placed(const net::ServerMessage& message, Placed placed);

  net::Dialect dialect_;
  base::ByteWriter broadcast_, reliable_, signon_, placed_bytes_;
  std::vector<base::ByteWriter> players_;
  std::vector<Placed> placed_;
  std::size_t dropped_ = 0;
};

}  // namespace temblor::server
