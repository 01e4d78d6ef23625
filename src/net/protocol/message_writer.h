// Server messages -> bytes, in any of the dialects.
#pragma once

#include "base/bytes.h"
#include "base/result.h"
#include "net/protocol/server_message.h"

namespace temblor::net {

// Appends one message. kTooLarge when the dialect cannot say it (a model number over 255 in protocol 15, a
// place outside of the level's bounds of +-4096), and nothing is appended then. A message that it has no
// words for at all (fog in protocol 15; an Ignored in any) is left out, and so are single fields without
// words (an entity's opacity and scale in protocol 15). Coordinates and angles are rounded to the nearest
// that can be said; speeds, opacities and the like also into their range.
//
// A ServerInfo announces its own dialect; the messages behind it are to be written in that one.
base::Status write_message(const ServerMessage& message, const Dialect& dialect, base::ByteWriter& io_writer);

}  // namespace temblor::net
