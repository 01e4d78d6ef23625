// The console commands of a game in a window.
//
//   kind                                 runs                             examples
//   player commands                      on the server, sent as text      say, god, kill
//   server commands                      in our own server's console      changelevel, kick
//   game, demo and screen commands       in the host                      map, playdemo, screenshot
//
// The commands that hold or bind keys are registered elsewhere (client/input/input_variables.h).
#pragma once

namespace temblor::host {

struct Host;

// Registers all commands of the host. `io_host` must outlive its console.
void add_host_commands(Host& io_host);

}  // namespace temblor::host
