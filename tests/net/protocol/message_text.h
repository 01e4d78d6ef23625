// Messages as text, every field of them: what tests compare and what they print.
#pragma once

#include <string>

#include "net/protocol/server_message.h"

namespace temblor::test {

// Equal for two messages if and only if all their fields are.
std::string text_of(const net::ServerMessage& message);

}  // namespace temblor::test
