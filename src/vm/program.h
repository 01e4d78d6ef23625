// A QuakeC program as the machine runs it: loaded once, never changed, shared by any number of machines.
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
enum class GlobalIndex : std::uint32_t {};    // a word among the globals
enum class FieldIndex : std::uint32_t {};     // a word of an entity
enum class EntityIndex : std::uint32_t {};    // 0: the world
// A string as QuakeC holds it. Below 2^31: where it begins among the program's strings. From there on: one of
// the machine's own (see Strings).
enum class StringIndex : std::uint32_t {};

constexpr FunctionIndex kNoFunction{0};
constexpr EntityIndex kWorld{0};
constexpr StringIndex kEmptyString{0};

class Program {
 public:
  Program(const Program&) = delete;  // names point into it
  Program& operator=(const Program&) = delete;

  // `progs` as read_progs leaves it. Checks every statement: an operation that is not known, an operand past
  // the globals or a jump out of the function's statements is an error that names the function and statement.
  // `lines` has the source's line for each statement, or is empty where they are not known.
  static base::Result<std::shared_ptr<const Program>> load(formats::Progs progs,
                                                           std::vector<std::uint32_t> lines = {});

  const formats::Progs& progs() const { return progs_; }
  // One for each statement, and kPastEnd behind them.
  const std::vector<Instruction>& instructions() const { return instructions_; }

  // By name, as in the source. Of several definitions of one name the first.
  const formats::ProgsDefinition* find_global(std::string_view name) const;
  const formats::ProgsDefinition* find_field(std::string_view name) const;
  FunctionIndex find_function(std::string_view name) const;  // kNoFunction: there is none
  // The definition that begins at that word; null: there is none. Of several the first.
  const formats::ProgsDefinition* global_at(std::size_t word) const;

  const formats::ProgsFunction& function(FunctionIndex index) const {
    return progs_.functions[base::to_size(index)];
  }
  // Whose statement that is: the function that begins last before it; kNoFunction before the first of all.
  FunctionIndex function_at(std::size_t statement) const;
  // Behind its last statement; 0 for functions that have none.
  std::size_t end_of(FunctionIndex index) const { return ends_[base::to_size(index)]; }
  std::string_view name_of(FunctionIndex index) const { return progs_.string_at(function(index).name); }
  std::string_view file_of(FunctionIndex index) const { return progs_.string_at(function(index).file); }
  // For people: "main (world.qc:123), statement 4567"; without the line where it is not known.
  std::string describe_place(FunctionIndex index, std::size_t statement) const;

 private:
  using Names = std::map<std::string_view, std::size_t, std::less<>>;

  Program(formats::Progs progs, std::vector<std::uint32_t> lines);
  base::Status decode_all();
  // Places of what has names: they point into progs_.
  void name_all();
  void find_ends();

  formats::Progs progs_;
  std::vector<std::uint32_t> lines_;  // of statements, or empty
  std::vector<Instruction> instructions_;
  std::vector<std::pair<std::size_t, FunctionIndex>> starts_;  // sorted: first statement, function
  std::vector<std::size_t> ends_;                              // by function
  Names globals_, fields_, functions_;
  std::map<std::size_t, std::size_t> globals_by_word_;
};

}  // namespace temblor::vm
