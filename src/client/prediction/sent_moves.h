// The moves that a client has sent to a server that takes numbered moves (net/protocol/numbered_moves.h),
// exactly as the server decodes them. The prediction plays those that are not acknowledged yet.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/bytes.h"
#include "net/protocol/client_message.h"
#include "net/protocol/numbered_moves.h"

namespace temblor::client {

// A move and its number; numbers start at 1.
struct NumberedMove {
  std::uint32_t number = 0;
  net::Move move;
};

class SentMoves {
 public:
  // More than two seconds of moves at 72 a second. Older ones are dropped: a connection that is slower has no
  // prediction.
  static constexpr std::size_t kMaxMoves = 160;

  // Appends the next move. Returns false if the protocol cannot encode it.
  bool add(const net::Move& move, net::Protocol protocol);
  // Writes a packet: its head, completed with the last number, and the last few moves. There must be at least
  // one.
  void write_packet(net::NumberedPacket head, net::Protocol protocol, base::ByteWriter& io_writer) const;

  // The last kMaxMoves moves of this level, with consecutive numbers. Valid until the next add().
  std::span<const NumberedMove> moves() const { return moves_; }
  // Forgets the moves; numbers continue.
  void begin_level() { moves_.clear(); }

 private:
  std::vector<NumberedMove> moves_;
  std::uint32_t last_number_ = 0;
};

}  // namespace temblor::client
