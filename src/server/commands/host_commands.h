// The commands of a server's host: levels, saved games, players, recordings.
#pragma once

namespace temblor::server {

class Server;

// Adds them to the server's console, which must live as long as the server.
void add_host_commands(Server& io_server);

}  // namespace temblor::server
