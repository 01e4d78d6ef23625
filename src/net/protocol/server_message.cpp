#include "net/protocol/server_message.h"

#include "net/wire/message_id.h"

namespace temblor::net {

const char* message_name(const ServerMessage& message) {
  const char* name = message_name(message_id(message));
  return name != nullptr ? name : "unknown message";
}

}  // namespace temblor::net
