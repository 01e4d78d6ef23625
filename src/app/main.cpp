// The program: reads the command line and runs one command.
#include <fmt/ranges.h>

#include <algorithm>
#include <span>

#include "app/commands/art_command.h"
#include "app/commands/bench_command.h"
#include "app/commands/command_line.h"
#include "app/commands/compile_command.h"
#include "app/commands/inspect_command.h"
#include "app/commands/legacy_arguments.h"
#include "app/commands/play_command.h"
#include "app/commands/render_command.h"
#include "app/commands/serve_command.h"
#include "app/commands/settings_command.h"
#include "app/files/diagnostics.h"
#include "command/variables.h"
#include "host/host_variables.h"

namespace temblor::app {
namespace {

constexpr const char* kHelpFooter =
    R"(temblor COMMAND --help says more about a command.

Examples:
  temblor --basedir quake play
  temblor --basedir quake render --map start -o start.png
  temblor --basedir quake --game hipnotic bench --map hip1m1
  temblor --set r_mip_rule=stock --show mips render -o mips.png
  temblor settings)";

struct Commands {
  CommonOptions common;
  RenderOptions render;
  BenchOptions bench;
  InspectOptions inspect;
  CompileCommandOptions compile;
  PlayOptions play;
  ServeOptions serve;
  ArtOptions art;
  Command* render_command = nullptr;
  Command* bench_command = nullptr;
  Command* inspect_command = nullptr;
  Command* compile_command = nullptr;
  Command* play_command = nullptr;
  Command* serve_command = nullptr;
  Command* art_command = nullptr;
  Command* settings_command = nullptr;
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
  io_commands.settings_command = add_settings_command(program);
}

base::Status run(const Commands& commands) {
  command::Variables variables;
  const host::HostVariables settings(variables);
  if (commands.render_command->parsed()) {
    TRY_STATUS(apply_options(commands.common, commands.render.frame.threads, variables));
    return run_render(commands.render, commands.common.folders, settings.presentation(), settings.render());
  }
  if (commands.bench_command->parsed()) {
    TRY_STATUS(apply_options(commands.common, commands.bench.frame.threads, variables));
    return run_bench(commands.bench, commands.common.folders, settings.presentation(), settings.render());
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

// "--map" of "--map=start".
std::string option_name(const std::string& word) {
  return word.substr(0, word.find('='));
}

std::vector<std::string> words_for_parser(const Command& program, std::span<const char* const> arguments) {
  std::vector<std::string> commands;
  for (const Command& command : program.subcommands()) commands.push_back(command.name());
  return from_legacy_arguments(arguments, commands);
}

std::vector<std::string> commands_with(const Command& program, const std::string& option) {
  std::vector<std::string> names;
  for (const Command& command : program.subcommands())
    if (command.has_option(option)) names.push_back(command.name());
  return names;
}

// The name of the command that was given; empty if there was none.
std::string used_command(const Command& program) {
  for (const Command& command : program.subcommands())
    if (command.parsed()) return command.name();
  return {};
}

// An option that stands where nobody takes it: whose it is, and where it belongs. Empty: there is none.
std::string describe_misplaced_option(const Command& program) {
  const std::vector<std::string> unknown = program.remaining_of_all_commands();
  const auto found = std::find_if(unknown.begin(), unknown.end(),
                                  [](const std::string& word) { return word.starts_with("--"); });
  if (found == unknown.end()) return {};
  const std::string option = option_name(*found);
  const std::vector<std::string> owners = commands_with(program, option);
  const std::string used = used_command(program);
  if (owners.empty())
    return used.empty() ? fmt::format("there is no command or option \"{}\"", option)
                        : fmt::format("{} has no option {}", used, option);
  if (std::find(owners.begin(), owners.end(), used) != owners.end())
    return fmt::format("{0} is an option of {1} and belongs behind it: `temblor {1} {0} ...`", option, used);
  if (!used.empty())
    return fmt::format("{} has no option {}: it is one of {}", used, option, fmt::join(owners, ", "));
  const bool is_played = std::find(owners.begin(), owners.end(), "play") != owners.end();
  return fmt::format("{} is an option of {} and belongs behind that: `temblor {} {} ...`", option,
                     fmt::join(owners, ", "), is_played ? "play" : owners.front(), option);
}

// What is wrong with the command line, in our words where CLI11's would mislead.
std::string describe_parse_error(const Command& program, const CommonOptions& options,
                                 const Command::Parsed& parsed) {
  // A shell variable that is empty leaves --basedir without its folder, and the command is taken for it.
  const std::string& folder = options.folders.base_folder;
  const auto is_folder = [&](const Command& command) { return command.name() == folder; };
  const bool has_no_command = used_command(program).empty();
  if (has_no_command && std::ranges::any_of(program.subcommands(), is_folder))
    return fmt::format("--basedir is followed by the command \"{}\" where the folder should be", folder);
  if (std::string misplaced = describe_misplaced_option(program); !misplaced.empty()) return misplaced;
  const std::vector<std::string> unknown = program.remaining();
  if (has_no_command && !unknown.empty())
    return fmt::format("there is no command or option \"{}\"", unknown.front());
  if (has_no_command && parsed.is_command_missing)
    return "a command is missing: `temblor play` begins the game";
  return parsed.error;
}

int run_program(std::span<const char* const> arguments) {
  Command program("Temblor: draws and plays Quake-class levels without a GPU", "temblor");
  Commands commands;
  describe_command_line(program, commands);
  const Command::Parsed parsed = program.parse(words_for_parser(program, arguments));
  if (parsed.has_printed) return kExitSuccess;
  if (!parsed.ok) {
    print_error(
        base::Error{base::ErrorCode::kUsage, describe_parse_error(program, commands.common, parsed), {}});
    return kExitUsage;
  }
  const base::Status status = run(commands);
  if (status.ok()) return kExitSuccess;
  print_error(status.error());
  return exit_status(status.error());
}

}  // namespace
}  // namespace temblor::app

int main(int argument_count, char** arguments) {
  const std::span words(arguments, static_cast<std::size_t>(argument_count));
  return temblor::app::run_program(words.subspan(std::min<std::size_t>(1, words.size())));
}
