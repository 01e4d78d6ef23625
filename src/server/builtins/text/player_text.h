// Words for players.
#pragma once

#include <algorithm>
#include <string_view>

#include "server/builtins/call.h"

namespace temblor::server {

// Stock clients read 2047 bytes of a text and take what is behind them for the next message.
constexpr std::size_t kMaxTextBytes = 1024;

// In as many messages as it takes; none for an empty text.
template <typename Message>
void write_text(std::string_view text, Outbox& io_outbox, base::ByteWriter& io_writer) {
  for (; !text.empty(); text.remove_prefix(std::min(text.size(), kMaxTextBytes)))
    io_outbox.write(Message{text.substr(0, kMaxTextBytes)}, io_writer);
}

// In the middle of the screen, as far as it fits one message. An empty text takes the last one away.
void write_center_text(std::string_view text, Outbox& io_outbox, base::ByteWriter& io_writer);

// Where words for the entity that is parameter 0 go. Null, and a line on the console, for who is no player:
// the original puts up with that.
base::Result<base::ByteWriter*> listener(Call& io_call);

}  // namespace temblor::server
