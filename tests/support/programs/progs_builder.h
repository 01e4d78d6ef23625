// Builds small programs from single globals, fields, functions, and statements.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string_view>
#include <vector>

#include "formats/game/progs.h"
#include "vm/code/opcodes.h"
#include "vm/program.h"

namespace temblor::test {

class ProgsBuilder {
 public:
  ProgsBuilder();

  // Adds global words with these values. Returns the index of the first.
  int words(std::initializer_list<std::uint32_t> values);
  int number(float value = 0);
  int vector(float x = 0, float y = 0, float z = 0);
  int text(std::string_view text);
  // Adds a global with a name.
  int named(std::string_view name, formats::ProgsType type);
  // Adds a field of entities, and returns the global that contains it.
  int field(std::string_view name, formats::ProgsType type);

  // Adds a function that begins with the next statement. Its parameters and other locals are new global
  // words. Returns the global that contains it.
  int function(std::string_view name, std::initializer_list<int> parameter_words = {},
               std::uint32_t further_locals = 0);
  // The first word of the parameters and locals of the last function.
  int locals() const { return locals_; }
  int builtin(std::string_view name, int number);

  // Appends a statement, and returns its number.
  int emit(vm::Opcode opcode, int a = 0, int b = 0, int c = 0);
  // Makes the jump at statement `from` lead to the next statement that is appended.
  void land(int from);

  formats::Progs& progs() { return progs_; }
  std::shared_ptr<const vm::Program> load() const;  // CHECKs that it loads

 private:
  std::uint32_t add_string(std::string_view text);
  int add_function(formats::ProgsFunction function, std::string_view name);

  formats::Progs progs_;
  int locals_ = 0;
};

}  // namespace temblor::test
