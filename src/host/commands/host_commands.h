// The commands of a game in a window.
#pragma once

#include <string_view>

namespace temblor::host {

class Host;

void add_host_commands(Host& io_host);

// Whether a server on another machine may have this line run here.
bool may_be_stuffed(std::string_view line);

}  // namespace temblor::host
