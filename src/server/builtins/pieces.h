// Text for clients, in pieces that they have room for: stock ones read 2047 bytes of a text and take what is
// behind them for the next message.
#pragma once

#include <algorithm>
#include <string_view>

#include "server/outbox.h"

namespace temblor::server {

constexpr std::size_t kMaxTextBytes = 1024;

// As many messages as it takes; none for an empty text.
template <typename Message>
void write_text(std::string_view text, Outbox& io_outbox, base::ByteWriter& io_writer) {
  for (; !text.empty(); text.remove_prefix(std::min(text.size(), kMaxTextBytes)))
    io_outbox.write(Message{text.substr(0, kMaxTextBytes)}, io_writer);
}

}  // namespace temblor::server
