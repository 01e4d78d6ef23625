// The console: text becomes commands, aliases and variables. An object: a program may have several, and they
// share nothing but the variables they are given.
//
// A command's first word is looked up, without regard to case, as a command, then as an alias, then as a
// variable ("NAME" prints it, "NAME VALUE" sets it); anything else gives one line that says so.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"
#include "command/variables.h"

namespace temblor::command {

class Console {
 public:
  // The command's words, its name first; valid during the call.
  using Arguments = std::span<const std::string>;
  using Command = std::function<void(Arguments)>;
  // One line for the person, without a newline.
  using Output = std::function<void(std::string_view line)>;
  // The text of a file of commands.
  using Loader = std::function<base::Result<std::string>(std::string_view name)>;

  // Text that waits to be run; text that does not fit is refused whole, with a line that says so.
  static constexpr std::size_t kMaxPendingChars = std::size_t{1} << 20;
  // Aliases and files that one run() may open: enough for any config, and an end to those that call
  // themselves.
  static constexpr int kMaxExpansions = 4096;

  // `io_variables` must outlive the console.
  Console(Variables& io_variables, Output output);

  // CHECKs that there is no command of that name yet. `help`: one sentence.
  void add_command(std::string_view name, std::string_view help, Command command);
  // Without a loader, `exec` says that there are no files.
  void set_loader(Loader loader) { loader_ = std::move(loader); }

  // Adds commands behind all that are pending; a newline is added behind the text.
  void append(std::string_view text);
  // Runs pending commands until none are left or `wait` puts the rest off to the next run(). A command may
  // append() and call execute(), but not run().
  void run();
  bool has_pending() const { return done_ < text_.size(); }

  // Runs one command now, before anything pending. What an alias or file expands to is put in front of the
  // pending text.
  void execute(std::string_view command);

  // Names of commands, aliases and variables that start so (without regard to case), sorted: for completion.
  std::vector<std::string> complete(std::string_view prefix) const;

 private:
  struct RegisteredCommand {
    std::string help;
    Command run;
  };

  void add_built_in_commands();
  // Whether `text` may join what is pending; if not, says so.
  bool has_room_for(std::string_view text) const;
  void insert(std::string_view text);
  // Whether another alias or file may be opened; if not, says so and drops what is pending.
  bool may_expand(std::string_view name);
  void print(std::string_view line) const { output_(line); }
  void print_if_error(const base::Status& status) const;

  void alias_command(Arguments arguments);
  void unalias_command(Arguments arguments);
  void echo_command(Arguments arguments);
  void exec_command(Arguments arguments);
  void help_command(Arguments arguments);
  void list_command(Arguments arguments);
  void reset_command(Arguments arguments);
  void set_command(Arguments arguments);
  void toggle_command(Arguments arguments);
  void variable_command(const Variable& variable, Arguments arguments);

  Variables& variables_;
  Output output_;
  Loader loader_;
  std::map<std::string, RegisteredCommand, std::less<>> commands_;  // by name in lower case
  std::map<std::string, std::string, std::less<>> aliases_;         // name in lower case to text
  std::string text_;  // pending commands, behind done_ characters that were run
  std::size_t done_ = 0;
  bool waiting_ = false;
  int expansions_ = 0;  // since run() began
};

}  // namespace temblor::command
