// The commands that every console has.
#include <fmt/format.h>

#include "base/text.h"
#include "command/console.h"
#include "command/text.h"

namespace temblor::command {

void Console::add_built_in_commands() {
  using Member = void (Console::*)(Arguments);
  const auto add = [this](std::string_view name, std::string_view help, Member member) {
    add_command(name, help, [this, member](Arguments arguments) { (this->*member)(arguments); });
  };
  add("alias", "alias NAME COMMANDS names commands; alias NAME shows them; alias lists all.",
      &Console::alias_command);
  add("unalias", "unalias NAME forgets an alias.", &Console::unalias_command);
  add("echo", "echo WORDS prints them.", &Console::echo_command);
  add("exec", "exec FILE runs the commands in a file.", &Console::exec_command);
  add("help", "help NAME says what a command or variable is for.", &Console::help_command);
  add("list", "list PREFIX names the commands, aliases and variables that start so; list names all.",
      &Console::list_command);
  add("reset", "reset NAME gives a variable its default.", &Console::reset_command);
  add("set", "set NAME VALUE sets a variable.", &Console::set_command);
  add("toggle", "toggle NAME turns a 0 or 1 variable over, and moves any other choice to the next.",
      &Console::toggle_command);
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
    return print(found == aliases_.end() ? fmt::format("there is no alias \"{}\"", arguments[1])
                                         : fmt::format("{}: {}", name, found->second));
  }
  if (commands_.contains(name) || variables_.find(name) != nullptr)
    return print(fmt::format("\"{}\" is a command or variable and cannot be an alias", arguments[1]));
  // A single word is what was quoted as a whole: commands. Several words are one command.
  aliases_[name] = arguments.size() == 3
                       ? arguments[2]
                       : join_words(std::vector<std::string>(arguments.begin() + 2, arguments.end()));
}

void Console::unalias_command(Arguments arguments) {
  for (const std::string& name : arguments.subspan(1))
    if (aliases_.erase(base::to_lower(name)) == 0) print(fmt::format("there is no alias \"{}\"", name));
}

void Console::echo_command(Arguments arguments) {
  std::string line;
  for (const std::string& word : arguments.subspan(1)) line += line.empty() ? word : " " + word;
  print(line);
}

void Console::exec_command(Arguments arguments) {
  if (arguments.size() != 2) return print("exec FILE: name one file");
  if (loader_ == nullptr) return print("exec: there are no files here");
  const base::Result<std::string> text = loader_(arguments[1]);
  if (!text.ok()) return print(text.error().message());
  if (may_expand(arguments[1])) insert(*text);
}

void Console::help_command(Arguments arguments) {
  if (arguments.size() != 2) return print("help NAME: name one command or variable; list names them all");
  const std::string name = base::to_lower(arguments[1]);
  if (const auto command = commands_.find(name); command != commands_.end())
    print(command->second.help);
  else if (const Variable* variable = variables_.find(name); variable != nullptr)
    print(fmt::format("{} Takes {}; {} by default.", variable->help, describe_values(*variable),
                      variable->default_text));
  else
    print(fmt::format("there is no command or variable \"{}\"", arguments[1]));
}

void Console::list_command(Arguments arguments) {
  for (const std::string& name : complete(arguments.size() > 1 ? arguments[1] : "")) print(name);
}

void Console::reset_command(Arguments arguments) {
  for (const std::string& name : arguments.subspan(1)) print_if_error(variables_.reset(name));
}

void Console::set_command(Arguments arguments) {
  if (arguments.size() != 3) return print("set NAME VALUE: name a variable and its value");
  print_if_error(variables_.set(arguments[1], arguments[2]));
}

void Console::toggle_command(Arguments arguments) {
  if (arguments.size() != 2) return print("toggle NAME: name one variable");
  const Variable* variable = variables_.find(arguments[1]);
  if (variable == nullptr) return print(fmt::format("there is no variable \"{}\"", arguments[1]));
  if (variable->type == VariableType::kBool) {
    print_if_error(variables_.set(variable->name, variable->number != 0 ? "0" : "1"));
  } else if (variable->type == VariableType::kChoice) {
    const std::size_t next = (static_cast<std::size_t>(variable->number) + 1) % variable->choices.size();
    print_if_error(variables_.set(variable->name, variable->choices[next]));
  } else {
    print(fmt::format("\"{}\" has no fixed values to go through", variable->name));
  }
}

}  // namespace temblor::command
