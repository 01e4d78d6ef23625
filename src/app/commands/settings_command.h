// `temblor settings`: every console variable with its value and help.
#pragma once

#include "command/variables.h"

namespace temblor::app {

class Command;

Command* add_settings_command(Command& program);
void run_settings(const command::Variables& variables);

}  // namespace temblor::app
