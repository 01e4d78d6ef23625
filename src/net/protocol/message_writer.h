// Writes server messages (server_message.h) in any dialect; the inverse of message_reader.h.
#pragma once

#include "base/bytes.h"
#include "base/result.h"
#include "net/protocol/server_message.h"

namespace temblor::net {

// Appends one message with its number. Returns kTooLarge and appends nothing if the dialect cannot represent
// a value: a model number over 255, or a coordinate beyond +-4096 in protocol 15. Omits messages that the
// dialect does not have (fog in protocol 15; Ignored in every one), and fields that it does not have (the
// alpha and scale of an entity in protocol 15). Rounds coordinates and angles to the nearest representable
// value; also clamps velocities, alpha, and the like.
//
// A ServerInfo is written in the dialect that it announces; write all later messages in that dialect.
base::Status write_message(const ServerMessage& message, const Dialect& dialect, base::ByteWriter& io_writer);

}  // namespace temblor::net
