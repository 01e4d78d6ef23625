// Built-in functions for debugging of game code: print state, trace statements, and stop on purpose.
#include "base/text.h"
#include "server/builtins/families.h"
#include "server/builtins/text/entity_text.h"

namespace temblor::server {
namespace {

// The length limit of an error's text; longer texts are truncated.
constexpr std::size_t kMaxErrorChars = 200;

std::string describe(Call& io_call, vm::EntityIndex entity) {
  return describe_entity(io_call.world.edicts, io_call.machine, entity);
}

// The caller's name, for a line of output.
std::string caller(Call& io_call) {
  const std::vector<vm::TraceEntry> trace = io_call.machine.current_trace();
  return trace.empty() ? "?" : std::string(io_call.machine.program().function_name(trace[0].function));
}

// The text of an error, as one line.
std::string one_line(std::string_view text) {
  while (text.ends_with('\n') || text.ends_with(' ')) text.remove_suffix(1);
  return base::quotable(text, kMaxErrorChars);
}

// The original enters its debugger here.
base::Status break_here(Call& io_call) {
  return io_call.error("the program stops here");
}

// error(text, ...): prints the text and `self`, and ends the game.
base::Status error(Call& io_call) {
  const std::string text = io_call.joined_text(0);
  io_call.print(fmt::format("{}: {}\n{}", caller(io_call), text, describe(io_call, io_call.self())));
  return io_call.error("{}", one_line(text));
}

// objerror(): removes `self`, and the level continues. The original's documentation says so, but its code
// ends the game.
base::Status objerror(Call& io_call) {
  const std::string text = io_call.joined_text(0);
  const vm::EntityIndex self = io_call.self();
  io_call.print(fmt::format("{}: {}\n{}", caller(io_call), text, describe(io_call, self)));
  if (self == vm::kWorld || io_call.is_player(self))
    return io_call.error("{} (entity {} cannot be removed)", one_line(text), base::to_size(self));
  if (!io_call.world.edicts.is_free(self)) remove(io_call.world, self);
  return base::Ok{};
}

// coredump(): prints all entities.
base::Status coredump(Call& io_call) {
  for (std::size_t i = 0; i < io_call.world.edicts.count(); ++i)
    io_call.print(describe(io_call, base::to_index<vm::EntityIndex>(i)));
  return base::Ok{};
}

base::Status eprint(Call& io_call) {
  TRY(const vm::EntityIndex entity, io_call.entity(0));
  io_call.print(describe(io_call, entity));
  return base::Ok{};
}

// traceon(): prints each statement that runs from now on, until traceoff().
base::Status traceon(Call& io_call) {
  if (!io_call.context.print) return base::Ok{};
  io_call.machine.set_tracer([&context = io_call.context](std::string_view line) {
    if (context.print) context.print(fmt::format("{}\n", line));
  });
  return base::Ok{};
}

base::Status traceoff(Call& io_call) {
  io_call.machine.set_tracer(nullptr);
  return base::Ok{};
}

}  // namespace

std::span<const BuiltinEntry> debugging_builtins() {
  static constexpr BuiltinEntry kEntries[] = {
      {6, "break", break_here},   {10, "error", error},     {11, "objerror", objerror},
      {28, "coredump", coredump}, {29, "traceon", traceon}, {30, "traceoff", traceoff},
      {31, "eprint", eprint},
  };
  return kEntries;
}

}  // namespace temblor::server
