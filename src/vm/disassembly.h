// Describes statements and functions of a program as text, for `temblor inspect` and for traces.
#pragma once

#include <cstddef>
#include <string>

#include "vm/program.h"

namespace temblor::vm {

// Returns the operation and its operands. An operand is the name of a global, the value of a constant, or the
// number of a global without a name, such as a compiler's temporary. Jumps show their target:
//
//   LOAD_F     self, health, 52
//   LE         52, 0, 53
//   IFNOT      53, to 117
std::string describe_statement(const Program& program, std::size_t statement);

// Returns a function's statements, one in each line, with their numbers. A built-in function has one line.
std::string disassemble(const Program& program, FunctionIndex function);

}  // namespace temblor::vm
