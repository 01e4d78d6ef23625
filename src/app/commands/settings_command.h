// `temblor settings`: lists every console variable with its value, meaning, valid values, and default.
#pragma once

#include "command/variables.h"

namespace temblor::app {

class Command;

Command* add_settings_command(Command& program);
// Prints the variables to standard output, in the order of their registration.
void run_settings(const command::Variables& variables);

}  // namespace temblor::app
