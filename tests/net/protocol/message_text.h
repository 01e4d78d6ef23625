// Messages as text with every field, to compare and print in tests.
#pragma once

#include <string>

#include "net/protocol/server_message.h"

namespace temblor::test {

// Equal for two messages if and only if all of their fields are equal.
std::string get_text(const net::ServerMessage& message);

}  // namespace temblor::test
