#include "app/commands/settings_command.h"

#include <fmt/format.h>

#include "app/commands/command_line.h"

namespace temblor::app {

Command* add_settings_command(Command& program) {
  Command* command = program.add_subcommand("settings", "Lists the console variables that --set takes");
  command->footer(
      "Examples:\n"
      "  temblor settings\n"
      "  temblor --set r_mip_rule=stock settings");
  return command;
}

void run_settings(const command::Variables& variables) {
  for (const command::Variable* variable : variables.all())
    fmt::print("{} = {}\n    {}\n    Takes {}; {} if not set.\n", variable->name, variable->text,
               variable->help, describe_values(*variable), variable->default_text);
}

}  // namespace temblor::app
