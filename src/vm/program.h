// A QuakeC program in the form that the machine runs: loaded once, constant, shared by any number of
// machines.
//
// Loading checks every statement and translates it to an instruction (code/instruction.h), so the interpreter
// need not check operands again:
//
//   progs.dat -> formats::read_progs() -> Program::load() -> instructions -> Machine
//   statement i  <->  instruction i, so jumps, errors, and line numbers need no table
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/index.h"
#include "base/result.h"
#include "formats/game/progs.h"
#include "vm/code/instruction.h"

namespace temblor::vm {

enum class FunctionIndex : std::uint32_t {};  // 0: no function
enum class GlobalIndex : std::uint32_t {};    // the number of a word in the globals
enum class FieldIndex : std::uint32_t {};     // the number of a word in an entity
enum class EntityIndex : std::uint32_t {};    // 0: the world
// A string as QuakeC stores it. Below 2^31: an offset into the program's strings. Above: a string that the
// machine made (see code/strings.h).
enum class StringIndex : std::uint32_t {};

constexpr FunctionIndex kNoFunction{0};
constexpr EntityIndex kWorld{0};
constexpr StringIndex kEmptyString{0};

// Function, global, and field names come from the program. A function has the statements from its first one
// up to the first one of the next function in the file.
class Program {
 public:
  Program(const Program&) = delete;  // views point into it
  Program& operator=(const Program&) = delete;

  // Loads a program from read_progs(). Fails with kMalformed on an operand past the globals or a jump out of
  // the program; the error names function and statement. An unknown operation is an error only when it runs,
  // because compilers add such statements for other engines. `lines` has the source line of each statement
  // (formats::read_lno()), or is empty.
  static base::Result<std::shared_ptr<const Program>> load(formats::Progs progs,
                                                           std::vector<std::uint32_t> lines = {});

  const formats::Progs& progs() const { return progs_; }
  // One instruction for each statement, and kPastEnd after the last.
  const std::vector<Instruction>& instructions() const { return instructions_; }

  // Find a definition by its name in the source. Return the first one if there are several, null if there is
  // none. Pointers are valid as long as the program.
  const formats::ProgsDefinition* find_global(std::string_view name) const;
  const formats::ProgsDefinition* find_field(std::string_view name) const;
  FunctionIndex find_function(std::string_view name) const;  // kNoFunction if there is none
  // Returns the (first) definition that begins at that word, or null.
  const formats::ProgsDefinition* global_at(std::size_t word) const;

  const formats::ProgsFunction& function(FunctionIndex index) const {
    return progs_.functions[base::to_size(index)];
  }
  // Returns the function that contains the statement: the last one that begins at or before it. kNoFunction
  // before the first.
  FunctionIndex function_at(std::size_t statement) const;
  // Returns the number of the statement after the function's last one; 0 for functions without statements.
  std::size_t function_end(FunctionIndex index) const { return ends_[base::to_size(index)]; }
  std::string_view function_name(FunctionIndex index) const { return progs_.string_at(function(index).name); }
  std::string_view function_file(FunctionIndex index) const { return progs_.string_at(function(index).file); }
  // Returns "main (world.qc:123), statement 4567", without the line if it is unknown.
  std::string describe_place(FunctionIndex index, std::size_t statement) const;

 private:
  using Names = std::map<std::string_view, std::size_t, std::less<>>;

  Program(formats::Progs progs, std::vector<std::uint32_t> lines);
  base::Status decode_all();
  // Fills the tables of names; their keys point into progs_.
  void index_names();
  // Fills starts_ and ends_.
  void find_ends();

  formats::Progs progs_;
  std::vector<std::uint32_t> lines_;  // source line by statement, or empty
  std::vector<Instruction> instructions_;
  std::vector<std::pair<std::size_t, FunctionIndex>> starts_;  // sorted: first statement, function
  std::vector<std::size_t> ends_;                              // by function: end of its statements
  Names globals_, fields_, functions_;
  std::map<std::size_t, std::size_t> globals_by_word_;
};

}  // namespace temblor::vm
