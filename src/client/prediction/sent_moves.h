// The moves that a client has sent to a server that takes them numbered, as the server reads them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/bytes.h"
#include "net/protocol/client_message.h"
#include "net/protocol/numbered_moves.h"

namespace temblor::client {

struct NumberedMove {
  std::uint32_t number = 0;
  net::Move move;
};

class SentMoves {
 public:
  // Moves that are kept: more than two seconds of them at 72 a second.
  static constexpr std::size_t kKept = 160;

  // The next one. False where it cannot be said.
  bool add(const net::Move& move, net::Protocol protocol);
  // The packet's bytes: its head, to which the last number is added, and the last few moves. There must be
  // one.
  void write_packet(net::NumberedPacket head, net::Protocol protocol, base::ByteWriter& io_writer) const;

  // In order of number, without gaps; the last kKept of this level.
  std::span<const NumberedMove> moves() const { return moves_; }
  // Another level; numbers go on.
  void begin_level() { moves_.clear(); }

 private:
  std::vector<NumberedMove> moves_;
  std::uint32_t last_number_ = 0;
};

}  // namespace temblor::client
