// Recordings in other protocols than they were made in.
#pragma once

#include "base/bytes.h"
#include "base/result.h"
#include "net/protocol/protocol.h"

namespace temblor::test {

// The recording with every message as `dialect` says it, its ServerInfo naming that. Fails where a message
// cannot be read or cannot be said; what it has no words for is left out.
base::Result<base::ByteVector> transcode(base::Bytes dem, const net::Dialect& dialect);

}  // namespace temblor::test
