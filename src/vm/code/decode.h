// Translates the statements of a file to instructions. This is the only check of opcodes and operands: the
// interpreter trusts the result.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "formats/game/progs.h"
#include "vm/code/instruction.h"

namespace temblor::vm {

// Returns the operand of a jump with its sign.
std::int32_t jump_distance(const formats::Progs& progs, std::uint32_t operand);

// Translates one statement. Returns kMalformed for an operand past the globals or a jump out of the program.
// The error describes the problem without the location. An unknown operation becomes Operation::kUnknown.
base::Result<Instruction> decode(const formats::Progs& progs, std::size_t statement);

// Fuses pairs of instructions for which there is a combined operation. The first one then does the work of
// both; the second one stays in the list, because a jump may lead to it.
void fuse_pairs(std::vector<Instruction>& io_instructions);

}  // namespace temblor::vm
