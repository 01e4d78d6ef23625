// Statements of a file -> instructions.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "formats/game/progs.h"
#include "vm/code/instruction.h"

namespace temblor::vm {

// The statements that belong to one function: jumps may go to these.
struct StatementRange {
  std::size_t begin = 0, end = 0;
};

// One statement by itself. An error says what is wrong with it, not where it is.
base::Result<Instruction> decode(const formats::Progs& progs, std::size_t statement, StatementRange function);

// Lets instructions do the next one's work as well, where there is an operation for both.
void join_pairs(std::vector<Instruction>& io_instructions);

}  // namespace temblor::vm
