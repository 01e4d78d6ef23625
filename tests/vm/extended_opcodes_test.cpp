// The operations that fteqcc adds, one at a time, with values at their limits.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <string>
#include <vector>

#include "support/programs/progs_builder.h"
#include "vm/code/opcodes.h"
#include "vm/machine.h"

namespace temblor::vm {
namespace {

using formats::ProgsType;
using test::ProgsBuilder;
using ::testing::HasSubstr;

std::uint32_t float_bits(float value) {
  return std::bit_cast<std::uint32_t>(value);
}

// Runs `opcode`, and returns its third operand.
std::uint32_t computed(Opcode opcode, std::uint32_t a, std::uint32_t b) {
  ProgsBuilder builder;
  const int a_at = builder.words({a}), b_at = builder.words({b}), c_at = builder.words({77});
  builder.function("test");
  builder.emit(opcode, a_at, b_at, c_at);
  builder.emit(Opcode::kDone);
  Machine machine(builder.load());
  const base::Status status = machine.call(FunctionIndex{1});
  EXPECT_TRUE(status.ok()) << status.error().message();
  return machine.global_words()[static_cast<std::size_t>(c_at)];
}

TEST(ExtendedOpcodes, IntegersWrapAround) {
  constexpr std::uint32_t kLeast = 0x80000000, kMost = 0x7fffffff, kMinusOne = 0xffffffff;
  EXPECT_EQ(computed(Opcode::kAddI, kMost, 1), kLeast);
  EXPECT_EQ(computed(Opcode::kSubI, kLeast, 1), kMost);
  EXPECT_EQ(computed(Opcode::kMulI, 0x10000, 0x10001), 0x10000u);
  EXPECT_EQ(computed(Opcode::kMulI, kMinusOne, 5), static_cast<std::uint32_t>(-5));
  EXPECT_EQ(computed(Opcode::kDivI, static_cast<std::uint32_t>(-7), 2), static_cast<std::uint32_t>(-3));
  EXPECT_EQ(computed(Opcode::kDivI, kLeast, kMinusOne), kLeast);
  EXPECT_EQ(computed(Opcode::kShiftLeftI, 3, 31), kLeast);
  EXPECT_EQ(computed(Opcode::kShiftLeftI, 3, 33), 6u);
  EXPECT_EQ(computed(Opcode::kShiftRightI, kLeast, 31), kMinusOne);
  EXPECT_EQ(computed(Opcode::kXorI, 6, 3), 5u);
  EXPECT_EQ(computed(Opcode::kBitAndI, 6, 3), 2u);
  EXPECT_EQ(computed(Opcode::kBitOrI, 6, 3), 7u);
  EXPECT_EQ(computed(Opcode::kFToI, float_bits(-2.9f), 0), static_cast<std::uint32_t>(-2));
  EXPECT_EQ(computed(Opcode::kFToI, float_bits(1e20f), 0), kLeast);
  EXPECT_EQ(computed(Opcode::kIToF, kMinusOne, 0), float_bits(-1));
}

// The truth values of all comparisons, for operands that are less, equal, and greater.
TEST(ExtendedOpcodes, Compare) {
  struct Comparison {
    Opcode integers, integer_float, float_integer;
    std::array<std::uint32_t, 3> expected;
  };
  constexpr Opcode kNone = Opcode::kDone;
  const std::vector<Comparison> comparisons = {{Opcode::kLtI, Opcode::kLtIF, Opcode::kLtFI, {1, 0, 0}},
                                               {Opcode::kLeI, Opcode::kLeIF, Opcode::kLeFI, {1, 1, 0}},
                                               {Opcode::kGtI, Opcode::kGtIF, Opcode::kGtFI, {0, 0, 1}},
                                               {Opcode::kGeI, Opcode::kGeIF, Opcode::kGeFI, {0, 1, 1}},
                                               {Opcode::kEqI, Opcode::kEqIF, kNone, {0, 1, 0}},
                                               {Opcode::kNeI, Opcode::kNeIF, kNone, {1, 0, 1}}};
  for (const Comparison& comparison : comparisons)
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = static_cast<int>(i) - 1;
      const auto integer = static_cast<std::uint32_t>(a);
      const std::uint32_t number = float_bits(static_cast<float>(a)), expected = comparison.expected[i];
      EXPECT_EQ(computed(comparison.integers, integer, 0), expected) << a;
      EXPECT_EQ(computed(comparison.integer_float, integer, float_bits(0)), expected) << a;
      if (comparison.float_integer != kNone) {
        EXPECT_EQ(computed(comparison.float_integer, number, 0), expected) << a;
      }
    }
}

// A program with an array of four words, 10 to 13, whose last index is in the word before it.
struct ArrayProgram {
  ProgsBuilder builder;
  int health = builder.field("health", ProgsType::kFloat),
      origin = builder.field("origin", ProgsType::kVector), last = builder.words({3}),
      array = builder.words({10, 11, 12, 13}), index = builder.words({0}), pointer = builder.words({0}),
      result = builder.words({77, 77, 77});

  std::string error;

  // Runs the statements that `emit` appends, and returns `result`.
  template <typename Emit>
  std::uint32_t run(std::uint32_t index_value, Emit emit, bool protect = false) {
    ProgsBuilder copy = builder;
    copy.progs().global_words[static_cast<std::size_t>(index)] = index_value;
    copy.function("test");
    emit(copy);
    copy.emit(Opcode::kDone);
    Machine machine(copy.load());
    EXPECT_TRUE(machine.set_entity_count(2).ok());
    machine.entity(EntityIndex{1})[0] = 99;
    machine.protect_world(protect);
    const base::Status status = machine.call(FunctionIndex{1});
    error = status.ok() ? "no error" : status.error().what;
    return machine.global_words()[static_cast<std::size_t>(result)];
  }
};

TEST(ExtendedOpcodes, ArraysAreChecked) {
  ArrayProgram program;
  const auto load = [&](Opcode opcode) {
    return [&, opcode](ProgsBuilder& io_builder) {
      io_builder.emit(opcode, program.array, program.index, program.result);
    };
  };
  EXPECT_EQ(program.run(2, load(Opcode::kLoadArrayF)), 12u);
  EXPECT_EQ(program.run(static_cast<std::uint32_t>(-1), load(Opcode::kLoadArrayI)), 3u);
  for (const std::uint32_t index : {0x7fffffffu, 0x80000000u, 100'000u, static_cast<std::uint32_t>(-100)}) {
    EXPECT_EQ(program.run(index, load(Opcode::kLoadArrayF)), 77u);
    EXPECT_THAT(program.error, HasSubstr("is not an index of the array"));
    program.run(index, load(Opcode::kLoadArrayV));
    EXPECT_THAT(program.error, HasSubstr("is not an index of the array"));
    program.run(index, load(Opcode::kGetPointer));
    EXPECT_THAT(program.error, HasSubstr("is not an index of the array"));
  }
  EXPECT_EQ(program.run(float_bits(3.9f), load(Opcode::kFetchGlobalF)), 13u);
  for (const float index : {4.0f, -1.0f, 1e20f}) {
    program.run(float_bits(index), load(Opcode::kFetchGlobalF));
    EXPECT_THAT(program.error, HasSubstr("is not an index of the array")) << index;
  }
  for (const auto& [index, is_good] : {std::pair(2u, false), std::pair(3u, true), std::pair(6u, true),
                                       std::pair(7u, false), std::pair(0xffffffffu, false)}) {
    program.run(index,
                [&](ProgsBuilder& io_builder) { io_builder.emit(Opcode::kBoundCheck, program.index, 7, 3); });
    EXPECT_THAT(program.error, HasSubstr(is_good ? "no error" : "is not an index")) << index;
  }
}

TEST(ExtendedOpcodes, PointersLeadToGlobalsAndEntities) {
  ArrayProgram program;
  const int three = program.builder.words({3}), one = program.builder.words({1}),
            two = program.builder.number(2);
  EXPECT_EQ(program.run(0,
                        [&](ProgsBuilder& io_builder) {
                          io_builder.emit(Opcode::kGetPointer, program.array, program.index, program.pointer);
                          io_builder.emit(Opcode::kLoadPF, program.pointer, three, program.result);
                        }),
            13u);
  EXPECT_EQ(program.run(0,
                        [&](ProgsBuilder& io_builder) {
                          io_builder.emit(Opcode::kAddress, one, program.health, program.pointer);
                          io_builder.emit(Opcode::kLoadPI, program.pointer, program.index, program.result);
                        }),
            99u);
  // A vector must not leave its entity, and the protected world must not change.
  const auto change_world = [&](ProgsBuilder& io_builder) {
    io_builder.emit(Opcode::kAddStorePF, two, program.index);
  };
  program.run(0, change_world);
  EXPECT_EQ(program.error, "no error");
  program.run(0, change_world, true);
  EXPECT_THAT(program.error, HasSubstr("it writes through the pointer 0x0"));
  for (const auto& [pointer, is_good] :
       {std::pair(5u, true), std::pair(6u, false), std::pair(7u, false), std::pair(0xffffffffu, false)}) {
    program.run(pointer, [&](ProgsBuilder& io_builder) {
      io_builder.emit(Opcode::kLoadPV, program.index, 0, program.result);
      io_builder.emit(Opcode::kAddStorePV, program.result, program.index);
    });
    EXPECT_THAT(program.error, HasSubstr(is_good ? "no error" : "it reads through the pointer")) << pointer;
  }
  // Word 0 is the zero of every program.
  program.run(0x80000000, change_world);
  EXPECT_THAT(program.error, HasSubstr("it writes through the pointer 0x80000000"));
}

TEST(ExtendedOpcodes, CallsPassTwoOperands) {
  ProgsBuilder builder;
  const int vector = builder.vector(1, 2, 3), number = builder.number(4);
  const int callee = builder.function("callee", {3, 1});
  builder.emit(Opcode::kAddV, builder.locals(), builder.locals(), 4);
  builder.emit(Opcode::kReturn, builder.locals() + 3);
  builder.function("test");
  builder.emit(Opcode::kCall2H, callee, vector, number);
  builder.emit(Opcode::kDone);
  Machine machine(builder.load());
  const base::Status status = machine.call(FunctionIndex{2});
  ASSERT_TRUE(status.ok()) << status.error().message();
  EXPECT_EQ(machine.parameter_vector(0), math::Vec3(2, 4, 6));
  EXPECT_EQ(machine.parameter_float(1), 4);
}

}  // namespace
}  // namespace temblor::vm
