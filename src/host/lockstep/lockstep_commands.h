// The console commands of lockstep games: lockstep, lockstep_join, playreplay.
#pragma once

namespace temblor::host {

struct Host;

void add_lockstep_commands(Host& io_host);

}  // namespace temblor::host
