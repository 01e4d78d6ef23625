// The QuakeC virtual machine: runs one program with its globals, entities, and strings.
//
// It knows nothing about Quake: the server adds the built-in functions and names the fields of STATE. Two
// machines share only their (constant) program. All values are untyped 32-bit words; a statement decides
// whether a word is a float, a string, an entity, a field, a pointer, or a function:
//
//   globals:   word 0     1-3      4-6    7-9  ...  25-27    28 ...
//              | null | return | parm0 | parm1 | ... | parm7 | globals and locals of the program |
//   entities: [ entity 0: field words ][ entity 1: field words ] ...
//   a pointer is entity * words + field, or 2^31 + the number of a global word
//   strings:  offsets into the program's text, or numbers above 2^31 for strings made while running
//
// Calls: the locals of a function are globals at fixed places. A call saves their old values, copies the
// parameters to the first of them, and runs the callee; the return restores them. So recursion works,
// although a local that is not set yet has an old value.
//
// A program cannot leave the machine: string, entity, field, pointer, and function values are checked at
// every access, and deep recursion, endless loops, and excessive memory use end the call with an error. The
// machine can be called again afterward. Limits are far higher than in the original.
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

// Limits of one machine, which protect the host from game code that hangs or consumes all memory.
struct Limits {
  int call_depth = 1024;              // the original has 32
  std::size_t saved_words = 1 << 18;  // saved locals of all active functions; the original has 2048
  // The budget of one call from outside, including everything it calls; the original has 100,000. Comparing
  // long strings and calling functions with many locals count as several instructions.
  std::uint64_t instructions = 10'000'000;
  std::size_t string_bytes = 64 << 20;  // all strings made while running
  std::uint32_t entities = 32000;
  std::size_t entity_bytes = 256 << 20;  // all entities together
  int nested_calls = 32;                 // depth of built-in functions that call back into the machine
};

// One function of a call stack. Traces list the innermost function first.
struct TraceEntry {
  FunctionIndex function = kNoFunction;
  std::size_t statement = 0;  // 0 for a built-in function
};

// The globals and fields that operation 60, STATE, uses. QuakeC writes it as `void() walk1 = [$walk1, walk2]
// {...}`: self.nextthink = time + 0.1, self.frame = the first operand, self.think = the second.
struct StateFields {
  GlobalIndex self{}, time{};
  FieldIndex next_think{}, frame{}, think{};
};

// Work of one function since the last reset.
struct FunctionProfile {
  FunctionIndex function = kNoFunction;
  std::uint64_t calls = 0;
  std::uint64_t instructions = 0;  // without the functions that it called
};

// One machine belongs to one thread. Functions that name an index CHECK that it is valid, except where
// documented: indices come from the engine, values from the program.
class Machine {
 public:
  // A function of the engine. Reads its parameters from the machine, and writes its result there with
  // return_*(). May call back into the machine. An error ends the outermost call.
  using Builtin = std::function<base::Status(Machine& io_machine)>;

  static constexpr int kMaxParameters = 8;

  // Starts with the program's initial globals, except that __ext__fasttrackarrays is 1, and with the world as
  // the only entity.
  explicit Machine(std::shared_ptr<const Program> program, Limits limits = {});

  const Program& program() const { return *program_; }

  // Adds built-in function `number` (1 and up). Calling a number that was not added is an error that names
  // it. Must not be called while the program runs.
  void add_builtin(int number, std::string name, Builtin builtin);
  // Adds a function for programs that declare it with number 0, so that only its name identifies it.
  void add_named_builtin(std::string name, Builtin builtin);
  // CHECKs that the indices belong to the program. Without them, operation 60 is an error.
  void set_state_fields(const StateFields& fields);
  // While set, writing to the world (entity 0) is an error, as in the original after the level has started:
  // it usually means that game code used an entity variable that was never set.
  void protect_world(bool is_protected) { world_is_protected_ = is_protected; }

  // Runs a function until it returns. Set its parameters first; read its result with returned_*(). An error
  // names the problem, function, file, and statement; failure_trace() has the call stack. kNoFunction is an
  // error. A call from a built-in function shares depth, memory, and budget with the call that it is part of,
  // and overwrites parameters and result, as in the original: read them first.
  base::Status call(FunctionIndex function);
  // The call stack of the last call that failed.
  std::span<const TraceEntry> failure_trace() const { return failure_trace_; }
  // Returns one line per entry: "  FUNCTION (FILE:LINE), statement N".
  std::string describe(std::span<const TraceEntry> trace) const;
  // For built-in functions: returns the call stack.
  std::vector<TraceEntry> current_trace() const;
  // For built-in functions whose work grows with their arguments: takes that many instructions from the
  // call's budget.
  void charge(std::uint64_t instructions);
  // Passes each statement as text to `output` before it runs (`traceon` in QuakeC). Null ends tracing and
  // restores full speed.
  void set_tracer(std::function<void(std::string_view line)> output) { tracer_ = std::move(output); }

  // --- Globals. All CHECK that the index is valid. Values are not checked, because any word may be any type.
  std::span<std::uint32_t> global_words() { return std::span(globals_).first(globals_.size() - kSpareWords); }
  std::span<const std::uint32_t> global_words() const {
    return std::span(globals_).first(globals_.size() - kSpareWords);
  }
  float global_float(GlobalIndex index) const;
  math::Vec3 global_vector(GlobalIndex index) const;
  EntityIndex global_entity(GlobalIndex index) const;  // kWorld if the value is not an entity
  StringIndex global_string(GlobalIndex index) const;
  FunctionIndex global_function(GlobalIndex index) const;
  void set_global_float(GlobalIndex index, float value);
  void set_global_vector(GlobalIndex index, const math::Vec3& value);
  void set_global_entity(GlobalIndex index, EntityIndex value);
  void set_global_string(GlobalIndex index, StringIndex value);
  void set_global_function(GlobalIndex index, FunctionIndex value);

  // --- Parameters of the running built-in function, or of the next call; `i` is 0 to 7.
  int parameter_count() const { return parameter_count_; }
  float parameter_float(int i) const;
  math::Vec3 parameter_vector(int i) const;
  // Returns an empty text if the value is not a string; the built-in function's call then ends with an error.
  // Valid as long as the string exists.
  std::string_view parameter_text(int i);
  StringIndex parameter_string(int i) const;
  FunctionIndex parameter_function(int i) const;
  // Fails if the value is not an entity.
  base::Result<EntityIndex> parameter_entity(int i) const;
  // Fails if the value is not the number of an entity's word.
  base::Result<FieldIndex> parameter_field(int i) const;
  void set_parameter_float(int i, float value);
  void set_parameter_vector(int i, const math::Vec3& value);
  void set_parameter_string(int i, StringIndex value);
  void set_parameter_entity(int i, EntityIndex value);

  // --- The result of the running built-in function, or of the last call.
  void return_float(float value);
  void return_vector(const math::Vec3& value);
  void return_string(StringIndex value);
  void return_entity(EntityIndex value);
  float returned_float() const;
  math::Vec3 returned_vector() const;
  EntityIndex returned_entity() const;  // kWorld if the value is not an entity
  StringIndex returned_string() const;

  // --- Entities: program().progs().entity_words words each, initially 0. Entity 0 always exists.
  std::uint32_t entity_count() const { return entity_count_; }
  // Sets the number of entities, at least 1. Fails with kTooLarge above limits.entities or
  // limits.entity_bytes. Words of new entities are 0; those of removed entities are lost.
  base::Status set_entity_count(std::uint32_t count);
  // Returns the entity's words, valid until the number of entities changes. CHECKs that the entity exists.
  std::span<std::uint32_t> entity(EntityIndex index);
  std::span<const std::uint32_t> entity(EntityIndex index) const;

  // --- Strings
  std::string_view text(StringIndex index) const { return strings_.text(index); }
  // Makes a string that lives as long as a global or an entity holds its number; collect_strings() frees the
  // others. Fails with kTooLarge above limits.string_bytes.
  base::Result<StringIndex> make_string(std::string_view text) { return strings_.make(text); }
  const Strings& strings() const { return strings_; }
  Strings& strings() { return strings_; }
  // Frees strings that nothing holds, if enough were made since the last time. Call it between calls; inside
  // of a call it does nothing, because C++ code may hold a string that no global contains yet.
  void collect_strings();

  // --- Profile since the last reset, most instructions first.
  std::vector<FunctionProfile> profile() const;
  void reset_profile();
  // The instructions of all functions in the profile.
  std::uint64_t instructions_run() const;

 private:
  // An active function.
  struct Frame {
    FunctionIndex function = kNoFunction;
    const Instruction* at = nullptr;  // the current instruction; the call, while another function runs
    std::size_t saved_begin = 0;      // where the old values of its locals start in saved_
  };
  // Why the interpreter stopped. kReturned: the function that it was started for has returned. kFailed: the
  // error is in `failure_`. kSwitched: tracing was switched on or off, and the other version of the loop must
  // continue.
  enum class Stop { kReturned, kFailed, kSwitched };

  static constexpr std::size_t kSpareWords = 2;
  // Pointers to globals. Those to entities are below.
  static constexpr std::uint32_t kFirstGlobalPointer = 0x8000'0000;

  struct NamedBuiltin {
    std::string name;
    Builtin run;
  };

  // interpreter.cpp
  // Runs the innermost frame, and stops when only `base_frames` frames are left.
  template <bool kIsTraced>
  Stop interpret(std::size_t base_frames);
  // Records the call stack and adds the location to the error. `at` is the innermost function's instruction.
  Stop fail(const Instruction* at, base::Error error);
  Stop fail_string(const Instruction* at, std::uint32_t left, std::uint32_t right);
  Stop fail_field(const Instruction* at, std::uint32_t entity, std::uint32_t field);
  Stop fail_pointer(const Instruction* at, std::uint32_t pointer);
  Stop fail_index(const Instruction* at, std::uint32_t index);

  // pointers.cpp
  // Return the place of `words` words to which a pointer points, or null if the program must not change them
  // or if they do not exist.
  std::uint32_t* find_writable(std::uint32_t pointer, std::uint32_t words);
  const std::uint32_t* find_readable(std::uint32_t pointer, std::uint32_t words) const;
  // Return element B of the array of globals at A, or null if it does not exist. B is a number of words, or
  // of elements of an array whose last index is in the word before it.
  const std::uint32_t* find_element(const Instruction* at, std::uint32_t words) const;
  const std::uint32_t* find_counted_element(const Instruction* at, std::uint32_t words) const;
  // Returns whether the value of the last SWITCH equals that of a CASE. Strings must be valid.
  bool is_switch_value(const std::uint32_t* value) const;

  // machine.cpp
  base::Status run(FunctionIndex function);
  base::Status run_frames(FunctionIndex function);
  // Saves the function's locals and copies its parameters. Returns false if a limit is reached.
  bool enter(FunctionIndex function);
  // Describes the limit that enter() has reached.
  base::Error make_limit_error(FunctionIndex function) const;
  // Restores the locals of the innermost frame and removes it.
  void leave();
  base::Status run_builtin(FunctionIndex function);
  // Records the call stack as failure_trace_, and adds its innermost place to the error.
  base::Error add_location(base::Error error);
  // Connects a function of the program to a built-in function.
  void bind(std::size_t slot, FunctionIndex function);
  const std::uint32_t* parameter_at(int i) const;
  std::uint32_t* parameter_at(int i);

  std::shared_ptr<const Program> program_;
  Limits limits_;
  // With kSpareWords at the end: RETURN reads three words, and its operand may be the last global.
  std::vector<std::uint32_t> globals_;
  std::vector<std::uint32_t> entity_words_;
  std::uint32_t entity_count_ = 1;
  Strings strings_;
  std::vector<NamedBuiltin> builtins_;
  std::vector<std::uint32_t> builtin_by_function_;  // by function: index into builtins_, or kNoBuiltin
  std::optional<StateFields> state_fields_;
  bool world_is_protected_ = false;
  std::function<void(std::string_view)> tracer_;

  std::vector<Frame> frames_;
  std::vector<std::uint32_t> saved_;  // old values of locals; the first saved_count_ are in use
  std::size_t saved_count_ = 0;
  int nested_calls_ = 0;
  std::int64_t budget_ = 0;  // remaining instructions of the outermost call
  int parameter_count_ = 0;
  Operation switch_kind_ = Operation::kSwitchF;  // of the last SWITCH
  std::array<std::uint32_t, 3> switch_value_{};
  std::optional<int> bad_text_parameter_;  // set by parameter_text() if the value was not a string
  base::Error failure_;
  std::vector<TraceEntry> failure_trace_;
  std::vector<FunctionProfile> counters_;  // by function
};

}  // namespace temblor::vm
