// `temblor serve`: a dedicated server with its console on standard input.
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
  std::string map;
  std::uint16_t port = 26000;
  std::string host;  // a host in numbers to receive on alone
  std::uint32_t max_clients = 8;
  std::string program;               // a progs.dat on disk; empty: the game folders'
  std::vector<std::string> execute;  // console commands, before the first level
  double duration_s = 0;             // ends by itself after that time; 0: never
};

Command* add_serve_command(Command& program, ServeOptions& io_options);

// Until `quit`, Ctrl-C, SIGTERM or the terminal's end. `common`: its --set are taken once more after
// server.cfg, so that the command line has the last word.
base::Status run_serve(const ServeOptions& options, const CommonOptions& common,
                       const server::ServerVariables& settings);

}  // namespace temblor::app
