// The QuakeC machine: runs one program over its globals, entities and strings. Knows nothing of Quake: what a
// built-in function does, and which fields there are, is told to it. Two machines share nothing but their
// program.
//
// Whatever the program does, it stays inside: string, entity, field and function values are checked at every
// access, and what runs away (deep recursion, an endless loop, memory) is ended with an error that the caller
// gets. The machine can be called again afterwards.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "math/vec.h"
#include "vm/code/strings.h"
#include "vm/program.h"

namespace temblor::vm {

struct Limits {
  int call_depth = 1024;              // the original's: 32
  std::size_t saved_words = 1 << 18;  // of all functions that wait for one they called; 2048
  // Of one call from outside, with all that it calls; 100000. A comparison of long strings, or a call of a
  // function with many locals, counts as several.
  std::uint64_t instructions = 10'000'000;
  std::size_t string_bytes = 64 << 20;  // of strings made while running
  std::uint32_t entities = 32000;
  std::size_t entity_bytes = 256 << 20;  // of all of them
  int nested_calls = 32;                 // of built-in functions that call the machine that calls them
};

// Where a program stood when it failed, or stands: the innermost function first.
struct TraceEntry {
  FunctionIndex function = kNoFunction;
  std::size_t statement = 0;  // 0 for a built-in function
};

// What operation 60, STATE, means: self.next_think = time + 0.1, self.frame and self.think as given.
struct StateFields {
  GlobalIndex self{}, time{};
  FieldIndex next_think{}, frame{}, think{};
};

struct FunctionProfile {
  FunctionIndex function = kNoFunction;
  std::uint64_t calls = 0;
  std::uint64_t instructions = 0;  // its own, without those of functions that it called
};

class Machine {
 public:
  // Reads its parameters from the machine and leaves its result there. May call back into the machine.
  using Builtin = std::function<base::Status(Machine& io_machine)>;

  static constexpr int kMaxParameters = 8;

  explicit Machine(std::shared_ptr<const Program> program, Limits limits = {});

  const Program& program() const { return *program_; }

  // `number` 1 and up. Calling a number that nobody added is an error that names it. Not while running.
  void add_builtin(int number, std::string name, Builtin builtin);
  // For functions that a program declares with number 0: known by their own name.
  void add_named_builtin(std::string name, Builtin builtin);
  // CHECKs that they are the program's. Without them operation 60 is an error.
  void set_state_fields(const StateFields& fields);
  // While set, a program may not write into entity 0.
  void protect_world(bool is_protected) { world_is_protected_ = is_protected; }

  // Runs a function until it returns. Its parameters were set before; its result is in returned_*(). An
  // error says what went wrong, in which function, file and statement; failure_trace() has the rest.
  // kNoFunction is an error. From within a built-in function, depth, memory and instructions are counted
  // together with those of the call that it is part of, and parameters and result are overwritten, as in the
  // original: read them before.
  base::Status call(FunctionIndex function);
  // Of the last call that failed.
  std::span<const TraceEntry> failure_trace() const { return failure_trace_; }
  // "  FUNCTION (FILE:LINE), statement N": one line each.
  std::string describe(std::span<const TraceEntry> trace) const;
  // From within a built-in function: who called it.
  std::vector<TraceEntry> current_trace() const;
  // From within a built-in function that does more than a little work, which grows with what it is given: as
  // many instructions as that is worth are taken from the call's budget.
  void charge(std::uint64_t instructions);
  // traceon: every statement goes to `output` in words before it is run; null: none (again fast).
  void set_tracer(std::function<void(std::string_view line)> output) { tracer_ = std::move(output); }

  // --- Globals. CHECKs that the index is inside.
  std::span<std::uint32_t> global_words() { return std::span(globals_).first(globals_.size() - kSpareWords); }
  std::span<const std::uint32_t> global_words() const {
    return std::span(globals_).first(globals_.size() - kSpareWords);
  }
  float global_float(GlobalIndex index) const;
  math::Vec3 global_vector(GlobalIndex index) const;
  EntityIndex global_entity(GlobalIndex index) const;  // kWorld for a value that is no entity
  StringIndex global_string(GlobalIndex index) const;
  FunctionIndex global_function(GlobalIndex index) const;
  void set_global_float(GlobalIndex index, float value);
  void set_global_vector(GlobalIndex index, const math::Vec3& value);
  void set_global_entity(GlobalIndex index, EntityIndex value);
  void set_global_string(GlobalIndex index, StringIndex value);
  void set_global_function(GlobalIndex index, FunctionIndex value);

  // --- Parameters of the running built-in function, or of the call to come; 0 to 7.
  int parameter_count() const { return parameter_count_; }
  float parameter_float(int i) const;
  math::Vec3 parameter_vector(int i) const;
  // Nothing for a value that is no string; the call of the built-in function then ends with an error. Valid
  // until the string goes.
  std::string_view parameter_text(int i);
  StringIndex parameter_string(int i) const;
  FunctionIndex parameter_function(int i) const;
  // An error for a value that is no entity.
  base::Result<EntityIndex> parameter_entity(int i) const;
  // An error for a value that is no word of an entity.
  base::Result<FieldIndex> parameter_field(int i) const;
  void set_parameter_float(int i, float value);
  void set_parameter_vector(int i, const math::Vec3& value);
  void set_parameter_string(int i, StringIndex value);
  void set_parameter_entity(int i, EntityIndex value);

  // --- The result of the running built-in function, or of the call before.
  void return_float(float value);
  void return_vector(const math::Vec3& value);
  void return_string(StringIndex value);
  void return_entity(EntityIndex value);
  float returned_float() const;
  math::Vec3 returned_vector() const;
  EntityIndex returned_entity() const;  // kWorld for a value that is no entity
  StringIndex returned_string() const;

  // --- Entities: program().progs().entity_words words each, all 0 at first. Entity 0 is always there.
  std::uint32_t entity_count() const { return entity_count_; }
  // At least 1; at most limits.entities and limits.entity_bytes, else kTooLarge. Words of new entities are 0;
  // those of lost ones are forgotten.
  base::Status set_entity_count(std::uint32_t count);
  // Valid until the number of entities changes. CHECKs that there is such an entity.
  std::span<std::uint32_t> entity(EntityIndex index);
  std::span<const std::uint32_t> entity(EntityIndex index) const;

  // --- Strings
  std::string_view text(StringIndex index) const { return strings_.text(index); }
  // A string that lives as long as any global or entity holds it: collect_strings() forgets the others.
  // kTooLarge past limits.string_bytes.
  base::Result<StringIndex> make_string(std::string_view text) { return strings_.make(text); }
  const Strings& strings() const { return strings_; }
  Strings& strings() { return strings_; }
  // Between calls: frees made strings that nobody holds, if enough were made to be worth it.
  void collect_strings();

  // --- Profile: since the last reset; those that ran most instructions first.
  std::vector<FunctionProfile> profile() const;
  void reset_profile();
  std::uint64_t instructions_run() const;

 private:
  // A function that has begun and not yet returned.
  struct Frame {
    FunctionIndex function = kNoFunction;
    const Instruction* at = nullptr;  // where it is: the call, while it waits for another
    std::size_t saved_begin = 0;      // of its locals' old values
  };
  // Why the interpreter stops: `failure_` holds the error of kFailed; after kSwitched it is to go on, with or
  // without tracing.
  enum class Stop { kReturned, kFailed, kSwitched };

  static constexpr std::size_t kSpareWords = 2;

  struct NamedBuiltin {
    std::string name;
    Builtin run;
  };

  // interpreter.cpp
  template <bool kIsTraced>
  Stop interpret(std::size_t base_frames);
  // Records the trace; the error names the place. `at` is the innermost function's.
  Stop fail(const Instruction* at, base::Error error);
  Stop fail_string(const Instruction* at, std::uint32_t left, std::uint32_t right);
  Stop fail_field(const Instruction* at, std::uint32_t entity, std::uint32_t field);
  Stop fail_pointer(const Instruction* at, std::uint32_t pointer);

  // machine.cpp
  base::Status run(FunctionIndex function);
  base::Status run_frames(FunctionIndex function);
  // Saves its locals and copies its parameters; false when there is no room.
  bool enter(FunctionIndex function);
  base::Error no_room_for(FunctionIndex function) const;
  void leave();
  base::Status run_builtin(FunctionIndex function);
  base::Error located(base::Error error);
  void bind(std::size_t slot, FunctionIndex function);
  const std::uint32_t* parameter_at(int i) const;
  std::uint32_t* parameter_at(int i);

  std::shared_ptr<const Program> program_;
  Limits limits_;
  std::vector<std::uint32_t> globals_;  // and kSpareWords, for what RETURN reads behind the last
  std::vector<std::uint32_t> entity_words_;
  std::uint32_t entity_count_ = 1;
  Strings strings_;
  std::vector<NamedBuiltin> builtins_;
  std::vector<std::uint32_t> builtin_of_;  // by function: which of builtins_, or kNoBuiltin
  std::optional<StateFields> state_fields_;
  bool world_is_protected_ = false;
  std::function<void(std::string_view)> tracer_;

  std::vector<Frame> frames_;
  std::vector<std::uint32_t> saved_;  // locals' old values; the first saved_count_ are in use
  std::size_t saved_count_ = 0;
  int nested_calls_ = 0;
  std::int64_t budget_ = 0;  // instructions that the outermost call has left
  int parameter_count_ = 0;
  std::optional<int> bad_text_parameter_;
  base::Error failure_;
  std::vector<TraceEntry> failure_trace_;
  std::vector<FunctionProfile> counters_;  // by function
};

}  // namespace temblor::vm
