// The program: parses the command line and runs one command.
//
//   temblor [common options] COMMAND [options of the command]
//
// A command is a pair of functions in app/commands: add_*_command() describes its options, run_*() runs it.
// Errors end the program with one line on standard error; see app/files/diagnostics.h for the exit status.
#include <fmt/ranges.h>

#include <algorithm>
#include <span>

#include "app/commands/art_command.h"
#include "app/commands/bench_command.h"
#include "app/commands/command_line.h"
#include "app/commands/compile_command.h"
#include "app/commands/inspect_command.h"
#include "app/commands/lab_command.h"
#include "app/commands/legacy_arguments.h"
#include "app/commands/play_command.h"
#include "app/commands/render_command.h"
#include "app/commands/serve_command.h"
#include "app/commands/settings_command.h"
#include "app/files/diagnostics.h"
#include "app/files/game_defaults.h"
#include "app/stock_tools/stock_command.h"
#include "command/variables.h"
#include "host/host_variables.h"

namespace temblor::app {
namespace {

constexpr const char* kHelpFooter =
    R"(`temblor COMMAND --help` describes the options of a command. The options above work with every command.

`temblor qbsp`, `temblor vis`, and `temblor light` take the flags of ericw-tools.

Examples:
  temblor play
  temblor --basedir ~/quake play --map e1m1
  temblor --basedir ~/quake --game hipnotic bench --map hip1m1
  temblor --basedir ~/quake render --map start -o start.png
  temblor --show mips render -o mips.png)";

// The options of every command, which the parser fills in, and the commands themselves, to find the one that
// was given.
struct Commands {
  CommonOptions common;
  RenderOptions render;
  BenchOptions bench;
  InspectOptions inspect;
  CompileCommandOptions compile;
  PlayOptions play;
  ServeOptions serve;
  ArtOptions art;
  LabOptions lab;
  Command* render_command = nullptr;
  Command* bench_command = nullptr;
  Command* inspect_command = nullptr;
  Command* compile_command = nullptr;
  Command* play_command = nullptr;
  Command* serve_command = nullptr;
  Command* art_command = nullptr;
  Command* settings_command = nullptr;
  LabCommands lab_commands;
};

void describe_command_line(Command& program, Commands& io_commands) {
  program.footer(kHelpFooter);
  program.set_version_flag("--version", TEMBLOR_VERSION);
  program.require_subcommand();
  add_common_options(program, io_commands.common);
  io_commands.render_command = add_render_command(program, io_commands.render);
  io_commands.bench_command = add_bench_command(program, io_commands.bench);
  io_commands.inspect_command = add_inspect_command(program, io_commands.inspect);
  io_commands.compile_command = add_compile_command(program, io_commands.compile);
  io_commands.play_command = add_play_command(program, io_commands.play);
  io_commands.serve_command = add_serve_command(program, io_commands.serve);
  io_commands.art_command = add_art_command(program, io_commands.art);
  io_commands.lab_commands = add_lab_command(program, io_commands.lab);
  io_commands.settings_command = add_settings_command(program);
}

// Sets the console variables before the command reads them: `host::HostVariables` registers them,
// `apply_game_defaults` applies the game's default.cfg, and `apply_options` --set, --show, and --threads.
base::Status run(const Commands& commands) {
  command::Variables variables;
  const host::HostVariables settings(variables);
  if (commands.render_command->parsed()) {
    apply_game_defaults(commands.common.folders, variables);
    TRY_STATUS(apply_options(commands.common, commands.render.frame.threads, variables));
    return run_render(commands.render, commands.common.folders, settings);
  }
  if (commands.bench_command->parsed()) {
    apply_game_defaults(commands.common.folders, variables);
    TRY_STATUS(apply_options(commands.common, commands.bench.frame.threads, variables));
    return run_bench(commands.bench, commands.common.folders, settings.presentation(), settings.render());
  }
  if (commands.lab_commands.lab->parsed()) {
    apply_game_defaults(commands.common.folders, variables);
    TRY_STATUS(apply_options(commands.common, commands.lab.frame.threads, variables));
    return run_lab(commands.lab_commands, commands.lab, commands.common.folders, settings.presentation(),
                   settings.render());
  }
  TRY_STATUS(apply_options(commands.common, std::nullopt, variables));
  if (commands.inspect_command->parsed()) return run_inspect(commands.inspect);
  if (commands.compile_command->parsed()) return run_compile(commands.compile, commands.common.folders);
  if (commands.play_command->parsed()) return run_play(commands.play, commands.common, settings);
  if (commands.serve_command->parsed()) return run_serve(commands.serve, commands.common, settings.server());
  if (commands.art_command->parsed()) return run_art(commands.art);
  run_settings(variables);
  return base::Ok{};
}

// Returns the part before "=": "--map" for "--map=start".
std::string option_name(const std::string& word) {
  return word.substr(0, word.find('='));
}

std::vector<std::string> make_parser_words(const Command& program, std::span<const char* const> arguments) {
  std::vector<std::string> commands;
  for (const Command& command : program.subcommands()) commands.push_back(command.name());
  return convert_legacy_arguments(arguments, commands);
}

// Returns the names of all commands that have this option.
std::vector<std::string> find_commands_with(const Command& program, const std::string& option) {
  std::vector<std::string> names;
  for (const Command& command : program.subcommands())
    if (command.has_option(option)) names.push_back(command.name());
  return names;
}

// Returns the name of the command that was given; empty if there was none.
std::string find_used_command(const Command& program) {
  for (const Command& command : program.subcommands())
    if (command.parsed()) return command.name();
  return {};
}

// Explains an option that was given in the wrong place: which commands have it and where to write it. Empty
// if every option was accepted.
std::string describe_misplaced_option(const Command& program) {
  const std::vector<std::string> unknown = program.remaining_of_all_commands();
  const auto found = std::find_if(unknown.begin(), unknown.end(),
                                  [](const std::string& word) { return word.starts_with("--"); });
  if (found == unknown.end()) return {};
  const std::string option = option_name(*found);
  const std::vector<std::string> owners = find_commands_with(program, option);
  const std::string used = find_used_command(program);
  if (owners.empty())
    return used.empty() ? fmt::format("unknown command or option \"{}\"", option)
                        : fmt::format("{} has no option {}", used, option);
  if (std::find(owners.begin(), owners.end(), used) != owners.end())
    return fmt::format("{0} is an option of {1} and must follow it: `temblor {1} {0} ...`", option, used);
  if (!used.empty())
    return fmt::format("{} has no option {}; it belongs to {}", used, option, fmt::join(owners, ", "));
  // No command was given. Suggest the one that people most likely want.
  const bool is_played = std::find(owners.begin(), owners.end(), "play") != owners.end();
  return fmt::format("{} is an option of {} and must follow it: `temblor {} {} ...`", option,
                     fmt::join(owners, ", "), is_played ? "play" : owners.front(), option);
}

// Explains that a command, such as `lab`, needs one of its own commands. Empty if it has one.
std::string describe_missing_subcommand(const Command& program) {
  for (const Command& command : program.subcommands()) {
    if (!command.parsed() || command.subcommands().empty()) continue;
    std::vector<std::string> names;
    for (const Command& own : command.subcommands()) {
      if (own.parsed()) return {};
      names.push_back(own.name());
    }
    return fmt::format("{} must be followed by one of: {}", command.name(), fmt::join(names, ", "));
  }
  return {};
}

// Describes what is wrong with the command line. Replaces CLI11's message where that would mislead.
std::string describe_parse_error(const Command& program, const CommonOptions& options,
                                 const Command::Parsed& parsed) {
  // If the shell variable is empty in `--basedir $X play`, CLI11 takes the command for the directory.
  const std::string& folder = options.folders.base_folder;
  const auto is_folder = [&](const Command& command) { return command.name() == folder; };
  const bool has_no_command = find_used_command(program).empty();
  if (has_no_command && std::ranges::any_of(program.subcommands(), is_folder))
    return fmt::format("--basedir is followed by the command \"{}\" instead of a directory", folder);
  if (std::string misplaced = describe_misplaced_option(program); !misplaced.empty()) return misplaced;
  const std::vector<std::string> unknown = program.remaining();
  if (has_no_command && !unknown.empty())
    return fmt::format("unknown command or option \"{}\"", unknown.front());
  if (has_no_command && parsed.is_command_missing) return "no command given; `temblor play` starts the game";
  if (std::string missing = describe_missing_subcommand(program); !missing.empty()) return missing;
  return parsed.error;
}

int finish(const base::Status& status) {
  if (status.ok()) return kExitSuccess;
  print_error(status.error());
  return exit_status(status.error());
}

int run_program(std::string_view called_as, std::span<const char* const> arguments) {
  const base::Result<std::optional<StockCommand>> stock = parse_stock_command(called_as, arguments);
  if (!stock.ok()) return finish(stock.error());
  if (*stock) return finish(run_stock_command(**stock));
  Command program("Temblor, a Quake engine with a software renderer", "temblor");
  Commands commands;
  describe_command_line(program, commands);
  const Command::Parsed parsed = program.parse(make_parser_words(program, arguments));
  if (parsed.has_printed) return kExitSuccess;
  if (!parsed.ok) {
    print_error(
        base::Error{base::ErrorCode::kUsage, describe_parse_error(program, commands.common, parsed), {}});
    return kExitUsage;
  }
  return finish(run(commands));
}

}  // namespace
}  // namespace temblor::app

int main(int argument_count, char** arguments) {
  const std::span words(arguments, static_cast<std::size_t>(argument_count));
  return temblor::app::run_program(words.empty() ? "" : words.front(),
                                   words.subspan(std::min<std::size_t>(1, words.size())));
}
