// Commands that say what there is and what it is for.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "base/text.h"
#include "command/console.h"

namespace temblor::command {

namespace {

std::string line_of(const Candidate& candidate) {
  if (candidate.kind == CandidateKind::kAlias)
    return fmt::format("{}: an alias of {}", candidate.name, base::quotable(candidate.value));
  // Many begin with the name, as what is typed.
  if (candidate.help.starts_with(candidate.name + " ")) return candidate.help;
  return fmt::format("{}: {}", candidate.name, candidate.help);
}

bool holds(std::string_view text, std::string_view lower_word) {
  return base::to_lower(text).find(lower_word) != std::string::npos;
}

// "3 commands that begin with "ma"".
std::string count_line(std::size_t count, std::string_view noun, std::string_view prefix) {
  const std::string counted = base::counted(count, noun);
  if (prefix.empty()) return counted;
  return fmt::format("{} that begin{} with \"{}\"", counted, count == 1 ? "s" : "", base::quotable(prefix));
}

}  // namespace

void Console::add_list_commands() {
  constexpr Kinds kAll, kNothing{.commands = false, .aliases = false, .variables = false};
  add_member("help", "help NAME says what a command or variable is for; help lists the commands.",
             &Console::help_command, kAll);
  add_member("apropos", "apropos WORD lists what has the word in its name or help.",
             &Console::apropos_command, kNothing);
  add_member("find", "find WORD is the same as apropos.", &Console::apropos_command, kNothing);
  add_member("list", "list PREFIX names the commands, aliases and variables that start so; list names all.",
             &Console::list_command, kAll);
  add_member("cmdlist", "cmdlist PREFIX lists the commands that start so; cmdlist lists all.",
             &Console::command_list_command, {.aliases = false, .variables = false});
  add_member("cvarlist",
             "cvarlist PREFIX lists the variables that start so and their values; cvarlist lists all.",
             &Console::variable_list_command, {.commands = false, .aliases = false});
}

void Console::help_command(Arguments arguments) {
  if (arguments.size() == 1) {
    for (const Candidate& command : candidates_of({.aliases = false, .variables = false}, ""))
      if (!command.name.starts_with('-')) print(line_of(command));  // those only end what a key began
    return print("help NAME: more on a command or variable; cvarlist: all variables; apropos WORD: a search");
  }
  if (arguments.size() != 2) return print_error("help NAME: name one command or variable");
  const std::string name = base::to_lower(arguments[1]);
  if (const auto command = commands_.find(name); command != commands_.end())
    print(command->second.help);
  else if (const auto alias = aliases_.find(name); alias != aliases_.end())
    print(fmt::format("\"{}\" is an alias of {}", alias->first, alias->second));
  else if (const Variable* variable = variables_.find(name); variable != nullptr)
    print(fmt::format("{} Takes {}; {} by default.", variable->help, describe_values(*variable),
                      variable->default_text));
  else
    print_error(fmt::format("there is no command or variable \"{}\"; `help` lists the commands",
                            base::quotable(arguments[1])));
}

void Console::apropos_command(Arguments arguments) {
  if (arguments.size() != 2 || arguments[1].empty())
    return print_error(fmt::format("{} WORD: give one word to look for", arguments[0]));
  const std::string word = base::to_lower(arguments[1]);
  std::size_t found = 0;
  for (const Candidate& candidate : candidates("")) {
    if (!holds(candidate.name, word) && !holds(candidate.help, word)) continue;
    print(line_of(candidate));
    ++found;
  }
  if (found == 0) print(fmt::format("nothing has \"{}\" in its name or help", base::quotable(arguments[1])));
}

void Console::list_command(Arguments arguments) {
  for (const std::string& name : complete(arguments.size() > 1 ? arguments[1] : "")) print(name);
}

void Console::command_list_command(Arguments arguments) {
  const std::string_view prefix = arguments.size() > 1 ? std::string_view(arguments[1]) : "";
  const auto commands = candidates_of({.aliases = false, .variables = false}, prefix);
  for (const Candidate& command : commands) print(fmt::format("  {}", command.name));
  print(count_line(commands.size(), "command", prefix));
}

void Console::variable_list_command(Arguments arguments) {
  const std::string_view prefix = arguments.size() > 1 ? std::string_view(arguments[1]) : "";
  const auto variables = candidates_of({.commands = false, .aliases = false}, prefix);
  for (const Candidate& candidate : variables) {
    const Variable& variable = *variables_.find(candidate.name);
    const char mark = variable.text == variable.default_text ? ' ' : '*';
    print(fmt::format("{} {} \"{}\"", mark, variable.name, variable.text));
  }
  print(fmt::format("{}; * marks those that are not at their default",
                    count_line(variables.size(), "variable", prefix)));
}

}  // namespace temblor::command
