// Built-in functions for the console: prints, commands, keys, extensions, and errors.
#include <algorithm>

#include "base/text.h"
#include "client/hud_program/program_call.h"
#include "client/input/key_names.h"

namespace temblor::client {
namespace {

constexpr std::string_view kProgramExtensions[] = {"EXT_CSQC", "EXT_CSQC_1"};

base::Status print(ProgramCall& io_call) {
  io_call.print(io_call.joined_text(0));
  return base::Ok{};
}
base::Status dprint(ProgramCall& io_call) {
  if (io_call.variable("developer") != 0) io_call.print(io_call.joined_text(0));
  return base::Ok{};
}

// error() ends the program; objerror() too, as it has no entity that matters.
base::Status error(ProgramCall& io_call) {
  return io_call.error("{}", base::quotable(io_call.joined_text(0), 200));
}

// registercommand(name): CSQC_ConsoleCommand gets it, unless the engine has a command of that name.
base::Status registercommand(ProgramCall& io_call) {
  const std::string name = base::to_lower(io_call.text(0));
  auto& commands = io_call.program.commands;
  if (name.empty() || name.size() > command::Variables::kMaxUserMadeChars ||
      commands.size() >= ProgramContext::kMaxCommands)
    return io_call.error("\"{}\" cannot be registered", base::quotable(name));
  commands.insert(name);
  return base::Ok{};
}

// checkcommand(name): 1 for a command, 2 for an alias, 3 for a variable in other engines.
base::Status checkcommand(ProgramCall& io_call) {
  const std::string_view name = io_call.text(0);
  if (io_call.program.commands.contains(base::to_lower(name))) return io_call.return_number(1);
  if (io_call.program.services.variables.find(name) != nullptr) return io_call.return_number(3);
  const auto& has_command = io_call.program.services.has_command;
  return io_call.return_number(has_command && has_command(name) ? 1 : 0);
}

// localcmd(text, ...): runs console lines after the program has returned. Those that it got from the server
// may do no more than without the program.
base::Status localcmd(ProgramCall& io_call) {
  const std::string text = io_call.joined_text(0);
  if (text.size() > ProgramContext::kMaxCommandBytes)
    return io_call.error("more than {} bytes of commands", ProgramContext::kMaxCommandBytes);
  io_call.machine.charge(text.size() * 16);
  const HudProgramServices& services = io_call.program.services;
  const auto& run = io_call.program.runs_stuffed ? services.run_stuffed : services.run_commands;
  if (run) run(text);
  return base::Ok{};
}

base::Status localsound(ProgramCall& io_call) {
  if (io_call.program.services.play_sound) io_call.program.services.play_sound(io_call.text(0));
  return base::Ok{};
}

base::Status checkextension(ProgramCall& io_call) {
  const std::string_view name = io_call.text(0);
  const bool is_own =
      std::any_of(std::begin(kProgramExtensions), std::end(kProgramExtensions),
                  [&](std::string_view known) { return base::equal_ignoring_case(name, known); });
  return io_call.return_number(is_own || builtins::has_extension(io_call.program.shared, name) ? 1 : 0);
}

// keynumtostring(key), stringtokeynum(name), and getkeybind(key)
base::Status keynumtostring(ProgramCall& io_call) {
  return io_call.return_text(key_name(key_of_program(io_call.whole(0))));
}
base::Status stringtokeynum(ProgramCall& io_call) {
  const std::optional<platform::Key> key = find_key(io_call.text(0));
  return io_call.return_number(key ? program_key(*key) : -1);
}
base::Status getkeybind(ProgramCall& io_call) {
  const auto& binding = io_call.program.services.binding;
  const platform::Key key = key_of_program(io_call.whole(0));
  return io_call.return_text(binding && key != platform::Key::kNone ? binding(key) : "");
}

// findkeysforcommand(command): two keys in quotes, "'119' '-1'"; -1: none.
base::Status findkeysforcommand(ProgramCall& io_call) {
  constexpr int kLastKey = 1024;
  const std::string command(io_call.text(0));
  std::vector<int> keys;
  if (const auto& binding = io_call.program.services.binding)
    for (int number = 1; number < kLastKey && keys.size() < 2; ++number)
      if (const platform::Key key = key_of_program(number);
          key != platform::Key::kNone && binding(key) == command)
        keys.push_back(number);
  keys.resize(2, -1);
  return io_call.return_text(fmt::format("'{}' '{}'", keys[0], keys[1]));
}

// setcursormode(on): from now on the mouse moves a cursor, and no longer the view.
base::Status setcursormode(ProgramCall& io_call) {
  ProgramContext& program = io_call.program;
  const bool is_on = io_call.number(0) != 0;
  if (is_on && !program.cursor) program.cursor = program.canvas.virtual_size() * 0.5f;
  if (!is_on) program.cursor.reset();
  return base::Ok{};
}
// getmousepos(): the cursor's place, in virtual pixels.
base::Status getmousepos(ProgramCall& io_call) {
  io_call.machine.return_vector(math::Vec3(io_call.program.cursor.value_or(math::Vec2(0.0f)), 0));
  return base::Ok{};
}

}  // namespace

std::span<const ProgramEntry> program_console() {
  static constexpr ProgramEntry kEntries[] = {
      {10, "error", error},
      {11, "objerror", error},
      {25, "dprint", dprint},
      {46, "localcmd", localcmd},
      {99, "checkextension", checkextension},
      {177, "localsound", localsound},
      {294, "checkcommand", checkcommand},
      {338, "cprint", print},
      {339, "print", print},
      {340, "keynumtostring", keynumtostring},
      {520, "keynumtostring_omgwtf", keynumtostring},
      {341, "stringtokeynum", stringtokeynum},
      {342, "getkeybind", getkeybind},
      {343, "setcursormode", setcursormode},
      {344, "getmousepos", getmousepos},
      {352, "registercommand", registercommand},
      {521, "findkeysforcommand", findkeysforcommand},
  };
  return kEntries;
}

}  // namespace temblor::client
