// The list of all built-in functions of HUD programs.
#include "client/hud_program/program_call.h"

namespace temblor::client {

void add_program_builtins(vm::Machine& io_machine, ProgramContext& io_program) {
  constexpr std::span<const ProgramEntry> (*kFamilies[])() = {
      program_drawing, program_text_drawing, program_state,  program_view,
      program_console, program_entities,     program_ignored};
  builtins::add_builtins(io_machine, io_program.shared);
  for (const auto family : kFamilies)
    for (const ProgramEntry& entry : family()) {
      const auto run = [&io_program, &entry](vm::Machine& io_running) {
        ProgramCall call(io_program, io_running, entry.name);
        return entry.function(call);
      };
      if (entry.number > 0) io_machine.add_builtin(entry.number, fmt::format("builtin {}", entry.name), run);
      io_machine.add_named_builtin(entry.name, run);
    }
}

}  // namespace temblor::client
