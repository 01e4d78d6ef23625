// `temblor serve`: a dedicated server whose console is standard input. Connects the server library to the
// network, the files, and the clock.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/commands/options.h"
#include "base/result.h"
#include "command/variables.h"
#include "server/server_variables.h"

namespace temblor::app {

class Command;

struct ServeOptions {
  // The first level.
  std::string map;
  // UDP port; 0: any free port.
  std::uint16_t port = 26000;
  // Numeric address to listen on; empty: all addresses of the machine.
  std::string host;
  // 1 to 255; 1 starts a single-player game. 0: as `maxplayers` in server.cfg says.
  std::uint32_t max_clients = 0;
  // Path of a progs.dat; empty: the one in the game directories.
  std::string program;
  // Console commands to run before the first level.
  std::vector<std::string> execute;
  // Quit after this time; 0: never.
  double duration_s = 0;
};

Command* add_serve_command(Command& program, ServeOptions& io_options);

// Runs until `quit`, Ctrl-C, SIGTERM, or SIGHUP. The --set options in `common` are applied again after
// server.cfg, so that the command line overrides the file. Errors: no game data, a port that is in use, or a
// level that cannot start.
base::Status run_serve(const ServeOptions& options, const CommonOptions& common,
                       const server::ServerVariables& settings);

}  // namespace temblor::app
