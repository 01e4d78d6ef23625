// The console: text becomes commands, aliases and variables. An object: a program may have several, and they
// share nothing but the variables they are given.
//
// A command's first word is looked up, without regard to case, as a command, then as an alias, then as a
// variable ("NAME" prints it, "NAME VALUE" sets it); anything else gives one line that says so. What is wrong
// with a command of a file is told with the file's name and the line: "server.cfg:12: ...".
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "command/completion.h"
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
  // All that a command's argument may be, for completion: asked for when somebody wants to see it.
  using ArgumentList = std::function<std::vector<Candidate>()>;

  // Text that waits to be run; text that does not fit is refused whole, with a line that says so.
  static constexpr std::size_t kMaxPendingChars = std::size_t{1} << 20;
  // Aliases and files that one run() may open, and their characters: enough for any config, and an end to
  // those that call themselves.
  static constexpr int kMaxExpansions = 4096;
  static constexpr std::size_t kMaxExpandedChars = std::size_t{1} << 23;

  // `io_variables` must outlive the console.
  Console(Variables& io_variables, Output output);

  // CHECKs that there is no command of that name yet. `help`: one sentence.
  void add_command(std::string_view name, std::string_view help, Command command);
  // CHECKs that there is such a command.
  void set_argument_list(std::string_view command, ArgumentList list);
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

  // Prints what is wrong with the command that runs, with the place it has in a file. Commands from outside
  // tell their errors by it.
  void print_error(std::string_view line);
  // How many of them were with commands of files, so far.
  std::size_t errors_in_files() const { return errors_in_files_; }
  // Whether the command that runs is written in a file, and not typed.
  bool is_in_file() const { return !place_.file.empty(); }

  // Commands, aliases and variables whose names start so (without regard to case), sorted by name.
  std::vector<Candidate> candidates(std::string_view prefix) const;
  // The same, their names only.
  std::vector<std::string> complete(std::string_view prefix) const;
  // For a line that is typed as far as `line`: the last word of its last command, which is empty behind a
  // space. A command's first word may be any name; what comes behind depends on it: one of its argument list,
  // or a value of the variable.
  Completion complete_line(std::string_view line) const;

 private:
  struct RegisteredCommand {
    std::string help;
    Command run;
    ArgumentList arguments;  // may be null
  };
  // Where a command is written: in a file of that name; lines are counted from 1.
  struct Place {
    std::string file;  // empty: in no file
    std::size_t line = 1;
  };
  // A part of the pending text that an alias or a file expanded to; it begins where the part in front of it
  // ends, the first one at done_.
  struct Part {
    Place place;                 // of an alias: where it was called
    bool has_lines = false;      // of its own: a file
    std::size_t left_chars = 0;  // that were not run
  };
  // Which names a list is of.
  struct Kinds {
    bool commands = true, aliases = true, variables = true;
  };

  void add_built_in_commands();
  void add_variable_commands();
  void add_list_commands();
  using Member = void (Console::*)(Arguments);
  void add_member(std::string_view name, std::string_view help, Member member, Kinds arguments);
  std::vector<Candidate> candidates_of(Kinds kinds, std::string_view prefix) const;
  // For the word behind `words`, which are not none.
  void complete_argument(Arguments words, std::string_view prefix, Completion& io_completion) const;
  // Whether `text` may join what is pending; if not, says so.
  bool has_room_for(std::string_view text);
  void insert(std::string_view text, Part part);
  // The next pending command, and place_ with it.
  std::string take_command();
  // Whether another alias or file, of that text, may be opened; if not, says so and drops what is pending.
  bool may_expand(std::string_view name, std::string_view text);
  void print(std::string_view line) const { output_(line); }
  void print_if_error(const base::Status& status);

  void alias_command(Arguments arguments);
  void unalias_command(Arguments arguments);
  void unaliasall_command(Arguments arguments);
  void echo_command(Arguments arguments);
  void exec_command(Arguments arguments);
  void help_command(Arguments arguments);
  void list_command(Arguments arguments);
  void command_list_command(Arguments arguments);
  void variable_list_command(Arguments arguments);
  void apropos_command(Arguments arguments);
  void reset_command(Arguments arguments);
  void reset_all_command(Arguments arguments);
  void set_command(Arguments arguments);
  void toggle_command(Arguments arguments);
  void cycle_command(Arguments arguments);
  void inc_command(Arguments arguments);
  void variable_command(const Variable& variable, Arguments arguments);
  // Null, and says so, when there is none.
  const Variable* find_variable(std::string_view name);

  Variables& variables_;
  Output output_;
  Loader loader_;
  std::map<std::string, RegisteredCommand, std::less<>> commands_;  // by name in lower case
  std::map<std::string, std::string, std::less<>> aliases_;         // name in lower case to text
  std::string text_;  // pending commands, behind done_ characters that were run
  std::size_t done_ = 0;
  std::vector<Part> parts_;  // the first part last; what is behind them was appended
  Place place_;              // of the command that runs
  bool waiting_ = false;
  std::size_t errors_in_files_ = 0;
  int expansions_ = 0;  // since run() began
  std::size_t expanded_chars_ = 0;
};

}  // namespace temblor::command
