// Random messages that a dialect can say exactly: read back from their bytes they are the same.
#pragma once

#include "net/protocol/server_message.h"
#include "support/random.h"

namespace temblor::test {

// Of every kind but ServerInfo and Ignored, with the extreme values of each field among the values. Texts
// live as long as the program.
net::ServerMessage random_message(Random& random, const net::Dialect& dialect);

}  // namespace temblor::test
