// Console commands about files and the running level, under the names that other engines gave them: path,
// dir, flocate, mapname, randmap, mods, demos, saves, configs, skies, and so on.
#pragma once

namespace temblor::host {

struct Host;

void add_list_commands(Host& io_host);

}  // namespace temblor::host
