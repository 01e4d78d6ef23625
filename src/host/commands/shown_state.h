// The state of the game or demo on the screen, for commands that read or change it.
#pragma once

#include "command/console.h"
#include "net/protocol/server_message.h"

namespace temblor::client {
class ClientState;
}

namespace temblor::host {

struct Host;

// Prints an error with the command's name and returns null if neither a game nor a demo is on the screen.
client::ClientState* find_shown_state(Host& io_host, command::Console::Arguments arguments);

// Changes the state as if the server had sent the message.
void apply_message(Host& io_host, client::ClientState& io_state, const net::ServerMessage& message);

}  // namespace temblor::host
