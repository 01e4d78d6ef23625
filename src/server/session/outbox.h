// What one tick has to tell clients, before it is known who is told what: filled by QuakeC and physics, read
// when the tick ends.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/bytes.h"
#include "net/protocol/server_message.h"
#include "vm/program.h"

namespace temblor::server {

// As many entities as a client of protocol 15 knows: numbers below this.
constexpr std::uint32_t kMaxEntitiesOfProtocol15 = 600;

// Where QuakeC's Write functions write, by their numbers.
enum class Destination : int { kBroadcast = 0, kOne = 1, kAll = 2, kInit = 3 };

class Outbox {
 public:
  // Bytes that a tick, or the signon of a level, may have for each of its readers. What a program writes past
  // it is an error of the program's (has_room); whole messages past it are dropped and counted.
  static constexpr std::size_t kMaxBytes = std::size_t{1} << 20;

  // Entities 1 to `client_count` are players.
  Outbox(const net::Dialect& dialect, std::uint32_t client_count);

  const net::Dialect& dialect() const { return dialect_; }
  std::uint32_t client_count() const { return static_cast<std::uint32_t>(players_.size()); }

  // To everyone, now or never.
  base::ByteWriter& broadcast() { return broadcast_; }
  // To everyone, certainly.
  base::ByteWriter& reliable() { return reliable_; }
  // To one player, certainly; null where that entity is no player's.
  base::ByteWriter* reliable_to(vm::EntityIndex player);
  // To everyone who joins this level, before its first update.
  base::ByteWriter& signon() { return signon_; }

  static bool has_room(const base::ByteWriter& writer, std::size_t bytes) {
    return writer.size() <= kMaxBytes && bytes <= kMaxBytes - writer.size();
  }

  // Into one of the above, in the dialect. What it has no words for is dropped, and counted.
  void write(const net::ServerMessage& message, base::ByteWriter& io_writer);
  // Now or never, to those whose PVS holds the place (to all where it is nothing).
  void at_place(const net::ServerMessage& message, std::optional<math::Vec3> place);

  struct Placed {
    std::optional<math::Vec3> place;
    std::size_t begin = 0, end = 0;  // of placed_bytes()
  };
  const std::vector<Placed>& placed() const { return placed_; }
  base::Bytes placed_bytes() const { return placed_bytes_.view(); }
  // Messages that were dropped since the level began.
  std::size_t dropped() const { return dropped_; }

  // At a tick's end: everything but the signon is gone, what waited for players included.
  void clear_tick();

 private:
  net::Dialect dialect_;
  base::ByteWriter broadcast_, reliable_, signon_, placed_bytes_;
  std::vector<base::ByteWriter> players_;
  std::vector<Placed> placed_;
  std::size_t dropped_ = 0;
};

}  // namespace temblor::server
