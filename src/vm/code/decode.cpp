#include "vm/code/decode.h"

#include <optional>

#include "vm/code/opcodes.h"

namespace temblor::vm {
namespace {

// Returns the fused operation of `first` and the branch that tests its result, or nullopt if there is none.
std::optional<Operation> fuse_with_branch(Operation first, Operation branch) {
  const bool is_not = branch == Operation::kIfNot;
  switch (first) {
    case Operation::kEqF:
      return is_not ? Operation::kEqFIfNot : Operation::kEqFIf;
    case Operation::kEqWord:
      return is_not ? Operation::kEqWordIfNot : Operation::kEqWordIf;
    case Operation::kNeF:
      return is_not ? Operation::kNeFIfNot : Operation::kNeFIf;
    case Operation::kNeWord:
      return is_not ? Operation::kNeWordIfNot : Operation::kNeWordIf;
    case Operation::kLe:
      return is_not ? Operation::kLeIfNot : Operation::kLeIf;
    case Operation::kGe:
      return is_not ? Operation::kGeIfNot : Operation::kGeIf;
    case Operation::kLt:
      return is_not ? Operation::kLtIfNot : Operation::kLtIf;
    case Operation::kGt:
      return is_not ? Operation::kGtIfNot : Operation::kGtIf;
    case Operation::kAnd:
      return is_not ? Operation::kAndIfNot : Operation::kAndIf;
    case Operation::kOr:
      return is_not ? Operation::kOrIfNot : Operation::kOrIf;
    case Operation::kBitAnd:
      return is_not ? Operation::kBitAndIfNot : Operation::kBitAndIf;
    case Operation::kNotF:
      return is_not ? Operation::kNotFIfNot : Operation::kNotFIf;
    case Operation::kNotWord:
      return is_not ? Operation::kNotWordIfNot : Operation::kNotWordIf;
    case Operation::kLoadWord:
      return is_not ? Operation::kLoadWordIfNot : Operation::kLoadWordIf;
    default:
      return std::nullopt;
  }
}

// The result of `first` must be the operand that `second` tests or stores through; the fused operation still
// writes it to its global, because later statements may read it.
std::optional<Operation> fuse(const Instruction& first, const Instruction& second) {
  const bool is_branch = second.alone == Operation::kIf || second.alone == Operation::kIfNot;
  if (is_branch && second.a == first.c) return fuse_with_branch(first.alone, second.alone);
  if (first.alone == Operation::kAddress && second.b == first.c) {
    if (second.alone == Operation::kStorePWord) return Operation::kAddressStorePWord;
    if (second.alone == Operation::kStorePVector) return Operation::kAddressStorePVector;
  }
  return std::nullopt;
}

// Returns the operand as the interpreter needs it: the number of a word, or a jump distance with its sign.
base::Result<std::int32_t> check_operand(std::uint32_t operand, OperandKind kind, const formats::Progs& progs,
                                         std::size_t statement) {
  if (kind == OperandKind::kJump) {
    const std::int32_t distance = jump_distance(progs, operand);
    const auto target = static_cast<std::int64_t>(statement) + distance;
    if (target < 0 || target >= static_cast<std::int64_t>(progs.statements.size()))
      return base::malformed("it jumps by {} statements to {}, but the program has statements 0 to {}",
                             distance, target, progs.statements.size() - 1);
    return distance;
  }
  const bool is_global = kind != OperandKind::kNone && kind != OperandKind::kNumber;
  const std::size_t words = !is_global ? 0 : kind == OperandKind::kVector ? 3 : 1;
  if (words > 0 && operand + words > progs.global_words.size())
    return base::malformed("it uses global word {}, but there are only {}", operand + words - 1,
                           progs.global_words.size());
  return static_cast<std::int32_t>(operand);
}

}  // namespace

std::int32_t jump_distance(const formats::Progs& progs, std::uint32_t operand) {
  return progs.layout == formats::ProgsLayout::kNarrow ? static_cast<std::int16_t>(operand)
                                                       : static_cast<std::int32_t>(operand);
}

base::Result<Instruction> decode(const formats::Progs& progs, std::size_t statement) {
  const formats::ProgsStatement& source = progs.statements[statement];
  const OpcodeInfo& info = opcode_info(source.op);
  Instruction instruction;
  instruction.operation = instruction.alone = info.operation;
  TRY(instruction.a, check_operand(source.operands[0], info.operands[0], progs, statement));
  TRY(instruction.b, check_operand(source.operands[1], info.operands[1], progs, statement));
  TRY(instruction.c, check_operand(source.operands[2], info.operands[2], progs, statement));
  if (instruction.alone == Operation::kCall)
    instruction.b = static_cast<std::int32_t>(source.op) - static_cast<std::int32_t>(Opcode::kCall0);
  if (instruction.alone == Operation::kUnknown) instruction.a = static_cast<std::int32_t>(source.op);
  return instruction;
}

void fuse_pairs(std::vector<Instruction>& io_instructions) {
  for (std::size_t i = 0; i + 1 < io_instructions.size(); ++i)
    io_instructions[i].operation =
        fuse(io_instructions[i], io_instructions[i + 1]).value_or(io_instructions[i].alone);
}

}  // namespace temblor::vm
