// Small programs by hand: globals, fields, functions and statements, put together one by one.
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

  // New global words, with these values; returns the place of the first.
  int words(std::initializer_list<std::uint32_t> values);
  int number(float value = 0);
  int vector(float x = 0, float y = 0, float z = 0);
  int text(std::string_view text);
  // A global that has a name.
  int named(std::string_view name, formats::ProgsType type);
  // A field of entities, and the global that holds it.
  int field(std::string_view name, formats::ProgsType type);

  // A function that begins with the next statement; its parameters, then its further locals, are new global
  // words. Returns the global that holds it.
  int function(std::string_view name, std::initializer_list<int> parameter_words = {},
               std::uint32_t further_locals = 0);
  // Where the latest function's parameters and locals begin.
  int locals() const { return locals_; }
  int builtin(std::string_view name, int number);

  // Appends a statement; returns its number.
  int emit(vm::Opcode opcode, int a = 0, int b = 0, int c = 0);
  // Makes the jump at statement `from` lead to the next one that is emitted.
  void land(int from);

  formats::Progs& progs() { return progs_; }
  std::shared_ptr<const vm::Program> load() const;  // CHECKs that it can be

 private:
  std::uint32_t add_string(std::string_view text);
  int add_function(formats::ProgsFunction function, std::string_view name);

  formats::Progs progs_;
  int locals_ = 0;
};

}  // namespace temblor::test
