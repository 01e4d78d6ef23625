// Instructions: statements in the form that the machine runs.
//
// Statements of different types that do the same to words share one operation. A statement whose result the
// next one tests or stores through is fused with it; it does the work of both, and the next one stays in the
// list for jumps to it. There is exactly one instruction for each statement, so their numbers are the same:
//
//   statement   7: LE      a, b, c         instruction 7: LeIfNot  a, b, c   (alone: Le)
//               8: IFNOT   c, +5                       8: IfNot    c, +5     (run only after a jump to it)
//
// Fusing saves one dispatch, the most expensive part of a cheap operation.
#pragma once

#include <cstdint>

namespace temblor::vm {

// A macro, because the interpreter's jump table must have the same order. PastEnd comes after the last
// statement of a program; the fused pairs and the additions of fteqcc follow it. Unknown ends the call with
// an error.
// clang-format off
#define TEMBLOR_VM_OPERATIONS(X) \
  X(MulF) X(MulV) X(MulFV) X(MulVF) X(DivF) X(AddF) X(AddV) X(SubF) X(SubV) X(EqF) X(EqV) X(EqS) \
  X(EqWord) X(NeF) X(NeV) X(NeS) X(NeWord) X(Le) X(Ge) X(Lt) X(Gt) X(LoadWord) X(LoadVector) \
  X(Address) X(StoreWord) X(StoreVector) X(StorePWord) X(StorePVector) X(Return) X(NotF) X(NotV) \
  X(NotS) X(NotWord) X(If) X(IfNot) X(Call) X(State) X(Goto) X(And) X(Or) X(BitAnd) X(BitOr) \
  X(PastEnd) X(EqFIfNot) X(EqWordIfNot) X(NeFIfNot) X(NeWordIfNot) X(LeIfNot) X(GeIfNot) X(LtIfNot) \
  X(GtIfNot) X(AndIfNot) X(OrIfNot) X(BitAndIfNot) X(NotFIfNot) X(NotWordIfNot) X(LoadWordIfNot) \
  X(EqFIf) X(EqWordIf) X(NeFIf) X(NeWordIf) X(LeIf) X(GeIf) X(LtIf) X(GtIf) X(AndIf) X(OrIf) \
  X(BitAndIf) X(NotFIf) X(NotWordIf) X(LoadWordIf) X(AddressStorePWord) X(AddressStorePVector) \
  X(MulStoreF) X(MulStoreV) X(MulStorePF) X(DivStoreF) X(DivStorePF) X(AddStoreF) X(AddStoreV) \
  X(AddStorePF) X(AddStorePV) X(SubStoreF) X(SubStoreV) X(SubStorePF) X(SubStorePV) X(FetchGlobalWord) \
  X(FetchGlobalV) X(BitSetF) X(BitSetPF) X(BitClearF) X(BitClearPF) X(SwitchF) X(SwitchV) X(SwitchString) \
  X(SwitchWord) X(Case) X(CaseRange) X(CallH) X(FToIStore) X(IToFStore) X(AddI) X(AddFI) X(AddIF) \
  X(SubI) X(SubFI) X(SubIF) X(IToF) X(FToI) X(StorePIToF) X(StorePFToI) X(BitAndI) X(BitOrI) X(MulI) \
  X(DivI) X(EqI) X(NeI) X(XorI) X(ShiftRightI) X(ShiftLeftI) X(GetPointer) X(LoadArrayWord) \
  X(LoadArrayVector) X(LoadPWord) X(LoadPVector) X(LeI) X(GeI) X(LtI) X(GtI) X(LeIF) X(GeIF) X(LtIF) \
  X(GtIF) X(LeFI) X(GeFI) X(LtFI) X(GtFI) X(EqIF) X(BitAndIF) X(BitOrIF) X(BitAndFI) X(BitOrFI) X(AndI) \
  X(OrI) X(AndIF) X(OrIF) X(AndFI) X(OrFI) X(NeIF) X(BoundCheck) X(IfF) X(IfNotF) X(Unknown)
// clang-format on

enum class Operation : std::uint16_t {
#define TEMBLOR_VM_NAME(name) k##name,
  TEMBLOR_VM_OPERATIONS(TEMBLOR_VM_NAME)
#undef TEMBLOR_VM_NAME
};

// 16 bytes: four in a cache line.
struct Instruction {
  Operation operation = Operation::kPastEnd;  // possibly fused with the next statement
  Operation alone = Operation::kPastEnd;      // this statement without fusion
  // Indices of global words, except for jump distances, numbers (see OperandKind), and these: Call has the
  // global with the function in `a`, and the number of parameters itself in `b`; Unknown has the number of
  // the operation in `a`.
  std::int32_t a = 0, b = 0, c = 0;
};

}  // namespace temblor::vm
