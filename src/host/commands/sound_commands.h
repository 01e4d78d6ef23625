// Console commands that play sounds and music. The names and arguments are those of other engines.
#pragma once

namespace temblor::host {

struct Host;

void add_sound_commands(Host& io_host);

}  // namespace temblor::host
