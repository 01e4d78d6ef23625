#include "vm/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/programs/progs_builder.h"
#include "vm/disassembly.h"
#include "vm/machine.h"

namespace temblor::vm {
namespace {

using formats::ProgsType;
using test::ProgsBuilder;
using ::testing::HasSubstr;

std::string error_text(const ProgsBuilder& builder) {
  ProgsBuilder copy = builder;
  const auto program = Program::load(copy.progs());
  return program.ok() ? "no error" : program.error().what;
}

TEST(Program, FindsWhatHasNames) {
  ProgsBuilder builder;
  const int time = builder.named("time", ProgsType::kFloat);
  builder.field("health", ProgsType::kFloat);
  builder.field("origin", ProgsType::kVector);
  builder.builtin("dprint", 25);
  builder.function("main");
  builder.emit(Opcode::kDone);
  builder.function("later");
  builder.emit(Opcode::kDone);
  builder.emit(Opcode::kDone);
  const auto program = builder.load();
  ASSERT_NE(program->find_global("time"), nullptr);
  EXPECT_EQ(program->find_global("time")->offset, time);
  EXPECT_EQ(program->find_global("Time"), nullptr);
  EXPECT_EQ(program->find_field("origin")->offset, 1);
  EXPECT_EQ(program->find_field("time"), nullptr);
  EXPECT_EQ(program->find_function("main"), FunctionIndex{2});
  EXPECT_EQ(program->find_function("none"), kNoFunction);
  EXPECT_EQ(program->find_function(""), kNoFunction);
  EXPECT_EQ(program->function_name(FunctionIndex{2}), "main");
  EXPECT_EQ(program->function_file(FunctionIndex{2}), "test.qc");
  EXPECT_EQ(program->function_at(0), kNoFunction);
  EXPECT_EQ(program->function_at(1), FunctionIndex{2});
  EXPECT_EQ(program->function_at(3), FunctionIndex{3});
  EXPECT_EQ(program->function_end(FunctionIndex{2}), 2u);
  EXPECT_EQ(program->function_end(FunctionIndex{3}), 4u);
  EXPECT_EQ(program->function_end(FunctionIndex{1}), 0u);
}

TEST(Program, OperationsThatAreNoneFailOnlyWhenTheyRun) {
  for (const int number : {69, 92, 210, 219, 0xffff}) {
    ProgsBuilder builder;
    const int flag = builder.number(0);
    builder.function("main");
    builder.emit(Opcode::kIfNot, flag, 2);
    builder.emit(static_cast<Opcode>(number), 0xffff, 0xffff, 0xffff);
    builder.emit(Opcode::kDone);
    const auto program = builder.load();
    EXPECT_THAT(disassemble(*program, FunctionIndex{1}), HasSubstr("  OP_" + std::to_string(number) + "\n"));
    Machine machine(program);
    EXPECT_TRUE(machine.call(FunctionIndex{1}).ok());
    machine.set_global_float(GlobalIndex{static_cast<std::uint32_t>(flag)}, 1);
    EXPECT_THAT(machine.call(FunctionIndex{1}).error().what,
                HasSubstr("operation " + std::to_string(number) + " is not supported"));
  }
}

// Tests every operand of every operation at the last word where it fits, and at the next one.
TEST(Program, OperandsPastTheGlobals) {
  for (std::uint16_t number = 0; number < kOpcodes; ++number) {
    const OpcodeInfo& info = opcode_info(number);
    for (std::size_t i = 0; i < 3; ++i) {
      const OperandKind kind = info.operands[i];
      if (kind == OperandKind::kJump) continue;
      const int words = kind == OperandKind::kVector ? 3 : 1;
      for (const int over : {0, 1, 1000}) {
        ProgsBuilder builder;
        builder.function("main");
        std::array<int, 3> operands{};
        for (std::size_t j = 0; j < 3; ++j) operands[j] = info.operands[j] == OperandKind::kJump ? 1 : 4;
        operands[i] = static_cast<int>(builder.progs().global_words.size()) - words + over;
        builder.emit(static_cast<Opcode>(number), operands[0], operands[1], operands[2]);
        builder.emit(Opcode::kDone);
        EXPECT_THAT(error_text(builder),
                    HasSubstr(over > 0 && kind != OperandKind::kNone && kind != OperandKind::kNumber
                                  ? "statement 1 (function \"main\"): it uses global word"
                                  : "no error"))
            << info.name << " " << i;
      }
    }
  }
}

TEST(Program, JumpsOutOfTheProgram) {
  for (const Opcode opcode : {Opcode::kGoto, Opcode::kIf, Opcode::kIfNot}) {
    for (const auto& [distance, is_good] :
         {std::pair(-4, false), std::pair(-3, true), std::pair(0, true), std::pair(2, true),
          std::pair(3, false), std::pair(32767, false), std::pair(-32768, false)}) {
      ProgsBuilder builder;
      builder.function("before");
      builder.emit(Opcode::kDone);
      builder.function("main");
      builder.emit(Opcode::kDone);
      if (opcode == Opcode::kGoto)
        builder.emit(opcode, distance);
      else
        builder.emit(opcode, 4, distance);
      builder.emit(Opcode::kDone);
      builder.function("after");
      builder.emit(Opcode::kDone);
      EXPECT_THAT(error_text(builder),
                  HasSubstr(is_good ? "no error" : "statement 3 (function \"main\"): it jumps"))
          << distance;
    }
  }
}

TEST(Disassembly, NamesWhatHasNames) {
  ProgsBuilder builder;
  const int self = builder.named("self", ProgsType::kEntity),
            health = builder.field("health", ProgsType::kFloat),
            half = builder.named("IMMEDIATE", ProgsType::kFloat),
            up = builder.named("IMMEDIATE", ProgsType::kVector), unnamed = builder.number();
  builder.progs().global_words[static_cast<std::size_t>(half)] = 0x3f000000;
  builder.progs().global_words[static_cast<std::size_t>(up) + 2] = 0x3f800000;
  const int dprint = builder.builtin("dprint", 25);
  builder.function("main");
  builder.emit(Opcode::kLoadF, self, health, unnamed);
  builder.emit(Opcode::kMulF, unnamed, half, 4);
  builder.emit(Opcode::kIfNot, unnamed, -2);
  builder.emit(Opcode::kStoreV, up, 7);
  builder.emit(Opcode::kCall2, dprint);
  builder.emit(Opcode::kReturn, 1);
  const auto program = builder.load();
  const std::string n = std::to_string(unnamed);
  EXPECT_EQ(disassemble(*program, program->find_function("main")),
            "     1  LOAD_F     self, health, " + n + "\n" +    //
                "     2  MUL_F      " + n + ", 0.5, parm0\n" +  //
                "     3  IFNOT      " + n + ", to 1\n" +        //
                "     4  STORE_V    '0 0 1', parm1\n" +         //
                "     5  CALL2      dprint\n" +                 //
                "     6  RETURN     return\n");
  EXPECT_EQ(disassemble(*program, program->find_function("dprint")), "built-in function 25\n");
}

}  // namespace
}  // namespace temblor::vm
