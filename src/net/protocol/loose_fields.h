// Coordinates and angles of messages that a game's program writes itself, number by number. Whatever the
// number is, bytes of a message come of it: what the dialect cannot say becomes the nearest that it can, what
// is no number 0.
#pragma once

#include "base/bytes.h"
#include "net/protocol/protocol.h"

namespace temblor::net {

void write_coord(float value, const Dialect& dialect, base::ByteWriter& io_writer);
void write_angle_deg(float value, const Dialect& dialect, base::ByteWriter& io_writer);

}  // namespace temblor::net
