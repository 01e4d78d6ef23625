// Feeds arbitrary bytes to the reader of compiled QuakeC. It must return an error, or a program that is
// written and read back unchanged. If its statements are valid, every function is disassembled and run
// twice: with a tracer, statement by statement, and without one. Both runs must end, stay inside their
// memory, and have the same results.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/check.h"
#include "formats/game/progs.h"
#include "fuzz/targets.h"
#include "vm/disassembly.h"
#include "vm/machine.h"

using namespace temblor;

namespace {

constexpr vm::Limits kLimits{.call_depth = 20,
                             .saved_words = 4096,
                             .instructions = 2000,
                             .string_bytes = 1 << 14,
                             .entities = 8,
                             .entity_bytes = 1 << 20,
                             .nested_calls = 4};
// The limits of the run of one file.
constexpr std::size_t kMaxFunctions = 16;

base::Status spawn(vm::Machine& io_machine) {
  TRY_STATUS(io_machine.set_entity_count(io_machine.entity_count() + 1));
  io_machine.return_entity(base::to_index<vm::EntityIndex>(io_machine.entity_count() - 1));
  return base::Ok{};
}

base::Status call_back(vm::Machine& io_machine) {
  return io_machine.call(io_machine.parameter_function(0));
}

base::Status concatenate(vm::Machine& io_machine) {
  std::string text;
  for (int i = 0; i < io_machine.parameter_count(); ++i) text += io_machine.parameter_text(i);
  io_machine.charge(text.size());
  TRY(const vm::StringIndex made, io_machine.make_string(text));
  io_machine.return_string(made);
  return base::Ok{};
}

base::Status zone_or_unzone(vm::Machine& io_machine) {
  if (io_machine.strings().unzone(io_machine.parameter_string(0))) return base::Ok{};
  TRY(const vm::StringIndex zoned, io_machine.strings().zone(io_machine.parameter_text(0)));
  io_machine.return_string(zoned);
  return base::Ok{};
}

base::Status read_field(vm::Machine& io_machine) {
  TRY(const vm::EntityIndex entity, io_machine.parameter_entity(0));
  TRY(const vm::FieldIndex field, io_machine.parameter_field(1));
  io_machine.return_vector(math::Vec3(static_cast<float>(io_machine.entity(entity)[base::to_size(field)])));
  return base::Ok{};
}

void prepare(vm::Machine& io_machine) {
  io_machine.add_builtin(1, "spawn", spawn);
  io_machine.add_builtin(2, "call_back", call_back);
  io_machine.add_builtin(3, "concatenate", concatenate);
  io_machine.add_builtin(4, "zone_or_unzone", zone_or_unzone);
  io_machine.add_builtin(5, "read_field", read_field);
  io_machine.add_named_builtin("spawn", spawn);
  if (io_machine.program().progs().entity_words >= 3)
    io_machine.set_state_fields(
        {vm::GlobalIndex{4}, vm::GlobalIndex{7}, vm::FieldIndex{0}, vm::FieldIndex{1}, vm::FieldIndex{2}});
}

// The state after a run, and its output.
struct Outcome {
  std::vector<std::string> errors;
  std::vector<std::uint32_t> globals;
  std::uint64_t instructions = 0;
  std::size_t strings = 0;
  bool operator==(const Outcome&) const = default;
};

Outcome run(const std::shared_ptr<const vm::Program>& program, bool is_traced) {
  vm::Machine machine(program, kLimits);
  prepare(machine);
  std::uint64_t lines = 0;
  if (is_traced) machine.set_tracer([&](std::string_view) { ++lines; });
  Outcome outcome;
  for (std::size_t i = 1; i < std::min(program->progs().functions.size(), kMaxFunctions); ++i) {
    machine.protect_world(i % 2 == 0);
    const base::Status status = machine.call(base::to_index<vm::FunctionIndex>(i));
    outcome.errors.push_back(status.ok() ? "" : status.error().what);
    CHECK(machine.current_trace().empty());
    machine.collect_strings();
  }
  const auto globals = std::as_const(machine).global_words();
  outcome.globals.assign(globals.begin(), globals.end());
  outcome.instructions = machine.instructions_run();
  outcome.strings = machine.strings().made_count();
  CHECK(machine.strings().made_bytes() <= kLimits.string_bytes);
  // A statement with long strings or many locals counts as several.
  CHECK(lines <= outcome.instructions, "{} lines, {} instructions", lines, outcome.instructions);
  return outcome;
}

}  // namespace

int temblor::fuzz::fuzz_progs(const std::uint8_t* data, std::size_t size) {
  auto progs = formats::read_progs(std::as_bytes(std::span(data, size)));
  if (!progs.ok()) return 0;
  const auto back = formats::read_progs(formats::write_progs(*progs));
  CHECK(back.ok(), "{}", back.error().message());
  CHECK(*back == *progs);
  const auto program = vm::Program::load(std::move(*progs));
  if (!program.ok()) return 0;
  for (std::size_t i = 1; i < (*program)->progs().functions.size() && i < kMaxFunctions; ++i)
    CHECK(!vm::disassemble(**program, base::to_index<vm::FunctionIndex>(i)).empty());
  const Outcome traced = run(*program, true), untraced = run(*program, false);
  CHECK(traced == untraced, "{} instructions and {}", traced.instructions, untraced.instructions);
  return 0;
}
