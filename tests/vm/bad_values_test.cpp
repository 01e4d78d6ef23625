// Programs that load, and then use invalid values: each one ends with an error that names the value, and the
// machine can be called again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/programs/progs_builder.h"
#include "vm/machine.h"

namespace temblor::vm {
namespace {

using formats::ProgsType;
using test::ProgsBuilder;
using ::testing::HasSubstr;

constexpr std::uint32_t kEntities = 3, kWords = 5;

// A program with entities of five words, including "number" and "place", and three words for values.
struct Bad {
  ProgsBuilder builder;
  int number = builder.field("number", ProgsType::kFloat), place = builder.field("place", ProgsType::kVector),
      last = builder.field("last", ProgsType::kFloat), a = builder.words({0, 0, 0}),
      b = builder.words({0, 0, 0}), c = builder.words({0, 0, 0});

  // Runs the statement with these values. Returns its error, or "no error" if they are valid.
  std::string error_text(Opcode opcode, std::uint32_t a_value, std::uint32_t b_value, bool protect = false) {
    ProgsBuilder copy = builder;
    copy.progs().global_words[static_cast<std::size_t>(a)] = a_value;
    copy.progs().global_words[static_cast<std::size_t>(b)] = b_value;
    copy.function("test");
    copy.emit(opcode, a, b, c);
    copy.emit(Opcode::kDone);
    copy.function("good");
    copy.emit(Opcode::kDone);
    Machine machine(copy.load());
    EXPECT_TRUE(machine.set_entity_count(kEntities).ok());
    machine.protect_world(protect);
    const base::Status status = machine.call(FunctionIndex{1});
    EXPECT_TRUE(machine.call(FunctionIndex{2}).ok());
    if (status.ok()) return "no error";
    EXPECT_THAT(status.error().what, HasSubstr("; in test (test.qc), statement 1"));
    return status.error().what;
  }
};

const std::vector<std::uint32_t> kHuge = {0x7fffffff, 0x80000000, 0xffffffff, 0x33333334};

TEST(BadValues, Entities) {
  Bad bad;
  for (const Opcode opcode : {Opcode::kLoadF, Opcode::kLoadV, Opcode::kAddress}) {
    EXPECT_EQ(bad.error_text(opcode, kEntities - 1, 0), "no error");
    EXPECT_THAT(bad.error_text(opcode, kEntities, 0), HasSubstr("0x3 is not an entity (there are 3)"));
    for (const std::uint32_t entity : kHuge)
      EXPECT_THAT(bad.error_text(opcode, entity, 0), HasSubstr("is not an entity"));
  }
}

TEST(BadValues, Fields) {
  Bad bad;
  for (const Opcode opcode : {Opcode::kLoadF, Opcode::kAddress}) {
    EXPECT_EQ(bad.error_text(opcode, 2, kWords - 1), "no error");
    EXPECT_THAT(bad.error_text(opcode, 2, kWords), HasSubstr("0x5 is not a field"));
    for (const std::uint32_t field : kHuge)
      EXPECT_THAT(bad.error_text(opcode, 2, field), HasSubstr("is not a field"));
  }
  EXPECT_EQ(bad.error_text(Opcode::kLoadV, 2, kWords - 3), "no error");
  for (const std::uint32_t field : {kWords - 2, kWords - 1})
    EXPECT_THAT(bad.error_text(Opcode::kLoadV, 2, field), HasSubstr("a vector at word"));
  for (const std::uint32_t field : kHuge)
    EXPECT_THAT(bad.error_text(Opcode::kLoadV, 2, field), HasSubstr("is not a field"));
}

TEST(BadValues, Pointers) {
  Bad bad;
  EXPECT_EQ(bad.error_text(Opcode::kStorePF, 1, kEntities * kWords - 1), "no error");
  EXPECT_THAT(bad.error_text(Opcode::kStorePF, 1, kEntities * kWords),
              HasSubstr("writes through the pointer 0xf"));
  for (const std::uint32_t pointer : kHuge)
    for (const Opcode opcode : {Opcode::kStorePF, Opcode::kStorePV})
      EXPECT_THAT(bad.error_text(opcode, 1, pointer), HasSubstr("writes through"));
  EXPECT_EQ(bad.error_text(Opcode::kStorePV, 1, kEntities * kWords - 3), "no error");
  // Vectors must not extend from one entity into the next.
  for (const std::uint32_t pointer : {kWords - 2, kWords - 1, kEntities * kWords - 2, kEntities * kWords - 1})
    EXPECT_THAT(bad.error_text(Opcode::kStorePV, 1, pointer), HasSubstr("writes through"));
}

TEST(BadValues, VectorsPastTheEndOfAnEntityThroughAPairOfStatements) {
  Bad bad;
  for (std::uint32_t field = 0; field < kWords; ++field) {
    ProgsBuilder builder = bad.builder;
    const int entity = builder.words({2}), at = builder.words({field}), pointer = builder.number();
    builder.function("test");
    builder.emit(Opcode::kAddress, entity, at, pointer);
    builder.emit(Opcode::kStorePV, bad.a, pointer);
    builder.emit(Opcode::kDone);
    Machine machine(builder.load());
    ASSERT_TRUE(machine.set_entity_count(kEntities).ok());
    EXPECT_EQ(machine.call(FunctionIndex{1}).ok(), field + 3 <= kWords) << field;
  }
}

TEST(BadValues, TheWorldWhileItIsProtected) {
  Bad bad;
  EXPECT_EQ(bad.error_text(Opcode::kAddress, 0, 0), "no error");
  EXPECT_THAT(bad.error_text(Opcode::kAddress, 0, kWords - 1, true), HasSubstr("writes to the world entity"));
  EXPECT_EQ(bad.error_text(Opcode::kAddress, 1, 0, true), "no error");
  EXPECT_EQ(bad.error_text(Opcode::kLoadF, 0, 0, true), "no error");
  // A pointer that the program has computed by other means.
  EXPECT_EQ(bad.error_text(Opcode::kStorePF, 1, kWords - 1), "no error");
  EXPECT_THAT(bad.error_text(Opcode::kStorePF, 1, kWords - 1, true), HasSubstr("writes through"));
  EXPECT_THAT(bad.error_text(Opcode::kStorePV, 1, 0, true), HasSubstr("writes through"));
  EXPECT_EQ(bad.error_text(Opcode::kStorePF, 1, kWords, true), "no error");
}

TEST(BadValues, Strings) {
  Bad bad;
  const auto size = static_cast<std::uint32_t>(bad.builder.progs().strings.size() +
                                               std::string_view("test_test.qc_good_test.qc_").size());
  for (const Opcode opcode : {Opcode::kEqS, Opcode::kNeS}) {
    EXPECT_EQ(bad.error_text(opcode, size - 1, 0), "no error");
    EXPECT_THAT(bad.error_text(opcode, size, 0), HasSubstr("is not a string"));
    EXPECT_THAT(bad.error_text(opcode, 0, 0x7fffffff), HasSubstr("0x7fffffff is not a string"));
    EXPECT_THAT(bad.error_text(opcode, 0xffffffff, 0xffffffff), HasSubstr("0xffffffff is not a string"));
  }
  EXPECT_THAT(bad.error_text(Opcode::kNotS, 0x80000001, 0), HasSubstr("0x80000001 is not a string"));
}

TEST(BadValues, Functions) {
  Bad bad;
  EXPECT_EQ(bad.error_text(Opcode::kCall0, 2, 0), "no error");
  EXPECT_THAT(bad.error_text(Opcode::kCall0, 0, 0), HasSubstr("calls a function variable that is not set"));
  EXPECT_THAT(bad.error_text(Opcode::kCall8, 3, 0), HasSubstr("calls function 0x3, but there are only 3"));
  for (const std::uint32_t function : kHuge)
    EXPECT_THAT(bad.error_text(Opcode::kCall1, function, 0), HasSubstr("calls function"));
}

TEST(BadValues, SelfOfState) {
  Bad bad;
  const int time = bad.builder.number(1);
  for (const auto& [self, is_protected, is_good] :
       {std::tuple(2u, true, true), std::tuple(3u, false, false), std::tuple(0xffffffffu, false, false),
        std::tuple(0u, true, false), std::tuple(0u, false, true)}) {
    ProgsBuilder builder = bad.builder;
    const int self_at = builder.words({self});
    builder.function("test");
    builder.emit(Opcode::kState, bad.a, bad.b);
    builder.emit(Opcode::kDone);
    Machine machine(builder.load());
    ASSERT_TRUE(machine.set_entity_count(kEntities).ok());
    machine.set_state_fields({GlobalIndex{static_cast<std::uint32_t>(self_at)},
                              GlobalIndex{static_cast<std::uint32_t>(time)}, FieldIndex{0}, FieldIndex{1},
                              FieldIndex{4}});
    machine.protect_world(is_protected);
    EXPECT_EQ(machine.call(FunctionIndex{1}).ok(), is_good) << self;
  }
}

TEST(BadValues, ParametersOfBuiltInFunctions) {
  Bad bad;
  const int text = bad.builder.builtin("text", 1), entity = bad.builder.builtin("entity", 2),
            field = bad.builder.builtin("field", 3);
  for (const int function : {text, entity, field}) {
    bad.builder.function("call");
    bad.builder.emit(Opcode::kCall1, function);
    bad.builder.emit(Opcode::kDone);
  }
  Machine machine(bad.builder.load());
  machine.add_builtin(1, "text", [](Machine& io_machine) -> base::Status {
    EXPECT_EQ(io_machine.parameter_text(0), "");
    return base::Ok{};
  });
  machine.add_builtin(2, "entity", [](Machine& io_machine) -> base::Status {
    TRY([[maybe_unused]] const EntityIndex index, io_machine.parameter_entity(0));
    return base::Ok{};
  });
  machine.add_builtin(3, "field", [](Machine& io_machine) -> base::Status {
    TRY([[maybe_unused]] const FieldIndex index, io_machine.parameter_field(0));
    return base::Ok{};
  });
  const std::vector<std::string> expected = {"text: parameter 1 is not a string", "entity: parameter 1 is 0x",
                                             "field: parameter 1 is 0x"};
  for (std::uint32_t i = 0; i < 3; ++i) {
    machine.set_parameter_entity(0, kWorld);
    EXPECT_TRUE(machine.call(FunctionIndex{4 + i}).ok());
    machine.set_parameter_entity(0, EntityIndex{0x7fff0000});
    const base::Status status = machine.call(FunctionIndex{4 + i});
    ASSERT_FALSE(status.ok());
    EXPECT_THAT(status.error().what, HasSubstr(expected[i]));
    EXPECT_THAT(status.error().what, HasSubstr("; in call (test.qc), statement"));
  }
}

TEST(BadValues, RunningPastTheLastStatement) {
  Bad bad;
  bad.builder.function("test");
  const int last = bad.builder.emit(Opcode::kStoreF, bad.a, bad.b);
  Machine machine(bad.builder.load());
  const base::Status status = machine.call(FunctionIndex{1});
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().what,
              HasSubstr("past the last statement of the program; in test (test.qc), statement " +
                        std::to_string(last)));
}

}  // namespace
}  // namespace temblor::vm
