#include "vm/code/decode.h"

#include <optional>

#include "vm/code/opcodes.h"

namespace temblor::vm {
namespace {

// Maps operations that treat words alike, such as STORE_F and STORE_ENT, to one.
Operation translate_opcode(Opcode opcode) {
  switch (opcode) {
    case Opcode::kMulF:
      return Operation::kMulF;
    case Opcode::kMulV:
      return Operation::kMulV;
    case Opcode::kMulFV:
      return Operation::kMulFV;
    case Opcode::kMulVF:
      return Operation::kMulVF;
    case Opcode::kDivF:
      return Operation::kDivF;
    case Opcode::kAddF:
      return Operation::kAddF;
    case Opcode::kAddV:
      return Operation::kAddV;
    case Opcode::kSubF:
      return Operation::kSubF;
    case Opcode::kSubV:
      return Operation::kSubV;
    case Opcode::kEqF:
      return Operation::kEqF;
    case Opcode::kEqV:
      return Operation::kEqV;
    case Opcode::kEqS:
      return Operation::kEqS;
    case Opcode::kEqE:
    case Opcode::kEqFnc:
      return Operation::kEqWord;
    case Opcode::kNeF:
      return Operation::kNeF;
    case Opcode::kNeV:
      return Operation::kNeV;
    case Opcode::kNeS:
      return Operation::kNeS;
    case Opcode::kNeE:
    case Opcode::kNeFnc:
      return Operation::kNeWord;
    case Opcode::kLe:
      return Operation::kLe;
    case Opcode::kGe:
      return Operation::kGe;
    case Opcode::kLt:
      return Operation::kLt;
    case Opcode::kGt:
      return Operation::kGt;
    case Opcode::kLoadF:
    case Opcode::kLoadS:
    case Opcode::kLoadEnt:
    case Opcode::kLoadFld:
    case Opcode::kLoadFnc:
      return Operation::kLoadWord;
    case Opcode::kLoadV:
      return Operation::kLoadVector;
    case Opcode::kAddress:
      return Operation::kAddress;
    case Opcode::kStoreF:
    case Opcode::kStoreS:
    case Opcode::kStoreEnt:
    case Opcode::kStoreFld:
    case Opcode::kStoreFnc:
      return Operation::kStoreWord;
    case Opcode::kStoreV:
      return Operation::kStoreVector;
    case Opcode::kStorePF:
    case Opcode::kStorePS:
    case Opcode::kStorePEnt:
    case Opcode::kStorePFld:
    case Opcode::kStorePFnc:
      return Operation::kStorePWord;
    case Opcode::kStorePV:
      return Operation::kStorePVector;
    case Opcode::kDone:
    case Opcode::kReturn:
      return Operation::kReturn;
    case Opcode::kNotF:
      return Operation::kNotF;
    case Opcode::kNotV:
      return Operation::kNotV;
    case Opcode::kNotS:
      return Operation::kNotS;
    case Opcode::kNotEnt:
    case Opcode::kNotFnc:
      return Operation::kNotWord;
    case Opcode::kIf:
      return Operation::kIf;
    case Opcode::kIfNot:
      return Operation::kIfNot;
    case Opcode::kCall0:
    case Opcode::kCall1:
    case Opcode::kCall2:
    case Opcode::kCall3:
    case Opcode::kCall4:
    case Opcode::kCall5:
    case Opcode::kCall6:
    case Opcode::kCall7:
    case Opcode::kCall8:
      return Operation::kCall;
    case Opcode::kState:
      return Operation::kState;
    case Opcode::kGoto:
      return Operation::kGoto;
    case Opcode::kAnd:
      return Operation::kAnd;
    case Opcode::kOr:
      return Operation::kOr;
    case Opcode::kBitAnd:
      return Operation::kBitAnd;
    case Opcode::kBitOr:
      return Operation::kBitOr;
  }
  return Operation::kPastEnd;  // unreachable: the caller has checked the operation
}

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
base::Result<std::int32_t> check_operand(std::uint16_t operand, OperandKind kind, const formats::Progs& progs,
                                         std::size_t statement, StatementRange function) {
  if (kind == OperandKind::kJump) {
    const auto distance = static_cast<std::int16_t>(operand);
    const auto target = static_cast<std::int64_t>(statement) + distance;
    if (target < static_cast<std::int64_t>(function.begin) ||
        target >= static_cast<std::int64_t>(function.end))
      return base::malformed("it jumps by {} statements to {}, but the function has statements {} to {}",
                             distance, target, function.begin, function.end - 1);
    return std::int32_t{distance};
  }
  const std::size_t words = kind == OperandKind::kNone ? 0 : kind == OperandKind::kVector ? 3 : 1;
  if (words > 0 && operand + words > progs.global_words.size())
    return base::malformed("it uses global word {}, but there are only {}", operand + words - 1,
                           progs.global_words.size());
  return std::int32_t{operand};
}

}  // namespace

base::Result<Instruction> decode(const formats::Progs& progs, std::size_t statement,
                                 StatementRange function) {
  const formats::ProgsStatement& source = progs.statements[statement];
  if (source.op >= kOpcodes)
    return base::error(
        base::ErrorCode::kUnsupported,
        "operation {} does not exist in version 6 (0 to {}); compile the program for stock Quake", source.op,
        kOpcodes - 1);
  const auto opcode = static_cast<Opcode>(source.op);
  const OpcodeInfo& info = opcode_info(opcode);
  Instruction instruction;
  instruction.operation = instruction.alone = translate_opcode(opcode);
  TRY(instruction.a, check_operand(source.operands[0], info.operands[0], progs, statement, function));
  TRY(instruction.b, check_operand(source.operands[1], info.operands[1], progs, statement, function));
  TRY(instruction.c, check_operand(source.operands[2], info.operands[2], progs, statement, function));
  if (instruction.alone == Operation::kCall)
    instruction.b = source.op - static_cast<std::int32_t>(Opcode::kCall0);
  return instruction;
}

void fuse_pairs(std::vector<Instruction>& io_instructions) {
  for (std::size_t i = 0; i + 1 < io_instructions.size(); ++i)
    io_instructions[i].operation =
        fuse(io_instructions[i], io_instructions[i + 1]).value_or(io_instructions[i].alone);
}

}  // namespace temblor::vm
