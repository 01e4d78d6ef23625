#include "client/prediction/sent_moves.h"

#include <algorithm>

#include "base/check.h"

namespace temblor::client {

bool SentMoves::add(const net::Move& move, net::Protocol protocol) {
  base::ByteWriter writer;
  if (!net::write_client_message(move, protocol, writer).ok()) return false;
  net::ClientMessageReader reader(writer.view(), protocol);
  const auto message = reader.next();
  CHECK(message.ok() && message->has_value());
  if (moves_.size() == kKept) moves_.erase(moves_.begin());
  moves_.push_back({++last_number_, std::get<net::Move>(**message)});
  return true;
}

void SentMoves::write_packet(net::NumberedPacket head, net::Protocol protocol,
                             base::ByteWriter& io_writer) const {
  CHECK(!moves_.empty());
  head.last_move = last_number_;
  const std::size_t count = std::min(moves_.size(), net::kMovesInPacket);
  const base::Status numbered =
      net::write_client_message(net::StringCommand{net::command_of(head)}, protocol, io_writer);
  CHECK(numbered.ok());
  for (const NumberedMove& sent : std::span(moves_).last(count)) {
    const base::Status written = net::write_client_message(sent.move, protocol, io_writer);
    CHECK(written.ok(), "what was read can be said");
  }
}

}  // namespace temblor::client
