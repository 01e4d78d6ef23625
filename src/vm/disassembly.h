// Programs in words, for people.
#pragma once

#include <cstddef>
#include <string>

#include "vm/program.h"

namespace temblor::vm {

// "LOAD_F     self, health, 52": the operation and its operands: names of globals, values of constants, and
// numbers of what has neither. Jumps say where to: "IFNOT      52, to 117".
std::string describe_statement(const Program& program, std::size_t statement);

// A function's statements, a line each, with their numbers; one line for a built-in function.
std::string disassemble(const Program& program, FunctionIndex function);

}  // namespace temblor::vm
