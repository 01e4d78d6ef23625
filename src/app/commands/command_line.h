// Options and commands of the command line. The classes describe them with the functions of CLI11, which
// reads them; only command_line.cpp includes CLI11, which takes seconds to compile.
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

// A condition on an option's value. The message of an error names the range.
using Condition = std::shared_ptr<const CLI::Validator>;
Condition in_range(int min, int max);
Condition in_range(double min, double max);
Condition one_of(std::vector<int> values);
Condition not_negative();

// An option of a command, owned by it. The functions return the option, so that calls can be chained.
class Option {
 public:
  explicit Option(CLI::Option& option) : option_(option) {}

  Option* type_name(const std::string& name);
  // The default in the help text: the one given, or the variable's initial value.
  Option* default_str(const std::string& text);
  Option* capture_default_str();
  Option* required();
  Option* check(const Condition& condition);
  // `condition` returns an error message, or nothing for a good value.
  Option* check(std::string (*condition)(const std::string&));
  // For options that may be repeated: a word after the value is not a second value, and every value is kept.
  Option* allow_extra_args(bool allow);
  Option* take_all();
  Option* needs(const Option* other);
  Option* excludes(const Option* other);
  Option* excludes(const std::string& other);

 private:
  CLI::Option& option_;
};

// A command with its options, or the program itself, whose sub-commands are the commands.
class Command {
 public:
  Command(const std::string& description, const std::string& name);
  ~Command();
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;

  // The command stays owned by this one.
  Command* add_subcommand(const std::string& name, const std::string& description);
  // `io_value` receives the option's value; what it holds now is the default. T: std::string, int, double,
  // float, std::uint16_t, std::uint32_t, std::filesystem::path, std::optional<int>, or a vector of strings or
  // paths.
  template <typename T>
  Option* add_option(const std::string& name, T& io_value, const std::string& help);
  Option* add_flag(const std::string& name, bool& io_value, const std::string& help);
  // `read` takes the option's text and returns an error message, or nothing.
  Option* add_text_option(const std::string& name, std::function<std::string(const std::string&)> read,
                          const std::string& help);
  void footer(const std::string& text);
  void set_version_flag(const std::string& name, const std::string& version);
  // One sub-command must be given, and options of the program may also follow it.
  void require_subcommand();

  // Reads the words. An error's message is CLI11's.
  struct Parsed {
    bool ok = false;                  // the command is to be run
    bool has_printed = false;         // --help or --version, whose text was printed
    bool is_command_missing = false;  // no sub-command was given
    std::string error;                // empty unless the words are wrong
  };
  Parsed parse(std::vector<std::string> words);

  const std::string& name() const;
  const std::deque<Command>& subcommands() const { return commands_; }
  bool has_option(const std::string& name) const;
  // After parse(): whether the command was given; the words that no option took, in the program or also in
  // its commands.
  bool parsed() const;
  std::vector<std::string> remaining() const;
  std::vector<std::string> remaining_of_all_commands() const;

  explicit Command(CLI::App& app);  // for add_subcommand

 private:
  std::unique_ptr<CLI::App> program_;  // empty in a sub-command
  CLI::App& app_;
  std::deque<Option> options_;
  std::deque<Command> commands_;
};

void add_common_options(Command& program, CommonOptions& io_options);
// The initial values of `io_options` are the defaults.
void add_frame_options(Command& command, FrameOptions& io_options);

// Adds an option that `parse` reads. `value` may also be a std::optional<T>.
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

}  // namespace temblor::app
