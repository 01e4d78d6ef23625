// The 66 operations of version 6, and what their operands are.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace temblor::vm {

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
  kJump,  // not a global: statements to go on from this one, signed
};

struct OpcodeInfo {
  std::string_view name;  // as the manuals write it: "MUL_F"
  std::array<OperandKind, 3> operands{};
};

// `number` below kOpcodes.
const OpcodeInfo& opcode_info(std::uint16_t number);
inline const OpcodeInfo& opcode_info(Opcode opcode) {
  return opcode_info(static_cast<std::uint16_t>(opcode));
}

}  // namespace temblor::vm
