// A statement as the machine runs it. Statements of different types that do the same to words are one
// operation; and a statement whose result the next one tests or stores through does the work of both (the
// next one is still there, for whoever jumps to it). So there is one instruction for each statement, and a
// place among the instructions is a place among the statements.
#pragma once

#include <cstdint>

namespace temblor::vm {

// A list for the machine's table of jumps, which has to be in the same order: hence the macro. After
// kPastEnd, which stands behind the last statement, come the pairs.
// clang-format off
#define TEMBLOR_VM_OPERATIONS(X) \
  X(MulF) X(MulV) X(MulFV) X(MulVF) X(DivF) X(AddF) X(AddV) X(SubF) X(SubV) X(EqF) X(EqV) X(EqS) \
  X(EqWord) X(NeF) X(NeV) X(NeS) X(NeWord) X(Le) X(Ge) X(Lt) X(Gt) X(LoadWord) X(LoadVector) \
  X(Address) X(StoreWord) X(StoreVector) X(StorePWord) X(StorePVector) X(Return) X(NotF) X(NotV) \
  X(NotS) X(NotWord) X(If) X(IfNot) X(Call) X(State) X(Goto) X(And) X(Or) X(BitAnd) X(BitOr) \
  X(PastEnd) X(EqFIfNot) X(EqWordIfNot) X(NeFIfNot) X(NeWordIfNot) X(LeIfNot) X(GeIfNot) X(LtIfNot) \
  X(GtIfNot) X(AndIfNot) X(OrIfNot) X(BitAndIfNot) X(NotFIfNot) X(NotWordIfNot) X(LoadWordIfNot) \
  X(EqFIf) X(EqWordIf) X(NeFIf) X(NeWordIf) X(LeIf) X(GeIf) X(LtIf) X(GtIf) X(AndIf) X(OrIf) \
  X(BitAndIf) X(NotFIf) X(NotWordIf) X(LoadWordIf) X(AddressStorePWord) X(AddressStorePVector)
// clang-format on

enum class Operation : std::uint16_t {
#define TEMBLOR_VM_NAME(name) k##name,
  TEMBLOR_VM_OPERATIONS(TEMBLOR_VM_NAME)
#undef TEMBLOR_VM_NAME
};

struct Instruction {
  Operation operation = Operation::kPastEnd;  // perhaps with the next statement's
  Operation alone = Operation::kPastEnd;      // of this statement only
  // Global words. Of a call: a; b is how many parameters. Of a jump: `b` of If and IfNot, `a` of Goto are
  // instructions to go on.
  std::int32_t a = 0, b = 0, c = 0;
};

}  // namespace temblor::vm
