// Translates the statements of a file to instructions. This is the only check of opcodes and operands: the
// interpreter trusts the result.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "formats/game/progs.h"
#include "vm/code/instruction.h"

namespace temblor::vm {

// The statements of one function, [begin, end). Jumps must stay inside.
struct StatementRange {
  std::size_t begin = 0, end = 0;
};

// Translates one statement. Returns kUnsupported for an unknown operation, kMalformed for an operand past the
// globals or a jump out of the function. The error describes the problem without the location.
base::Result<Instruction> decode(const formats::Progs& progs, std::size_t statement, StatementRange function);

// Fuses pairs of instructions for which there is a combined operation. The first one then does the work of
// both; the second one stays in the list, because a jump may lead to it.
void fuse_pairs(std::vector<Instruction>& io_instructions);

}  // namespace temblor::vm
