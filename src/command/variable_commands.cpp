// Commands that set variables, and a variable's name as a command.
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

// Few enough digits that steps of 0.1 do not show how doubles are rounded.
std::string number_text(const Variable& variable, double number) {
  return variable.type == VariableType::kInt ? fmt::format("{:.0f}", std::round(number))
                                             : fmt::format("{:.9g}", number);
}

}  // namespace

void Console::add_variable_commands() {
  constexpr Kinds kNothing{.commands = false, .aliases = false, .variables = false};
  constexpr Kinds kVariables{.commands = false, .aliases = false};
  add_member("set", "set NAME VALUE sets a variable.", &Console::set_command, kVariables);
  add_member("seta", "seta NAME VALUE sets a variable, as set does: settings are always kept.",
             &Console::set_command, kVariables);
  add_member("toggle", "toggle NAME turns a 0 or 1 variable over, and moves any other choice to the next.",
             &Console::toggle_command, kVariables);
  add_member("cycle",
             "cycle NAME VALUES moves a variable to the next of the values, from the last to the first.",
             &Console::cycle_command, kVariables);
  add_member("inc", "inc NAME STEP adds to a variable as far as its range goes; 1 without STEP.",
             &Console::inc_command, kVariables);
  add_member("reset", "reset NAME gives a variable its default.", &Console::reset_command, kVariables);
  add_member("resetall", "resetall gives all variables their defaults.", &Console::reset_all_command,
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
    print_if_error(variables_.set(variable.name, arguments[1]));
}

void Console::set_command(Arguments arguments) {
  if (arguments.size() != 3)
    return print_error(fmt::format("{} NAME VALUE: name a variable and its value", arguments[0]));
  print_if_error(variables_.set(arguments[1], arguments[2]));
}

void Console::toggle_command(Arguments arguments) {
  if (arguments.size() != 2) return print_error("toggle NAME: name one variable");
  const Variable* const variable = find_variable(arguments[1]);
  if (variable == nullptr) return;
  if (variable->type == VariableType::kBool) {
    print_if_error(variables_.set(variable->name, variable->number != 0 ? "0" : "1"));
  } else if (variable->type == VariableType::kChoice) {
    const std::size_t next = (static_cast<std::size_t>(variable->number) + 1) % variable->choices.size();
    print_if_error(variables_.set(variable->name, variable->choices[next]));
  } else {
    print_error(fmt::format("\"{}\" has no fixed values to go through", variable->name));
  }
}

// A value that is none of them is followed by the first.
void Console::cycle_command(Arguments arguments) {
  if (arguments.size() < 3)
    return print_error("cycle NAME VALUES: name a variable and the values to go through");
  const Variable* const variable = find_variable(arguments[1]);
  if (variable == nullptr) return;
  const Arguments values = arguments.subspan(2);
  const auto now = std::find_if(values.begin(), values.end(),
                                [&](const std::string& value) { return has_value(*variable, value); });
  const bool is_last = now == values.end() || now + 1 == values.end();
  print_if_error(variables_.set(variable->name, is_last ? values.front() : *(now + 1)));
}

void Console::inc_command(Arguments arguments) {
  if (arguments.size() != 2 && arguments.size() != 3)
    return print_error("inc NAME STEP: name one variable, and what to add to it");
  const Variable* const variable = find_variable(arguments[1]);
  if (variable == nullptr) return;
  const std::optional<double> step = arguments.size() == 3 ? parse_number(arguments[2]) : 1.0;
  if (!step) return print_error(fmt::format("inc: \"{}\" is not a number", base::quotable(arguments[2])));
  if (!is_number(*variable)) return print_error(fmt::format("\"{}\" is not a number", variable->name));
  const double sum = std::clamp(variable->number + *step, variable->min, variable->max);
  print_if_error(variables_.set(variable->name, number_text(*variable, sum)));
}

void Console::reset_command(Arguments arguments) {
  if (arguments.size() < 2) return print_error("reset NAME: name a variable; resetall resets all");
  for (const std::string& name : arguments.subspan(1)) print_if_error(variables_.reset(name));
}

void Console::reset_all_command(Arguments) {
  for (const Variable* variable : variables_.all()) print_if_error(variables_.reset(variable->name));
}

}  // namespace temblor::command
