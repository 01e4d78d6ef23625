// The command line: commands and their options.
//
// Command and Option are a thin layer over CLI11, which does the parsing. Only command_line.cpp includes
// CLI11, because its templates take seconds to compile wherever they are included. Names and behavior of the
// functions are CLI11's.
//
//   Command program("what the program does", "temblor");
//   Command* render = program.add_subcommand("render", "...");
//   render->add_option("--map", options.map, "...")->type_name("NAME");
//   const Command::Parsed parsed = program.parse(words);
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/commands/options.h"
#include "base/result.h"

namespace CLI {
class App;
class Option;
class Validator;
}  // namespace CLI

namespace temblor::app {

// A condition on an option's value. Its error message names the valid values. Ranges include both ends.
using Condition = std::shared_ptr<const CLI::Validator>;
Condition in_range(int min, int max);
Condition in_range(double min, double max);
Condition one_of(std::vector<int> values);
Condition not_negative();

// An option of a command, which owns it. The functions return the option, so that calls can be chained.
class Option {
 public:
  explicit Option(CLI::Option& option) : option_(option) {}

  // Sets the name of the value in the help text, such as FILE.
  Option* type_name(const std::string& name);
  // Sets the default that the help text shows: a given text, or the variable's initial value.
  Option* default_str(const std::string& text);
  Option* capture_default_str();
  Option* required();
  Option* check(const Condition& condition);
  // `condition` returns an error message, or an empty string for a valid value.
  Option* check(std::string (*condition)(const std::string&));
  // For repeatable options: allow_extra_args(false) stops a word after the value from becoming a second
  // value, and take_all() keeps the values of all repetitions.
  Option* allow_extra_args(bool allow);
  Option* take_all();
  // It is an error to give this option without the other one, or together with it.
  Option* needs(const Option* other);
  Option* excludes(const Option* other);
  Option* excludes(const std::string& other);

 private:
  CLI::Option& option_;
};

// A command with its options. The program itself is a command, and the commands are its subcommands.
class Command {
 public:
  Command(const std::string& description, const std::string& name);
  ~Command();
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;

  // Adds a command, which this one owns.
  Command* add_subcommand(const std::string& name, const std::string& description);
  // `io_value` receives the option's value; its current value is the default. It must live until parse(). T
  // may be std::string, int, double, float, std::uint16_t, std::uint32_t, std::filesystem::path,
  // std::optional<int>, std::optional<double>, or a vector of strings or paths.
  template <typename T>
  Option* add_option(const std::string& name, T& io_value, const std::string& help);
  Option* add_flag(const std::string& name, bool& io_value, const std::string& help);
  // `read` receives the option's text and returns an error message, or an empty string.
  Option* add_text_option(const std::string& name, std::function<std::string(const std::string&)> read,
                          const std::string& help);
  // The same for a repeatable option: `read` receives the texts of all repetitions, in order.
  Option* add_text_list_option(const std::string& name,
                               std::function<std::string(const std::vector<std::string>&)> read,
                               const std::string& help);
  // Sets the text below the options in the help text.
  void footer(const std::string& text);
  // Adds an option that prints the version.
  void set_version_flag(const std::string& name, const std::string& version);
  // Requires exactly one subcommand. Options of the program may also follow the subcommand.
  void require_subcommand();

  // Result of parse(). Error messages are CLI11's.
  struct Parsed {
    // The command should run.
    bool ok = false;
    // --help or --version was given, and its text was printed.
    bool has_printed = false;
    // No subcommand was given.
    bool is_command_missing = false;
    // Empty if the command line is valid.
    std::string error;
  };
  // Parses the words after the program's name and stores the values of all options.
  Parsed parse(std::vector<std::string> words);

  const std::string& name() const;
  const std::deque<Command>& subcommands() const { return commands_; }
  bool has_option(const std::string& name) const;
  // After parse(): whether the command was given, and the words that no option accepted, of this command
  // alone or also of its subcommands.
  bool parsed() const;
  std::vector<std::string> remaining() const;
  std::vector<std::string> remaining_of_all_commands() const;

  // Only for add_subcommand(), which constructs in place.
  explicit Command(CLI::App& app);

 private:
  // Only in the program; CLI11 owns the subcommands.
  std::unique_ptr<CLI::App> program_;
  CLI::App& app_;
  // Containers that never move their elements, so that pointers to the elements stay valid.
  std::deque<Option> options_;
  std::deque<Command> commands_;
};

// Adds --basedir, --game, --set, and --show.
void add_common_options(Command& program, CommonOptions& io_options);
// Adds --size, --color, --fov, and --threads. The initial values of `io_options` are the defaults.
void add_frame_options(Command& command, FrameOptions& io_options);
// The same without --size, for a command that takes several sizes.
void add_frame_options_without_size(Command& command, FrameOptions& io_options);
// Adds --renderer, for commands that draw with either.
void add_renderer_option(Command& command, FrameOptions& io_options);

// Adds an option whose text `parse` converts to a T. `value` may also be a std::optional<T>.
template <typename T, typename Value>
Option* add_parsed_option(Command& command, const std::string& name, Value& value,
                          base::Result<T> (*parse)(std::string_view), const std::string& help) {
  return command.add_text_option(
      name,
      [&value, parse](const std::string& text) {
        const base::Result<T> parsed = parse(text);
        if (!parsed.ok()) return parsed.error().what;
        value = parsed.value();
        return std::string();
      },
      help);
}

// Adds a repeatable option. If it is given, its values replace those of `values`, which are the default.
template <typename T>
Option* add_parsed_list_option(Command& command, const std::string& name, std::vector<T>& values,
                               base::Result<T> (*parse)(std::string_view), const std::string& help) {
  const auto read = [&values, parse](const std::vector<std::string>& texts) {
    values.clear();
    for (const std::string& text : texts) {
      const base::Result<T> parsed = parse(text);
      if (!parsed.ok()) return parsed.error().what;
      values.push_back(parsed.value());
    }
    return std::string();
  };
  return command.add_text_list_option(name, read, help)->allow_extra_args(false)->take_all();
}

}  // namespace temblor::app
