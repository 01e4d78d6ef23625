// Random messages that a dialect can represent exactly, so that they survive a round trip.
#pragma once

#include "net/protocol/server_message.h"
#include "support/random.h"

namespace temblor::test {

// Returns any message except ServerInfo and Ignored. Extreme values of all fields are frequent. Texts live as
// long as the program.
net::ServerMessage random_message(Random& random, const net::Dialect& dialect);

}  // namespace temblor::test
