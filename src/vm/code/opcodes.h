// The operations of programs, with the types of their operands: the 66 operations of stock version 6, and
// those that fteqcc adds for integers, arrays, pointers, and switches (-Tfte, and arrays in version 6). A
// statement is an operation and three operands, each the number of a global word:
//
//   ADD_F  a, b, c      c = a + b                    LOAD_F   e, f, c     c = entity e . field f
//   STORE_F a, b        b = a                        ADDRESS  e, f, c     c = pointer to entity e . field f
//   IFNOT  a, distance  if (!a) jump                 STOREP_F a, p        *p = a
//   CALL2  f            calls f with parm0, parm1    RETURN   a           result = a
//   CALL2H f, b, c      calls f with b and c         GET_POINTER a, i, c  c = pointer to the word a + i
//   LOADA_F a, i, c     c = the word a + i           LOADP_F  p, i, c     c = p[i]
//   SWITCH_F a, distance  remembers a and jumps      CASE a, distance     if (remembered == a) jump
//
// Suffixes: F float, V vector (three words), S string, E or ENT entity, FLD field, FNC function, I integer;
// in pairs (ADD_IF), the types of a and b. The additions were found by compiling programs with fteqcc -Fwasm,
// which lists its operations by name.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "vm/code/instruction.h"

namespace temblor::vm {

// The numbers in the file, in order from 0.
enum class Opcode : std::uint16_t {
  kDone,
  kMulF,
  kMulV,  // dot product
  kMulFV,
  kMulVF,
  kDivF,
  kAddF,
  kAddV,
  kSubF,
  kSubV,
  kEqF,
  kEqV,
  kEqS,
  kEqE,
  kEqFnc,
  kNeF,
  kNeV,
  kNeS,
  kNeE,
  kNeFnc,
  kLe,
  kGe,
  kLt,
  kGt,
  kLoadF,
  kLoadV,
  kLoadS,
  kLoadEnt,
  kLoadFld,
  kLoadFnc,
  kAddress,
  kStoreF,
  kStoreV,
  kStoreS,
  kStoreEnt,
  kStoreFld,
  kStoreFnc,
  kStorePF,
  kStorePV,
  kStorePS,
  kStorePEnt,
  kStorePFld,
  kStorePFnc,
  kReturn,
  kNotF,
  kNotV,
  kNotS,
  kNotEnt,
  kNotFnc,
  kIf,
  kIfNot,
  kCall0,
  kCall1,
  kCall2,
  kCall3,
  kCall4,
  kCall5,
  kCall6,
  kCall7,
  kCall8,
  kState,
  kGoto,
  kAnd,
  kOr,
  kBitAnd,
  kBitOr,
  kMulStoreF = 66,  // b *= a
  kMulStoreV,       // vector b *= float a
  kMulStorePF,      // *b *= a
  kDivStoreF = 70,
  kDivStorePF,
  kAddStoreF,
  kAddStoreV,
  kAddStorePF,
  kAddStorePV,
  kSubStoreF,
  kSubStoreV,
  kSubStorePF,
  kSubStorePV,
  kFetchGlobalF,  // c = element b of the array at a; the word before it has the last index
  kFetchGlobalV,
  kFetchGlobalS,
  kFetchGlobalE,
  kFetchGlobalFnc,
  kBitSetF = 88,  // b |= a
  kBitSetPF,
  kBitClearF,  // b &= ~a
  kBitClearPF,
  kSwitchF = 98,
  kSwitchV,
  kSwitchS,
  kSwitchE,
  kSwitchFnc,
  kCase,
  kCaseRange,  // a to b, float
  kCall1H,
  kCall2H,
  kCall3H,
  kCall4H,
  kCall5H,
  kCall6H,
  kCall7H,
  kCall8H,
  kStoreI,
  kStoreFToI,  // "STORE_IF": float a to integer b
  kStoreIToF,  // "STORE_FI"
  kAddI,
  kAddFI,  // the result is a float
  kAddIF,
  kSubI,
  kSubFI,
  kSubIF,
  kIToF,
  kFToI,
  kLoadI = 126,
  kStorePI,
  kStorePIToF,  // integer a to float *b
  kStorePFToI,
  kBitAndI,
  kBitOrI,
  kMulI,
  kDivI,
  kEqI,  // truth values of operations with an integer are integers
  kNeI,
  kXorI = 140,
  kShiftRightI,
  kShiftLeftI,
  kGetPointer,
  kLoadArrayF = 145,
  kLoadArrayV,
  kLoadArrayS,
  kLoadArrayEnt,
  kLoadArrayFld,
  kLoadArrayFnc,
  kLoadArrayI,
  kStoreP,  // copies a pointer
  kLoadPF = 154,
  kLoadPV,
  kLoadPS,
  kLoadPEnt,
  kLoadPFld,
  kLoadPFnc,
  kLoadPI,
  kLeI,
  kGeI,
  kLtI,
  kGtI,
  kLeIF,
  kGeIF,
  kLtIF,
  kGtIF,
  kLeFI,
  kGeFI,
  kLtFI,
  kGtFI,
  kEqIF,
  kBitAndIF = 185,  // the result has the type of the first operand
  kBitOrIF,
  kBitAndFI,
  kBitOrFI,
  kAndI,
  kOrI,
  kAndIF,
  kOrIF,
  kAndFI,
  kOrFI,
  kNeIF,
  kBoundCheck = 211,  // an error unless number c <= integer a < number b
  kIfF = 217,         // tests the float: -0.0 counts as false
  kIfNotF,
};

constexpr std::uint16_t kStockOpcodes = 66;
constexpr std::uint16_t kOpcodes = 219;  // one more than the last; not all numbers below it exist

// The kind of an operand. The size that must fit into the globals: three words for kVector, one otherwise.
enum class OperandKind : std::uint8_t {
  kNone,
  kFloat,
  kVector,
  kString,
  kEntity,
  kField,
  kFunction,
  kPointer,
  kInteger,
  kAny,     // one word of any type
  kJump,    // not a global: signed distance in statements
  kNumber,  // not a global: the number itself
};

struct OpcodeInfo {
  std::string_view name;  // as in disassemblies: "MUL_F"; empty for numbers without an operation
  Operation operation = Operation::kUnknown;
  std::array<OperandKind, 3> operands{};
};

// Numbers without an operation have no name, no operands, and Operation::kUnknown.
const OpcodeInfo& opcode_info(std::uint32_t number);
inline const OpcodeInfo& opcode_info(Opcode opcode) {
  return opcode_info(static_cast<std::uint32_t>(opcode));
}

}  // namespace temblor::vm
