// Writes the coordinates and angles of messages that QuakeC builds field by field (WriteCoord, WriteAngle).
// QuakeC may pass any number, and the message must stay well formed: values outside of the dialect's range
// are clamped, and NaN becomes 0. Infinite angles become 0 too.
#pragma once

#include "base/bytes.h"
#include "net/protocol/protocol.h"

namespace temblor::net {

// `value`: map units.
void write_coord(float value, const Dialect& dialect, base::ByteWriter& io_writer);
void write_angle_deg(float value, const Dialect& dialect, base::ByteWriter& io_writer);

}  // namespace temblor::net
