// Console commands that change the fog, the sky, and the tint of the level that is shown, and that show or
// list what is known of it: fog, sky, v_cshift, bf, pointfile, entities. The names and arguments are those of
// other engines.
#pragma once

namespace temblor::host {

struct Host;

void add_view_commands(Host& io_host);

}  // namespace temblor::host
