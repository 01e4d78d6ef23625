// Converts demos to other protocols.
#pragma once

#include "base/bytes.h"
#include "base/result.h"
#include "net/protocol/protocol.h"

namespace temblor::test {

// Converts every message of the demo to `dialect`, and names the dialect in ServerInfo. Fails if a message
// cannot be read or written. Leaves out fields that the dialect does not have.
base::Result<base::ByteVector> transcode(base::Bytes dem, const net::Dialect& dialect);

}  // namespace temblor::test
