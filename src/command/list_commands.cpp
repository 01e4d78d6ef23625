// Commands that list names and their help: help, apropos, find, list, cmdlist, cvarlist.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "base/text.h"
#include "command/console.h"

namespace temblor::command {

namespace {

std::string format_candidate(const Candidate& candidate) {
  if (candidate.kind == CandidateKind::kAlias)
    return fmt::format("{}: an alias of {}", candidate.name, base::quotable(candidate.value));
  // Many help texts start with the name.
  if (candidate.help.starts_with(candidate.name + " ")) return candidate.help;
  return fmt::format("{}: {}", candidate.name, candidate.help);
}

// Finds a word anywhere in a text, ignoring case.
bool contains_word(std::string_view text, std::string_view lower_word) {
  return base::to_lower(text).find(lower_word) != std::string::npos;
}

// Formats "3 commands that begin with "ma"", or "3 commands" without a prefix.
std::string format_count(std::size_t count, std::string_view noun, std::string_view prefix) {
  const std::string counted = base::counted(count, noun);
  if (prefix.empty()) return counted;
  return fmt::format("{} that begin{} with \"{}\"", counted, count == 1 ? "s" : "", base::quotable(prefix));
}

}  // namespace

void Console::add_list_commands() {
  constexpr Kinds kAll, kNothing{.commands = false, .aliases = false, .variables = false};
  add_member("help", "help NAME describes a command or variable; help lists all commands.",
             &Console::help_command, kAll);
  add_member("apropos", "apropos WORD lists commands and variables that mention the word.",
             &Console::apropos_command, kNothing);
  add_member("find", "find WORD is the same as apropos.", &Console::apropos_command, kNothing);
  add_member("list",
             "list PREFIX lists commands, aliases, and variables that begin with PREFIX; list lists all.",
             &Console::list_command, kAll);
  add_member("cmdlist", "cmdlist PREFIX lists commands that begin with PREFIX; cmdlist lists all.",
             &Console::command_list_command, {.aliases = false, .variables = false});
  add_member("cvarlist",
             "cvarlist PREFIX lists variables that begin with PREFIX, and their values; cvarlist lists all.",
             &Console::variable_list_command, {.commands = false, .aliases = false});
}

void Console::help_command(Arguments arguments) {
  if (arguments.size() == 1) {
    for (const Candidate& command : find_candidates({.aliases = false, .variables = false}, ""))
      if (!command.name.starts_with('-')) print(format_candidate(command));  // "-NAME" only ends "+NAME"
    return print(
        "help NAME describes a command or variable; cvarlist lists all variables; apropos WORD searches");
  }
  if (arguments.size() != 2) return print_error("usage: help NAME");
  const std::string name = base::to_lower(arguments[1]);
  if (const auto command = commands_.find(name); command != commands_.end())
    print(command->second.help);
  else if (const auto alias = aliases_.find(name); alias != aliases_.end())
    print(fmt::format("\"{}\" is an alias of {}", alias->first, alias->second.text));
  else if (const Variable* variable = variables_.find(name); variable != nullptr)
    print(fmt::format("{} Takes {}; {} by default.", variable->help, describe_values(*variable),
                      variable->default_text));
  else
    print_error(fmt::format("there is no command or variable \"{}\"; `help` lists the commands",
                            base::quotable(arguments[1])));
}

void Console::apropos_command(Arguments arguments) {
  if (arguments.size() != 2 || arguments[1].empty())
    return print_error(fmt::format("usage: {} WORD", arguments[0]));
  const std::string word = base::to_lower(arguments[1]);
  std::size_t found = 0;
  for (const Candidate& candidate : candidates("")) {
    if (!contains_word(candidate.name, word) && !contains_word(candidate.help, word)) continue;
    print(format_candidate(candidate));
    ++found;
  }
  if (found == 0) print(fmt::format("no command or variable mentions \"{}\"", base::quotable(arguments[1])));
}

void Console::list_command(Arguments arguments) {
  for (const std::string& name : complete(arguments.size() > 1 ? arguments[1] : "")) print(name);
}

void Console::command_list_command(Arguments arguments) {
  const std::string_view prefix = arguments.size() > 1 ? std::string_view(arguments[1]) : "";
  const auto commands = find_candidates({.aliases = false, .variables = false}, prefix);
  for (const Candidate& command : commands) print(fmt::format("  {}", command.name));
  print(format_count(commands.size(), "command", prefix));
}

// Marks variables that differ from their defaults, so that `cvarlist` shows what a player has configured.
void Console::variable_list_command(Arguments arguments) {
  const std::string_view prefix = arguments.size() > 1 ? std::string_view(arguments[1]) : "";
  const auto variables = find_candidates({.commands = false, .aliases = false}, prefix);
  for (const Candidate& candidate : variables) {
    const Variable& variable = *variables_.find(candidate.name);
    const char mark = variable.text == variable.default_text ? ' ' : '*';
    print(fmt::format("{} {} \"{}\"", mark, variable.name, variable.text));
  }
  print(fmt::format("{}; * marks changed variables", format_count(variables.size(), "variable", prefix)));
}

}  // namespace temblor::command
