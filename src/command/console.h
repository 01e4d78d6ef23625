// The console interpreter: executes text as commands, aliases, and variables. Text comes from the player, key
// bindings, the command line, config files (exec), and game code (stuffcmd, localcmd). A program may have
// several consoles; they share only the variables that they are given.
//
// Text waits in one buffer until run(). An alias or file is expanded in place: its text is inserted before
// the rest, so that commands run in the order of the expanded text.
//
//   text_:   run already | alias text | rest of a file | appended text
//   parts_:              |  parts[2]  |    parts[1]    |   parts[0]
//            0 ......... done_
//
// The first word of a command is looked up, ignoring case, as a command, then an alias, then a variable
// ("NAME" prints it, "NAME VALUE" sets it). Errors of commands in files start with the file and line:
// "server.cfg:12: ...".
//
// Each part of the pending text has a Source. Aliases and files that the server's text expands, the text
// after its `wait`, and the aliases that it has defined are the server's, too.
#pragma once

#include <cstddef>
#include <cstdint>
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

// The origin of a command: the player (the keyboard, config files), or the server that the player is on.
enum class Source : std::uint8_t { kPlayer, kServer };

struct Alias {
  std::string text;
  Source source = Source::kPlayer;  // of the command that defined it
  bool operator==(const Alias&) const = default;
};
using Aliases = std::map<std::string, Alias, std::less<>>;  // by name in lower case

class Console {
 public:
  // Words of the command, starting with its name; valid during the call.
  using Arguments = std::span<const std::string>;
  using Command = std::function<void(Arguments)>;
  // Prints one line; no newline.
  using Output = std::function<void(std::string_view line)>;
  // Loads the text of a config file. The error explains to the player why there is none.
  using Loader = std::function<base::Result<std::string>(std::string_view name)>;
  // Lists the possible arguments of a command, for completion; called on demand.
  using ArgumentList = std::function<std::vector<Candidate>()>;

  // Limit of pending text. Text that does not fit is rejected as a whole, with an error line.
  static constexpr std::size_t kMaxPendingChars = std::size_t{1} << 20;
  // Limits of the aliases and files that one run() may expand, and of their characters. Enough for any
  // config, and they stop endless recursion.
  static constexpr int kMaxExpansions = 4096;
  static constexpr std::size_t kMaxExpandedChars = std::size_t{1} << 23;

  // Adds the built-in commands (alias, exec, set, help, ...). `io_variables` must outlive the console.
  Console(Variables& io_variables, Output output);

  // Adds a command. CHECKs that the name is new. `help`: one sentence, which the `help` command prints.
  void add_command(std::string_view name, std::string_view help, Command command);
  // CHECKs that there is such a command.
  void set_argument_list(std::string_view command, ArgumentList list);
  // Called with a command whose name is unknown; returns whether it has handled the command. Otherwise, and
  // without a handler, the console prints an error.
  using UnknownName = std::function<bool(Arguments)>;
  void set_unknown_handler(UnknownName handler) { unknown_handler_ = std::move(handler); }
  // Called by `set` with NAME VALUE, for a name that is unknown; returns whether it stands for something else
  // than a new variable.
  void set_foreign_setter(UnknownName setter) { foreign_setter_ = std::move(setter); }
  // Without a loader, `exec` reports that there are no files.
  void set_loader(Loader loader) { loader_ = std::move(loader); }

  // Appends commands and a newline to the pending text, for the next run(). Without a source, they have that
  // of the running command.
  void append(std::string_view text) { append(text, place_.source); }
  void append(std::string_view text, Source source);
  // How run() treats commands of Source::kServer. Without it, like those of the player.
  struct ServerRules {
    std::function<bool(Arguments)> may_run;  // called before each of them; false: the command is dropped
    std::function<void()> finish;            // called after the last of several in a row
  };
  void set_server_rules(ServerRules rules) { server_rules_ = std::move(rules); }
  // Runs pending commands until none remain, or until `wait` defers the rest to the next run(). Commands may
  // call append() and execute(), but not run().
  void run();
  // Returns whether commands wait for run(), for example after `wait`.
  bool has_pending() const { return done_ < text_.size(); }

  // Drops what is left of the pending text of Source::kServer.
  void drop_server_text();

  // Runs one command now, before the pending text. If it is an alias or `exec`, its expansion is only
  // inserted before the pending text, and runs with run().
  void execute(std::string_view command);

  // Prints an error of the running command, with its file and line. Registered commands use this too.
  void print_error(std::string_view line);
  // Number of errors so far in commands of a file.
  std::size_t errors_in_file(std::string_view file) const;
  // Returns whether the running command comes from a file.
  bool is_in_file() const { return !place_.file.empty(); }
  // The file of the running command; empty: none.
  const std::string& file() const { return place_.file; }

  const Aliases& aliases() const { return aliases_; }
  // Returns null if there is no such alias.
  const Alias* find_alias(std::string_view name) const;
  // Sets an alias; without a text, removes it.
  void set_alias(std::string_view name, Alias alias);

  // Finds commands, aliases, and variables with this prefix (ignoring case), sorted by name.
  std::vector<Candidate> candidates(std::string_view prefix) const;
  // Like candidates(), but only the names, without duplicates.
  std::vector<std::string> complete(std::string_view prefix) const;
  // Completes the last word of the last command in `line`; the word is empty after a space. The first word of
  // a command may be any name; later words are from the argument list of the command, or values of the
  // variable.
  Completion complete_line(std::string_view line) const;

 private:
  struct RegisteredCommand {
    std::string help;
    Command run;
    ArgumentList arguments;  // may be null
  };
  // The source of a command, for error messages: a file and a line, counted from 1.
  struct Place {
    std::string file{};  // empty: typed, bound to a key, or sent by the server
    std::size_t line = 1;
    Source source = Source::kPlayer;
  };
  // A part of the pending text, with one place and source. Parts follow one another from done_ to the end. An
  // alias that interrupts a file is a part of its own, in front of the rest of the file.
  struct Part {
    Place place;                 // of its next command; an alias has the place of its call
    bool has_lines = false;      // true for a file, whose commands advance the line
    std::size_t left_chars = 0;  // characters that were not run yet
  };
  // The kinds of names that a search includes.
  struct Kinds {
    bool commands = true, aliases = true, variables = true;
  };

  void add_built_in_commands();
  void add_variable_commands();
  void add_list_commands();
  // Registers a member function as a command whose first argument completes to these kinds of names.
  using Member = void (Console::*)(Arguments);
  void add_member(std::string_view name, std::string_view help, Member member, Kinds arguments);
  std::vector<Candidate> find_candidates(Kinds kinds, std::string_view prefix) const;
  // Completes the word after `words`, which must not be empty.
  void complete_argument(Arguments words, std::string_view prefix, Completion& io_completion) const;
  // Returns whether `text` and a newline fit into the pending text; prints an error if not.
  bool check_room_for(std::string_view text);
  // Inserts an expansion before the pending text. Fills in part.left_chars.
  void insert(std::string_view text, Part part);
  // Removes and returns the next pending command, and updates place_.
  std::string take_command();
  // Ends a row of the server's commands, if one runs.
  void finish_server_commands();
  // Counts the expansion of an alias or file. Returns false above the limits of one run(); then it has
  // printed an error and dropped the pending text.
  bool count_expansion(std::string_view name, std::string_view text);
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
  // Prints an error and returns null if there is no such variable.
  const Variable* find_variable(std::string_view name);

  Variables& variables_;
  Output output_;
  Loader loader_;
  UnknownName unknown_handler_;
  UnknownName foreign_setter_;
  std::map<std::string, RegisteredCommand, std::less<>> commands_;  // by name in lower case
  Aliases aliases_;
  // Pending commands, after done_ characters that were run.
  std::string text_;
  std::size_t done_ = 0;
  // Parts of the pending text; the last element comes first in it.
  std::vector<Part> parts_;
  Place place_;  // of the running command
  ServerRules server_rules_;
  bool runs_server_commands_ = false;
  bool waiting_ = false;  // `wait` was run: stop until the next run()
  std::map<std::string, std::size_t, std::less<>> errors_in_files_;
  int expansions_ = 0;  // since the start of run()
  std::size_t expanded_chars_ = 0;
};

}  // namespace temblor::command
