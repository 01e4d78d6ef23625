// The console commands of a server's host: levels, saved games, players, demos, and debugging of game code.
#pragma once

namespace temblor::server {

struct Server;

// Adds the commands to the server's console. The server must live as long as its console.
void add_host_commands(Server& io_server);

}  // namespace temblor::server
