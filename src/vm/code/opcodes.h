// The 66 operations of version 6 programs, with the types of their operands. A statement is an operation and
// three operands, each the number of a global word:
//
//   ADD_F  a, b, c      c = a + b                    LOAD_F   e, f, c     c = entity e . field f
//   STORE_F a, b        b = a                        ADDRESS  e, f, c     c = pointer to entity e . field f
//   IFNOT  a, distance  if (!a) jump                 STOREP_F a, p        *p = a
//   CALL2  f            calls f with parm0, parm1    RETURN   a           result = a
//
// Suffixes: F float, V vector (three words), S string, E or ENT entity, FLD field, FNC function.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

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
};

constexpr std::uint16_t kOpcodes = 66;

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
  kAny,   // one word of any type
  kJump,  // not a global: signed distance in statements
};

struct OpcodeInfo {
  std::string_view name;  // as in disassemblies: "MUL_F"
  std::array<OperandKind, 3> operands{};
};

// `number` must be below kOpcodes.
const OpcodeInfo& opcode_info(std::uint16_t number);
inline const OpcodeInfo& opcode_info(Opcode opcode) {
  return opcode_info(static_cast<std::uint16_t>(opcode));
}

}  // namespace temblor::vm
