// Registers console commands that get the host.
#pragma once

#include <string_view>

#include "host/frame/host_parts.h"

namespace temblor::host {

// Returns a function add(NAME, HELP, RUN) that registers RUN(Host&, Arguments). `io_host` must outlive its
// console.
inline auto make_adder(Host& io_host) {
  return [&io_host](std::string_view name, std::string_view help, auto run) {
    io_host.console.commands.add_command(
        name, help, [host = &io_host, run](command::Console::Arguments arguments) { run(*host, arguments); });
  };
}

}  // namespace temblor::host
