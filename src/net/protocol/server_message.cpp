#include "net/protocol/server_message.h"

#include "net/wire/message_id.h"

namespace temblor::net {

const char* name_of(const ServerMessage& message) {
  const char* name = name_of(id_of(message));
  return name != nullptr ? name : "unknown message";
}

}  // namespace temblor::net
