// The commands that every console has, but for those that set variables and those that list what there is.
#include <fmt/format.h>

#include "base/text.h"
#include "command/console.h"
#include "command/text.h"

namespace temblor::command {

void Console::add_built_in_commands() {
  constexpr Kinds kNothing{.commands = false, .aliases = false, .variables = false};
  constexpr Kinds kAliases{.commands = false, .variables = false};
  add_member("alias", "alias NAME COMMANDS names commands; alias NAME shows them; alias lists all.",
             &Console::alias_command, kAliases);
  add_member("unalias", "unalias NAME forgets an alias.", &Console::unalias_command, kAliases);
  add_member("unaliasall", "unaliasall forgets all aliases.", &Console::unaliasall_command, kNothing);
  add_member("echo", "echo WORDS prints them.", &Console::echo_command, kNothing);
  add_member("exec", "exec FILE runs the commands in a file.", &Console::exec_command, kNothing);
  add_command("wait", "wait puts the commands behind it off to the next frame.",
              [this](Arguments) { waiting_ = true; });
}

void Console::alias_command(Arguments arguments) {
  if (arguments.size() == 1) {
    for (const auto& [name, text] : aliases_) print(fmt::format("{}: {}", name, text));
    return;
  }
  const std::string name = base::to_lower(arguments[1]);
  if (arguments.size() == 2) {
    const auto found = aliases_.find(name);
    if (found == aliases_.end())
      return print_error(fmt::format("there is no alias \"{}\"", base::quotable(name)));
    return print(fmt::format("{}: {}", name, found->second));
  }
  if (commands_.contains(name) || variables_.find(name) != nullptr)
    return print_error(fmt::format("\"{}\" is a command or variable and cannot be an alias", arguments[1]));
  // A single word is what was quoted as a whole: commands. Several words are one command.
  aliases_[name] = arguments.size() == 3
                       ? arguments[2]
                       : join_words(std::vector<std::string>(arguments.begin() + 2, arguments.end()));
}

void Console::unalias_command(Arguments arguments) {
  if (arguments.size() < 2) return print_error("unalias NAME: name an alias; `alias` lists them");
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
  if (arguments.size() != 2) return print_error("exec FILE: name one file");
  if (loader_ == nullptr) return print_error("exec: there are no files here");
  const base::Result<std::string> text = loader_(arguments[1]);
  if (!text.ok()) return print_error(text.error().message());
  if (!may_expand(arguments[1], *text)) return;
  // Not of those that a file names: a person asked for the first one.
  if (!is_in_file()) print(fmt::format("exec {}", base::quotable(arguments[1])));
  insert(*text, {.place = {.file = arguments[1]}, .has_lines = true});
}

}  // namespace temblor::command
