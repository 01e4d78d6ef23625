// Each operation alone, with operands in the globals that it refers to.
#include "vm/code/opcodes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "support/programs/progs_builder.h"
#include "support/random.h"
#include "vm/machine.h"

namespace temblor::vm {
namespace {

using formats::ProgsType;
using test::ProgsBuilder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

using Words = std::array<std::uint32_t, 3>;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN(),
                kInfinity = std::numeric_limits<float>::infinity();

std::uint32_t word(float value) {
  return std::bit_cast<std::uint32_t>(value);
}
Words words(float x, float y = 0, float z = 0) {
  return {word(x), word(y), word(z)};
}

// Runs `opcode`, and returns its third operand, which was 7, 8, 9 before.
Words result_words(Opcode opcode, const Words& a, const Words& b) {
  ProgsBuilder builder;
  const int a_at = builder.words({a[0], a[1], a[2]}), b_at = builder.words({b[0], b[1], b[2]}),
            c_at = builder.vector(7, 8, 9);
  builder.function("test");
  builder.emit(opcode, a_at, b_at, c_at);
  builder.emit(Opcode::kDone);
  Machine machine(builder.load());
  const base::Status status = machine.call(FunctionIndex{1});
  EXPECT_TRUE(status.ok()) << status.error().message();
  const auto globals = machine.global_words();
  const auto at = static_cast<std::size_t>(c_at);
  return {globals[at], globals[at + 1], globals[at + 2]};
}

float result(Opcode opcode, float a, float b) {
  const Words c = result_words(opcode, words(a), words(b));
  EXPECT_EQ(c[1], word(8));  // a number is one word
  return std::bit_cast<float>(c[0]);
}

math::Vec3 vector_result(Opcode opcode, const Words& a, const Words& b) {
  const Words c = result_words(opcode, a, b);
  return {std::bit_cast<float>(c[0]), std::bit_cast<float>(c[1]), std::bit_cast<float>(c[2])};
}

TEST(Opcodes, Arithmetic) {
  EXPECT_EQ(result(Opcode::kMulF, 3, -2.5f), -7.5f);
  EXPECT_EQ(result(Opcode::kDivF, 1, 8), 0.125f);
  EXPECT_EQ(result(Opcode::kAddF, 0.1f, 0.2f), 0.1f + 0.2f);
  EXPECT_EQ(result(Opcode::kSubF, 2, 5), -3);
  EXPECT_EQ(result(Opcode::kDivF, 1, 0), kInfinity);
  EXPECT_EQ(result(Opcode::kDivF, -1, 0), -kInfinity);
  EXPECT_TRUE(std::isnan(result(Opcode::kDivF, 0, 0)));
}

TEST(Opcodes, Vectors) {
  EXPECT_EQ(vector_result(Opcode::kAddV, words(1, 2, 3), words(10, 20, 30)), math::Vec3(11, 22, 33));
  EXPECT_EQ(vector_result(Opcode::kSubV, words(1, 2, 3), words(10, 20, 30)), math::Vec3(-9, -18, -27));
  EXPECT_EQ(vector_result(Opcode::kMulVF, words(1, 2, 3), words(2, 100, 100)), math::Vec3(2, 4, 6));
  EXPECT_EQ(vector_result(Opcode::kMulFV, words(2, 100, 100), words(1, 2, 3)), math::Vec3(2, 4, 6));
  EXPECT_EQ(vector_result(Opcode::kMulV, words(1, 2, 3), words(4, 5, 6)), math::Vec3(32, 8, 9));
}

// Both operands and the result are the same global, as in compiled code.
TEST(Opcodes, VectorsInPlace) {
  for (const auto& [opcode, expected] :
       {std::pair(Opcode::kAddV, math::Vec3(2, 4, 6)), std::pair(Opcode::kSubV, math::Vec3(0, 0, 0)),
        std::pair(Opcode::kMulVF, math::Vec3(1, 2, 3)), std::pair(Opcode::kMulFV, math::Vec3(1, 2, 3))}) {
    ProgsBuilder builder;
    const int at = builder.vector(1, 2, 3);
    builder.function("test");
    builder.emit(opcode, at, at, at);
    builder.emit(Opcode::kDone);
    Machine machine(builder.load());
    ASSERT_TRUE(machine.call(FunctionIndex{1}).ok());
    EXPECT_EQ(machine.global_vector(GlobalIndex{static_cast<std::uint32_t>(at)}), expected)
        << opcode_info(opcode).name;
  }
}

TEST(Opcodes, Comparisons) {
  struct Case {
    float a, b;
    std::array<float, 6> expected;  // ==, !=, <=, >=, <, >
  };
  for (const Case& c :
       {Case{1, 1, {1, 0, 1, 1, 0, 0}}, Case{1, 2, {0, 1, 1, 0, 1, 0}}, Case{2, 1, {0, 1, 0, 1, 0, 1}},
        Case{0.0f, -0.0f, {1, 0, 1, 1, 0, 0}}, Case{kNaN, 1, {0, 1, 0, 0, 0, 0}},
        Case{kNaN, kNaN, {0, 1, 0, 0, 0, 0}}, Case{-kInfinity, kInfinity, {0, 1, 1, 0, 1, 0}}}) {
    const std::array<float, 6> actual = {result(Opcode::kEqF, c.a, c.b), result(Opcode::kNeF, c.a, c.b),
                                         result(Opcode::kLe, c.a, c.b),  result(Opcode::kGe, c.a, c.b),
                                         result(Opcode::kLt, c.a, c.b),  result(Opcode::kGt, c.a, c.b)};
    EXPECT_EQ(actual, c.expected) << c.a << " and " << c.b;
  }
}

TEST(Opcodes, ComparisonsOfVectorsLookAtAllThree) {
  const Words a = words(1, 2, 3);
  EXPECT_EQ(result_words(Opcode::kEqV, a, a)[0], word(1));
  EXPECT_EQ(result_words(Opcode::kNeV, a, a)[0], 0u);
  for (const Words& b : {words(0, 2, 3), words(1, 0, 3), words(1, 2, 0)}) {
    EXPECT_EQ(result_words(Opcode::kEqV, a, b)[0], 0u);
    EXPECT_EQ(result_words(Opcode::kNeV, a, b)[0], word(1));
  }
  EXPECT_EQ(result_words(Opcode::kEqV, words(0, -0.0f, 0), words(-0.0f, 0, 0))[0], word(1));
}

TEST(Opcodes, EntitiesAndFunctionsAreComparedAsWords) {
  for (const Opcode equal : {Opcode::kEqE, Opcode::kEqFnc}) {
    EXPECT_EQ(result_words(equal, {5}, {5})[0], word(1));
    EXPECT_EQ(result_words(equal, {5}, {6})[0], 0u);
    EXPECT_EQ(result_words(equal, {0}, {0x80000000})[0], 0u);
  }
  for (const Opcode different : {Opcode::kNeE, Opcode::kNeFnc}) {
    EXPECT_EQ(result_words(different, {5}, {5})[0], 0u);
    EXPECT_EQ(result_words(different, {5}, {6})[0], word(1));
  }
  for (const Opcode is_nothing : {Opcode::kNotEnt, Opcode::kNotFnc}) {
    EXPECT_EQ(result_words(is_nothing, {0}, {})[0], word(1));
    EXPECT_EQ(result_words(is_nothing, {1}, {})[0], 0u);
  }
}

TEST(Opcodes, Truth) {
  for (const float a : {0.0f, -0.0f, 1.0f, -3.0f, 1e-40f, kNaN, kInfinity}) {
    const bool is_true = !(a == 0);
    EXPECT_EQ(result(Opcode::kNotF, a, 0), is_true ? 0 : 1) << a;
    for (const float b : {0.0f, 2.0f}) {
      EXPECT_EQ(result(Opcode::kAnd, a, b), is_true && b != 0 ? 1 : 0) << a << " " << b;
      EXPECT_EQ(result(Opcode::kOr, a, b), is_true || b != 0 ? 1 : 0) << a << " " << b;
    }
  }
  EXPECT_EQ(result_words(Opcode::kNotV, words(0, -0.0f, 0), {})[0], word(1));
  for (const Words& v : {words(1, 0, 0), words(0, 1, 0), words(0, 0, 1)})
    EXPECT_EQ(result_words(Opcode::kNotV, v, {})[0], 0u);
}

TEST(Opcodes, BitsOfWholeNumbers) {
  EXPECT_EQ(result(Opcode::kBitAnd, 12, 10), 8);
  EXPECT_EQ(result(Opcode::kBitOr, 12, 10), 14);
  EXPECT_EQ(result(Opcode::kBitAnd, 12.9f, 10.9f), 8);
  EXPECT_EQ(result(Opcode::kBitOr, -0.9f, 0.9f), 0);
  EXPECT_EQ(result(Opcode::kBitAnd, -1, 255), 255);
  EXPECT_EQ(result(Opcode::kBitOr, -2, 1), -1);
  // Values that do not fit into 32 bits become the smallest integer.
  for (const float odd : {kNaN, kInfinity, -kInfinity, 3e9f, -3e9f, 0x1p31f})
    EXPECT_EQ(result(Opcode::kBitOr, odd, 0), -0x1p31f) << odd;
  EXPECT_EQ(result(Opcode::kBitOr, -0x1p31f, 0), -0x1p31f);
}

TEST(Opcodes, Stores) {
  for (const Opcode opcode : {Opcode::kStoreF, Opcode::kStoreS, Opcode::kStoreEnt, Opcode::kStoreFld,
                              Opcode::kStoreFnc, Opcode::kStoreV}) {
    ProgsBuilder builder;
    const int from = builder.words({1, 2, 3}), to = builder.words({7, 8, 9});
    builder.function("test");
    builder.emit(opcode, from, to);
    builder.emit(Opcode::kDone);
    Machine machine(builder.load());
    ASSERT_TRUE(machine.call(FunctionIndex{1}).ok());
    const auto stored = machine.global_words().subspan(static_cast<std::size_t>(to), 3);
    if (opcode == Opcode::kStoreV) {
      EXPECT_THAT(stored, ElementsAre(1, 2, 3));
    } else {
      EXPECT_THAT(stored, ElementsAre(1, 8, 9)) << opcode_info(opcode).name;
    }
  }
}

// Text operands. The builder makes them; other bytes precede the second one.
float text_result(Opcode opcode, std::string_view a, std::string_view b) {
  ProgsBuilder builder;
  const int a_at = builder.text(a), b_at = builder.text(b), c_at = builder.number();
  builder.function("test");
  builder.emit(opcode, a_at, b_at, c_at);
  builder.emit(Opcode::kDone);
  Machine machine(builder.load());
  EXPECT_TRUE(machine.call(FunctionIndex{1}).ok());
  return machine.global_float(GlobalIndex{static_cast<std::uint32_t>(c_at)});
}

TEST(Opcodes, Strings) {
  EXPECT_EQ(text_result(Opcode::kEqS, "ogre", "ogre"), 1);
  EXPECT_EQ(text_result(Opcode::kEqS, "ogre", "ogr"), 0);
  EXPECT_EQ(text_result(Opcode::kEqS, "", ""), 1);
  EXPECT_EQ(text_result(Opcode::kNeS, "ogre", "ogre"), 0);
  // NE_S returns the sign of the comparison, not 1.
  EXPECT_GT(text_result(Opcode::kNeS, "ogre", "knight"), 0);
  EXPECT_LT(text_result(Opcode::kNeS, "knight", "ogre"), 0);
  EXPECT_GT(text_result(Opcode::kNeS, "\xff", "a"), 0);
  EXPECT_EQ(text_result(Opcode::kNotS, "", "x"), 1);
  EXPECT_EQ(text_result(Opcode::kNotS, "x", ""), 0);
}

TEST(Opcodes, StringsMayBeginInsideOthers) {
  ProgsBuilder builder;
  const int text = builder.text("grunt");
  const int tail = builder.words({builder.progs().global_words[static_cast<std::size_t>(text)] + 2}),
            runt = builder.text("unt"), c = builder.number();
  builder.function("test");
  builder.emit(Opcode::kEqS, tail, runt, c);
  builder.emit(Opcode::kDone);
  Machine machine(builder.load());
  ASSERT_TRUE(machine.call(FunctionIndex{1}).ok());
  EXPECT_EQ(machine.global_float(GlobalIndex{static_cast<std::uint32_t>(c)}), 1);
}

// Returns whether a branch that tests `value` is taken.
bool goes(Opcode branch, std::uint32_t value) {
  ProgsBuilder builder;
  const int tested = builder.words({value}), yes = builder.number(1), no = builder.number(2);
  builder.function("test");
  const int jump = builder.emit(branch, tested);
  builder.emit(Opcode::kReturn, no);
  builder.land(jump);
  builder.emit(Opcode::kReturn, yes);
  Machine machine(builder.load());
  EXPECT_TRUE(machine.call(FunctionIndex{1}).ok());
  return machine.returned_float() == 1;
}

TEST(Opcodes, BranchesTestTheRawWord) {
  EXPECT_FALSE(goes(Opcode::kIf, 0));
  EXPECT_TRUE(goes(Opcode::kIfNot, 0));
  for (const std::uint32_t value : {word(1), word(-0.0f), 1u, 0xffffffffu, word(kNaN)}) {
    EXPECT_TRUE(goes(Opcode::kIf, value)) << value;
    EXPECT_FALSE(goes(Opcode::kIfNot, value)) << value;
  }
}

TEST(Opcodes, ReturnGivesThreeWordsAndDoneNothing) {
  ProgsBuilder builder;
  const int value = builder.vector(4, 5, 6);
  builder.function("vector");
  builder.emit(Opcode::kReturn, value);
  builder.function("nothing");
  builder.emit(Opcode::kDone);
  const int last = builder.number(3);  // the two words after it do not belong to the program
  builder.function("last");
  builder.emit(Opcode::kReturn, last + 1);
  Machine machine(builder.load());
  ASSERT_EQ(machine.global_words().size(), static_cast<std::size_t>(last + 2));
  ASSERT_TRUE(machine.call(FunctionIndex{1}).ok());
  EXPECT_EQ(machine.returned_vector(), math::Vec3(4, 5, 6));
  ASSERT_TRUE(machine.call(FunctionIndex{2}).ok());
  EXPECT_EQ(machine.returned_vector(), math::Vec3(0, 0, 0));
  ASSERT_TRUE(machine.call(FunctionIndex{3}).ok());
  EXPECT_EQ(machine.global_words()[1], 3u);  // the function's own number
}

TEST(Opcodes, CallsPassParametersOfOneAndThreeWords) {
  ProgsBuilder builder;
  const int sum = builder.number(), dot = builder.number();
  const int inner = builder.function("inner", {1, 3, 1}, 2), p = builder.locals();
  builder.emit(Opcode::kMulVF, p + 1, p, p + 1);
  builder.emit(Opcode::kStoreF, p + 4, p + 5);
  builder.emit(Opcode::kReturn, p + 1);
  builder.function("outer");
  for (const auto& [value, parameter] : {std::pair(2.0f, 4), std::pair(9.0f, 10)})
    builder.emit(Opcode::kStoreF, builder.number(value), parameter);
  builder.emit(Opcode::kStoreV, builder.vector(1, 2, 3), 7);
  builder.emit(Opcode::kCall3, inner);
  builder.emit(Opcode::kMulV, 1, 1, dot);
  builder.emit(Opcode::kAddF, p + 5, sum, sum);  // the local's old value is back
  builder.emit(Opcode::kReturn, dot);
  Machine machine(builder.load());
  machine.set_global_float(GlobalIndex{static_cast<std::uint32_t>(p + 5)}, 77);
  ASSERT_TRUE(machine.call(FunctionIndex{2}).ok());
  EXPECT_EQ(machine.returned_float(), 4 + 16 + 36);
  EXPECT_EQ(machine.global_float(GlobalIndex{static_cast<std::uint32_t>(sum)}), 77);
}

TEST(Opcodes, EveryCallCountsItsParameters) {
  for (int count = 0; count <= 8; ++count) {
    ProgsBuilder builder;
    const int function = builder.builtin("count", 1);
    builder.function("test");
    builder.emit(static_cast<Opcode>(static_cast<int>(Opcode::kCall0) + count), function);
    builder.emit(Opcode::kReturn, 1);
    Machine machine(builder.load());
    machine.add_builtin(1, "count", [](Machine& io_machine) -> base::Status {
      io_machine.return_float(static_cast<float>(io_machine.parameter_count()));
      return base::Ok{};
    });
    ASSERT_TRUE(machine.call(FunctionIndex{2}).ok());
    EXPECT_EQ(machine.returned_float(), static_cast<float>(count));
  }
}

// Entity 2 of 3, with the fields "number" (word 0), "place" (1 to 3), and "last" (4).
struct Entities {
  ProgsBuilder builder;
  int number = builder.field("number", ProgsType::kFloat), place = builder.field("place", ProgsType::kVector),
      last = builder.field("last", ProgsType::kFloat), entity = builder.words({2}),
      value = builder.vector(4, 5, 6), pointer = builder.number();
};

TEST(Opcodes, LoadsReadFields) {
  for (const Opcode opcode : {Opcode::kLoadF, Opcode::kLoadS, Opcode::kLoadEnt, Opcode::kLoadFld,
                              Opcode::kLoadFnc, Opcode::kLoadV}) {
    Entities e;
    e.builder.function("test");
    e.builder.emit(opcode, e.entity, e.place, e.value);
    e.builder.emit(Opcode::kDone);
    Machine machine(e.builder.load());
    ASSERT_TRUE(machine.set_entity_count(3).ok());
    for (std::uint32_t i = 0; i < 5; ++i)
      machine.entity(EntityIndex{2})[i] = word(10.0f + static_cast<float>(i));
    ASSERT_TRUE(machine.call(FunctionIndex{1}).ok());
    EXPECT_EQ(machine.global_vector(GlobalIndex{static_cast<std::uint32_t>(e.value)}),
              opcode == Opcode::kLoadV ? math::Vec3(11, 12, 13) : math::Vec3(11, 5, 6))
        << opcode_info(opcode).name;
  }
}

TEST(Opcodes, AddressAndStoreThroughItWriteFields) {
  for (const bool is_apart : {false, true}) {
    for (const Opcode opcode : {Opcode::kStorePF, Opcode::kStorePS, Opcode::kStorePEnt, Opcode::kStorePFld,
                                Opcode::kStorePFnc, Opcode::kStorePV}) {
      Entities e;
      e.builder.function("test");
      e.builder.emit(Opcode::kAddress, e.entity, e.place, e.pointer);
      if (is_apart) e.builder.emit(Opcode::kStoreF, e.number, e.number);
      e.builder.emit(opcode, e.value, e.pointer);
      e.builder.emit(Opcode::kDone);
      Machine machine(e.builder.load());
      ASSERT_TRUE(machine.set_entity_count(3).ok());
      ASSERT_TRUE(machine.call(FunctionIndex{1}).ok());
      EXPECT_EQ(machine.global_words()[static_cast<std::size_t>(e.pointer)], 2u * 5 + 1);
      const auto expected = opcode == Opcode::kStorePV ? words(4, 5, 6) : words(4);
      EXPECT_THAT(machine.entity(EntityIndex{2}), ElementsAre(0, expected[0], expected[1], expected[2], 0))
          << opcode_info(opcode).name;
    }
  }
}

TEST(Opcodes, StateSetsFrameAndNextThought) {
  ProgsBuilder builder;
  builder.field("nextthink", ProgsType::kFloat);
  builder.field("frame", ProgsType::kFloat);
  builder.field("think", ProgsType::kFunction);
  const int self = builder.words({1}), time = builder.number(12.3f), number = builder.number(17);
  const int test = builder.function("test");
  builder.emit(Opcode::kState, number, test);
  builder.emit(Opcode::kDone);
  Machine machine(builder.load());
  ASSERT_TRUE(machine.set_entity_count(2).ok());
  const base::Status unknown = machine.call(FunctionIndex{1});
  ASSERT_FALSE(unknown.ok());
  EXPECT_THAT(unknown.error().what, HasSubstr("STATE"));
  machine.set_state_fields({GlobalIndex{static_cast<std::uint32_t>(self)},
                            GlobalIndex{static_cast<std::uint32_t>(time)}, FieldIndex{0}, FieldIndex{1},
                            FieldIndex{2}});
  ASSERT_TRUE(machine.call(FunctionIndex{1}).ok());
  EXPECT_THAT(machine.entity(EntityIndex{1}),
              ElementsAre(word(static_cast<float>(double{12.3f} + 0.1)), word(17), 1));
}

}  // namespace
}  // namespace temblor::vm
