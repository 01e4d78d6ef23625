// The commands of every console, except those that set variables (variable_commands.cpp) and those that list
// names (list_commands.cpp).
#include <fmt/format.h>

#include "base/text.h"
#include "command/console.h"
#include "command/text.h"

namespace temblor::command {

void Console::add_built_in_commands() {
  constexpr Kinds kNothing{.commands = false, .aliases = false, .variables = false};
  constexpr Kinds kAliases{.commands = false, .variables = false};
  add_member("alias", "alias NAME COMMANDS defines an alias; alias NAME shows it; alias lists all aliases.",
             &Console::alias_command, kAliases);
  add_member("unalias", "unalias NAME removes an alias.", &Console::unalias_command, kAliases);
  add_command("aliaslist", "aliaslist shows all aliases.",
              [this](Arguments arguments) { alias_command(arguments.first(1)); });
  add_member("unaliasall", "unaliasall removes all aliases.", &Console::unaliasall_command, kNothing);
  add_member("echo", "echo TEXT prints the text.", &Console::echo_command, kNothing);
  add_member("exec", "exec FILE runs the commands in a file.", &Console::exec_command, kNothing);
  add_command("wait", "wait delays the commands after it until the next frame.",
              [this](Arguments) { waiting_ = true; });
}

const Alias* Console::find_alias(std::string_view name) const {
  const auto found = aliases_.find(base::to_lower(name));
  return found != aliases_.end() ? &found->second : nullptr;
}

void Console::set_alias(std::string_view name, Alias alias) {
  if (alias.text.empty())
    aliases_.erase(base::to_lower(name));
  else
    aliases_[base::to_lower(name)] = std::move(alias);
}

// A name that is taken by a command or variable is refused, because the alias would never run.
void Console::alias_command(Arguments arguments) {
  if (arguments.size() == 1) {
    for (const auto& [name, alias] : aliases_) print(fmt::format("{}: {}", name, alias.text));
    return;
  }
  const std::string name = base::to_lower(arguments[1]);
  if (arguments.size() == 2) {
    const auto found = aliases_.find(name);
    if (found == aliases_.end())
      return print_error(fmt::format("there is no alias \"{}\"", base::quotable(name)));
    return print(fmt::format("{}: {}", name, found->second.text));
  }
  if (commands_.contains(name) || variables_.find(name) != nullptr)
    return print_error(fmt::format("\"{}\" is a command or variable and cannot be an alias", arguments[1]));
  // A single word was quoted as a whole and may contain several commands: alias both "+attack; +jump".
  // Several words are one command, whose quotes must be restored: alias hi say "good day".
  aliases_[name] = {arguments.size() == 3
                        ? arguments[2]
                        : join_words(std::vector<std::string>(arguments.begin() + 2, arguments.end())),
                    place_.source};
}

void Console::unalias_command(Arguments arguments) {
  if (arguments.size() < 2) return print_error("usage: unalias NAME; `alias` lists all aliases");
  for (const std::string& name : arguments.subspan(1))
    if (aliases_.erase(base::to_lower(name)) == 0)
      print_error(fmt::format("there is no alias \"{}\"", base::quotable(name)));
}

void Console::unaliasall_command(Arguments) {
  aliases_.clear();
}

void Console::echo_command(Arguments arguments) {
  std::string line;
  for (const std::string& word : arguments.subspan(1)) {
    if (!line.empty()) line += ' ';
    line += word;
  }
  print(line);
}

void Console::exec_command(Arguments arguments) {
  if (arguments.size() != 2) return print_error("usage: exec FILE");
  if (loader_ == nullptr) return print_error("exec is not available here: there are no config files");
  const base::Result<std::string> text = loader_(arguments[1]);
  if (!text.ok()) return print_error(text.error().message());
  if (!count_expansion(arguments[1], *text)) return;
  // Report only the file that the player asked for, not files that it includes.
  if (!is_in_file()) print(fmt::format("exec {}", base::quotable(arguments[1])));
  insert(*text, {.place = {.file = arguments[1], .source = place_.source}, .has_lines = true});
}

}  // namespace temblor::command
