#include "app/commands/settings_command.h"

#include <fmt/format.h>

#include "app/commands/command_line.h"

namespace temblor::app {

Command* add_settings_command(Command& program) {
  Command* command = program.add_subcommand("settings", "List all console variables");
  command->footer(
      "Prints each variable's value, meaning, range, and default. --set changes them.\n"
      "\n"
      "Examples:\n"
      "  temblor settings\n"
      "  temblor --set r_mip_rule=stock settings");
  return command;
}

// Three lines per variable, so that the list can be searched with grep -A2.
void run_settings(const command::Variables& variables) {
  for (const command::Variable* variable : variables.all())
    fmt::print("{} = {}\n    {}\n    Values: {}. Default: {}.\n", variable->name, variable->text,
               variable->help, describe_values(*variable), variable->default_text);
}

}  // namespace temblor::app
