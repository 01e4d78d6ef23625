// Text messages for players: prints of any length, and text in the middle of the screen.
#pragma once

#include <algorithm>
#include <string_view>

#include "server/builtins/call.h"

namespace temblor::server {

// Stock clients read 2047 bytes of a text, and would take the rest for the next message.
constexpr std::size_t kMaxTextBytes = 1024;

// Writes as many messages as needed; none for an empty text.
template <typename Message>
void write_text(std::string_view text, Outbox& io_outbox, base::ByteWriter& io_writer) {
  for (; !text.empty(); text.remove_prefix(std::min(text.size(), kMaxTextBytes)))
    io_outbox.write(Message{text.substr(0, kMaxTextBytes)}, io_writer);
}

// Writes text for the middle of the screen, as much as fits into one message. An empty text clears the last
// one.
void write_center_text(std::string_view text, Outbox& io_outbox, base::ByteWriter& io_writer);

// The buffer for text to the player in parameter 0. Null, after a warning on the console, if that entity is
// not a player: the original accepts such calls.
base::Result<base::ByteWriter*> player_buffer(Call& io_call);

}  // namespace temblor::server
