#include "client/prediction/sent_moves.h"

#include <algorithm>

#include "base/check.h"

namespace temblor::client {

// Encoding and decoding the move rounds it as the server will see it; predicting the exact input would
// differ.
bool SentMoves::add(const net::Move& move, net::Protocol protocol) {
  base::ByteWriter writer;
  if (!net::write_client_message(move, protocol, writer).ok()) return false;
  net::ClientMessageReader reader(writer.view(), protocol);
  const auto message = reader.next();
  CHECK(message.ok() && message->has_value());
  if (moves_.size() == kMaxMoves) moves_.erase(moves_.begin());
  moves_.push_back({++last_number_, std::get<net::Move>(**message)});
  return true;
}

// Repeats the last few moves in every packet, so that single lost packets do no harm. The move was written
// once in add(), so writing it again cannot fail.
void SentMoves::write_packet(net::NumberedPacket head, net::Protocol protocol,
                             base::ByteWriter& io_writer) const {
  CHECK(!moves_.empty());
  head.last_move = last_number_;
  const std::size_t count = std::min(moves_.size(), net::kMovesInPacket);
  const base::Status numbered =
      net::write_client_message(net::StringCommand{net::format_numbered_packet(head)}, protocol, io_writer);
  CHECK(numbered.ok());
  for (const NumberedMove& sent : std::span(moves_).last(count)) {
    const base::Status written = net::write_client_message(sent.move, protocol, io_writer);
    CHECK(written.ok(), "what was read can be said");
  }
}

}  // namespace temblor::client
