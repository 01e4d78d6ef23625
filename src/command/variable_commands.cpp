// Commands that set variables (set, toggle, cycle, inc, reset), and variable names as commands.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/text.h"
#include "command/console.h"
#include "command/text.h"

namespace temblor::command {

namespace {

bool is_number(const Variable& variable) {
  return variable.type == VariableType::kInt || variable.type == VariableType::kFloat;
}

// Formats the result of `inc`. Nine digits hide the rounding errors of doubles after steps of 0.1.
std::string format_number(const Variable& variable, double number) {
  return variable.type == VariableType::kInt ? fmt::format("{:.0f}", std::round(number))
                                             : fmt::format("{:.9g}", number);
}

// Other engines move a number that is out of range into it, so their config files may hold one. 2 turns a
// switch on.
std::optional<std::string> find_nearest_value(const Variable& variable, std::string_view value) {
  const std::optional<double> number = parse_number(value);
  if (!number) return std::nullopt;
  if (variable.type == VariableType::kBool) return *number != 0 ? "1" : "0";
  if (!is_number(variable)) return std::nullopt;
  return format_number(variable, std::clamp(*number, variable.min, variable.max));
}

// Returns what to tell the player: nothing, or why the value is another one or was refused.
base::Status set_or_move_into_range(Variables& io_variables, const Variable& variable,
                                    std::string_view value) {
  base::Status status = io_variables.set(variable.name, value);
  if (status.ok()) return status;
  const std::optional<std::string> nearest = find_nearest_value(variable, value);
  if (!nearest || !io_variables.set(variable.name, *nearest).ok()) return status;
  return base::error(status.error().code, "{}; it is \"{}\" now", status.error().what, variable.text);
}

}  // namespace

void Console::add_variable_commands() {
  constexpr Kinds kNothing{.commands = false, .aliases = false, .variables = false};
  constexpr Kinds kVariables{.commands = false, .aliases = false};
  add_member("set", "set NAME VALUE sets a variable; makes it if there is none.", &Console::set_command,
             kVariables);
  add_member("seta", "seta NAME VALUE is the same, and the variable is saved with the settings.",
             &Console::set_command, kVariables);
  add_member("toggle", "toggle NAME switches a variable between 0 and 1, or to the next of its choices.",
             &Console::toggle_command, kVariables);
  add_member("cycle",
             "cycle NAME VALUES sets a variable to the next of the values, and after the last to the first.",
             &Console::cycle_command, kVariables);
  add_member("inc", "inc NAME STEP adds STEP (default 1) to a variable, within its range.",
             &Console::inc_command, kVariables);
  add_member("reset", "reset NAME resets a variable to its default.", &Console::reset_command, kVariables);
  add_member("resetall", "resetall resets all variables to their defaults.", &Console::reset_all_command,
             kNothing);
}

const Variable* Console::find_variable(std::string_view name) {
  const Variable* const variable = variables_.find(name);
  if (variable == nullptr) print_error(fmt::format("there is no variable \"{}\"", base::quotable(name)));
  return variable;
}

void Console::variable_command(const Variable& variable, Arguments arguments) {
  if (arguments.size() == 1)
    print(fmt::format("\"{}\" is \"{}\"", variable.name, variable.text));
  else
    print_if_error(set_or_move_into_range(variables_, variable, arguments[1]));
}

void Console::set_command(Arguments arguments) {
  if (arguments.size() != 3) return print_error(fmt::format("usage: {} NAME VALUE", arguments[0]));
  const std::string name = base::to_lower(arguments[1]);
  if (commands_.contains(name) || aliases_.contains(name))
    return print_error(fmt::format("\"{}\" is not a variable", base::quotable(arguments[1])));
  if (const Variable* const variable = variables_.find(name); variable != nullptr) {
    print_if_error(set_or_move_into_range(variables_, *variable, arguments[2]));
  } else {
    if (foreign_setter_ && foreign_setter_(arguments.subspan(1))) return;
    print_if_error(variables_.make(arguments[1], arguments[2]));
  }
  if (base::equal_ignoring_case(arguments[0], "seta")) variables_.keep(name);
}

void Console::toggle_command(Arguments arguments) {
  if (arguments.size() != 2) return print_error("usage: toggle NAME");
  const Variable* const variable = find_variable(arguments[1]);
  if (variable == nullptr) return;
  if (variable->type == VariableType::kBool) {
    print_if_error(variables_.set(variable->name, variable->number != 0 ? "0" : "1"));
  } else if (variable->type == VariableType::kChoice) {
    const std::size_t next = (static_cast<std::size_t>(variable->number) + 1) % variable->choices.size();
    print_if_error(variables_.set(variable->name, variable->choices[next]));
  } else {
    print_error(fmt::format("\"{}\" has no list of values; use cycle or inc", variable->name));
  }
}

// Compares parsed values, so that "1" and "on" are the same. A current value that is not in the list is
// followed by the first one.
void Console::cycle_command(Arguments arguments) {
  if (arguments.size() < 3) return print_error("usage: cycle NAME VALUES");
  const Variable* const variable = find_variable(arguments[1]);
  if (variable == nullptr) return;
  const Arguments values = arguments.subspan(2);
  const auto now = std::find_if(values.begin(), values.end(),
                                [&](const std::string& value) { return has_value(*variable, value); });
  const bool is_last = now == values.end() || now + 1 == values.end();
  print_if_error(variables_.set(variable->name, is_last ? values.front() : *(now + 1)));
}

void Console::inc_command(Arguments arguments) {
  if (arguments.size() != 2 && arguments.size() != 3) return print_error("usage: inc NAME STEP");
  const Variable* const variable = find_variable(arguments[1]);
  if (variable == nullptr) return;
  const std::optional<double> step = arguments.size() == 3 ? parse_number(arguments[2]) : 1.0;
  if (!step) return print_error(fmt::format("inc: \"{}\" is not a number", base::quotable(arguments[2])));
  if (!is_number(*variable)) return print_error(fmt::format("\"{}\" is not a number", variable->name));
  const double sum = std::clamp(variable->number + *step, variable->min, variable->max);
  print_if_error(variables_.set(variable->name, format_number(*variable, sum)));
}

void Console::reset_command(Arguments arguments) {
  if (arguments.size() < 2) return print_error("usage: reset NAME; resetall resets all variables");
  for (const std::string& name : arguments.subspan(1)) print_if_error(variables_.reset(name));
}

void Console::reset_all_command(Arguments) {
  for (const Variable* variable : variables_.all()) print_if_error(variables_.reset(variable->name));
}

}  // namespace temblor::command
