// Server messages -> bytes, in any of the dialects.
#pragma once

#include "base/bytes.h"
#include "base/result.h"
#include "net/server_message.h"

namespace temblor::net {

// Appends one message. kTooLarge when the dialect cannot say it (a model number over 255 in protocol 15). A
// message that it has no words for at all (fog in protocol 15) is left out. Coordinates and angles are
// rounded to the nearest that can be said.
base::Status write_message(const ServerMessage& message, const Dialect& dialect, base::ByteWriter& io_writer);

}  // namespace temblor::net
