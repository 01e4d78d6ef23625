// `temblor settings`: every console variable with its value and help.
#pragma once

#include "command/variables.h"

namespace CLI {
class App;
}

namespace temblor::app {

CLI::App* add_settings_command(CLI::App& program);
void run_settings(const command::Variables& variables);

}  // namespace temblor::app
