#include "vm/code/opcodes.h"

#include "base/check.h"

namespace temblor::vm {
namespace {

constexpr OperandKind kNone = OperandKind::kNone, kF = OperandKind::kFloat, kV = OperandKind::kVector,
                      kS = OperandKind::kString, kE = OperandKind::kEntity, kFld = OperandKind::kField,
                      kFnc = OperandKind::kFunction, kPtr = OperandKind::kPointer, kAny = OperandKind::kAny,
                      kJump = OperandKind::kJump;

// In the order of their numbers. RETURN reads three words, but compilers name globals that have only one, so
// it is kAny; the machine has spare words after the last global.
constexpr std::array<OpcodeInfo, kOpcodes> kTable = {{
    {"DONE", {kAny, kNone, kNone}},
    {"MUL_F", {kF, kF, kF}},
    {"MUL_V", {kV, kV, kF}},
    {"MUL_FV", {kF, kV, kV}},
    {"MUL_VF", {kV, kF, kV}},
    {"DIV_F", {kF, kF, kF}},
    {"ADD_F", {kF, kF, kF}},
    {"ADD_V", {kV, kV, kV}},
    {"SUB_F", {kF, kF, kF}},
    {"SUB_V", {kV, kV, kV}},
    {"EQ_F", {kF, kF, kF}},
    {"EQ_V", {kV, kV, kF}},
    {"EQ_S", {kS, kS, kF}},
    {"EQ_E", {kE, kE, kF}},
    {"EQ_FNC", {kFnc, kFnc, kF}},
    {"NE_F", {kF, kF, kF}},
    {"NE_V", {kV, kV, kF}},
    {"NE_S", {kS, kS, kF}},
    {"NE_E", {kE, kE, kF}},
    {"NE_FNC", {kFnc, kFnc, kF}},
    {"LE", {kF, kF, kF}},
    {"GE", {kF, kF, kF}},
    {"LT", {kF, kF, kF}},
    {"GT", {kF, kF, kF}},
    {"LOAD_F", {kE, kFld, kF}},
    {"LOAD_V", {kE, kFld, kV}},
    {"LOAD_S", {kE, kFld, kS}},
    {"LOAD_ENT", {kE, kFld, kE}},
    {"LOAD_FLD", {kE, kFld, kFld}},
    {"LOAD_FNC", {kE, kFld, kFnc}},
    {"ADDRESS", {kE, kFld, kPtr}},
    {"STORE_F", {kF, kF, kNone}},
    {"STORE_V", {kV, kV, kNone}},
    {"STORE_S", {kS, kS, kNone}},
    {"STORE_ENT", {kE, kE, kNone}},
    {"STORE_FLD", {kFld, kFld, kNone}},
    {"STORE_FNC", {kFnc, kFnc, kNone}},
    {"STOREP_F", {kF, kPtr, kNone}},
    {"STOREP_V", {kV, kPtr, kNone}},
    {"STOREP_S", {kS, kPtr, kNone}},
    {"STOREP_ENT", {kE, kPtr, kNone}},
    {"STOREP_FLD", {kFld, kPtr, kNone}},
    {"STOREP_FNC", {kFnc, kPtr, kNone}},
    {"RETURN", {kAny, kNone, kNone}},
    {"NOT_F", {kF, kNone, kF}},
    {"NOT_V", {kV, kNone, kF}},
    {"NOT_S", {kS, kNone, kF}},
    {"NOT_ENT", {kE, kNone, kF}},
    {"NOT_FNC", {kFnc, kNone, kF}},
    {"IF", {kAny, kJump, kNone}},
    {"IFNOT", {kAny, kJump, kNone}},
    {"CALL0", {kFnc, kNone, kNone}},
    {"CALL1", {kFnc, kNone, kNone}},
    {"CALL2", {kFnc, kNone, kNone}},
    {"CALL3", {kFnc, kNone, kNone}},
    {"CALL4", {kFnc, kNone, kNone}},
    {"CALL5", {kFnc, kNone, kNone}},
    {"CALL6", {kFnc, kNone, kNone}},
    {"CALL7", {kFnc, kNone, kNone}},
    {"CALL8", {kFnc, kNone, kNone}},
    {"STATE", {kF, kFnc, kNone}},
    {"GOTO", {kJump, kNone, kNone}},
    {"AND", {kF, kF, kF}},
    {"OR", {kF, kF, kF}},
    {"BITAND", {kF, kF, kF}},
    {"BITOR", {kF, kF, kF}},
}};

}  // namespace

const OpcodeInfo& opcode_info(std::uint16_t number) {
  CHECK(number < kOpcodes, "{}", number);
  return kTable[number];
}

}  // namespace temblor::vm
