// Calls, limits, and the interface of the machine.
#include "vm/machine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/programs/progs_builder.h"

namespace temblor::vm {
namespace {

using formats::ProgsType;
using test::ProgsBuilder;
using ::testing::HasSubstr;
using ::testing::SizeIs;

std::string error_text(const base::Status& status) {
  return status.ok() ? "no error" : status.error().what;
}

GlobalIndex global(int at) {
  return GlobalIndex{static_cast<std::uint32_t>(at)};
}

// Function 1 is add(a, b), with two instructions.
ProgsBuilder adding_program() {
  ProgsBuilder builder;
  const int sum = builder.number();
  builder.function("add", {1, 1});
  builder.emit(Opcode::kAddF, builder.locals(), builder.locals() + 1, sum);
  builder.emit(Opcode::kReturn, sum);
  return builder;
}

float add(Machine& io_machine, float a, float b) {
  io_machine.set_parameter_float(0, a);
  io_machine.set_parameter_float(1, b);
  const base::Status status = io_machine.call(io_machine.program().find_function("add"));
  EXPECT_EQ(error_text(status), "no error");
  return io_machine.returned_float();
}

TEST(Machine, CallsAFunction) {
  Machine machine(adding_program().load());
  EXPECT_EQ(add(machine, 2, 3.5f), 5.5f);
  EXPECT_EQ(machine.instructions_run(), 2u);
}

TEST(Machine, TwoOfOneProgramShareNothingElse) {
  ProgsBuilder builder;
  builder.field("health", ProgsType::kFloat);
  const int count = builder.number(), one = builder.number(1);
  builder.function("count");
  builder.emit(Opcode::kAddF, count, one, count);
  builder.emit(Opcode::kReturn, count);
  const auto program = builder.load();
  Machine first(program), second(program);
  ASSERT_TRUE(first.set_entity_count(7).ok());
  ASSERT_TRUE(first.make_string("only here").ok());
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(first.call(FunctionIndex{1}).ok());
  ASSERT_TRUE(second.call(FunctionIndex{1}).ok());
  EXPECT_EQ(first.returned_float(), 3);
  EXPECT_EQ(second.returned_float(), 1);
  EXPECT_EQ(second.entity_count(), 1u);
  EXPECT_EQ(second.strings().made_count(), 0u);
}

TEST(Machine, NoFunctionIsAnError) {
  Machine machine(adding_program().load());
  EXPECT_THAT(error_text(machine.call(kNoFunction)), HasSubstr("no function 0"));
  EXPECT_THAT(error_text(machine.call(FunctionIndex{2})), HasSubstr("no function 2"));
  EXPECT_THAT(error_text(machine.call(FunctionIndex{0xffffffff})), HasSubstr("no function"));
}

// --- Programs that do not end

// A loop of `length` statements.
ProgsBuilder circle(int length) {
  ProgsBuilder builder = adding_program();
  const int x = builder.number();
  builder.function("loop");
  for (int i = 1; i < length; ++i) builder.emit(Opcode::kAddF, x, x, x);
  builder.emit(Opcode::kGoto, 1 - length);
  return builder;
}

TEST(Machine, EndlessLoopEndsWhenItsTimeIsUp) {
  for (const int length : {1, 2, 7, 100}) {
    Machine machine(circle(length).load(), {.instructions = 1000});
    EXPECT_THAT(error_text(machine.call(FunctionIndex{2})),
                HasSubstr("endless loop? Stopped after 1000 instructions; in loop (test.qc), statement "));
    EXPECT_GT(machine.instructions_run(), 1000u);
    EXPECT_LE(machine.instructions_run(), 1000u + static_cast<unsigned>(length));
    EXPECT_EQ(add(machine, 1, 2), 3);  // the machine still works
  }
}

TEST(Machine, CallsInALoopAreCountedTogether) {
  ProgsBuilder builder;
  const int nothing = builder.function("nothing");
  builder.emit(Opcode::kDone);
  builder.function("loop");
  builder.emit(Opcode::kCall0, nothing);
  builder.emit(Opcode::kGoto, -1);
  Machine machine(builder.load(), {.instructions = 999});
  EXPECT_THAT(error_text(machine.call(FunctionIndex{2})), HasSubstr("endless loop?"));
  EXPECT_GT(machine.instructions_run(), 999u);
  EXPECT_LE(machine.instructions_run(), 1002u);
}

// Slow operations count as many instructions, so a program cannot hide time in few instructions.
TEST(Machine, WorkThatGrowsCountsAsManyInstructions) {
  ProgsBuilder builder;
  const std::string text(100'000, 'x');
  const int a = builder.text(text), b = builder.text(text), c = builder.number(),
            work = builder.builtin("work", 1);
  const int large = builder.function("large", {}, 6400);
  builder.emit(Opcode::kDone);
  const int first = static_cast<int>(builder.progs().functions.size());
  builder.function("compare");
  builder.emit(Opcode::kEqS, a, b, c);
  builder.emit(Opcode::kGoto, -1);
  builder.function("call");
  builder.emit(Opcode::kCall0, large);
  builder.emit(Opcode::kGoto, -1);
  builder.function("built-in");
  builder.emit(Opcode::kCall0, work);
  builder.emit(Opcode::kGoto, -1);
  Machine machine(builder.load(), {.instructions = 100'000});
  int works = 0;
  machine.add_builtin(1, "work", [&](Machine& io_machine) -> base::Status {
    io_machine.charge(++works == 5 ? UINT64_MAX : 1000);
    return base::Ok{};
  });
  for (int i = 0; i < 3; ++i)
    EXPECT_THAT(error_text(machine.call(base::to_index<FunctionIndex>(static_cast<std::size_t>(first + i)))),
                HasSubstr("endless loop?"));
  for (const FunctionProfile& entry : machine.profile()) {
    if (entry.function != FunctionIndex{2}) continue;
    EXPECT_NEAR(static_cast<double>(entry.calls), 100'000.0 / 203, 2);
  }
  EXPECT_EQ(works, 5);
}

TEST(Machine, FailuresNameTheLineWhereItIsKnown) {
  ProgsBuilder builder;
  const int none = builder.words({0});
  builder.function("test");
  builder.emit(Opcode::kCall0, none);
  const auto program = Program::load(builder.progs(), {0, 42});
  ASSERT_TRUE(program.ok());
  Machine machine(*program);
  EXPECT_THAT(error_text(machine.call(FunctionIndex{1})), HasSubstr("; in test (test.qc:42), statement 1"));
}

TEST(Machine, EveryCallFromOutsideHasTheWholeBudget) {
  Machine machine(adding_program().load(), {.instructions = 2});
  for (int i = 0; i < 10; ++i) EXPECT_EQ(add(machine, 1, 1), 2);
}

TEST(Machine, RecursionWithoutEndEndsWithATrace) {
  ProgsBuilder builder = adding_program();
  builder.function("down", {1}, 2);
  builder.emit(Opcode::kStoreF, builder.locals(), 4);
  const int self = builder.words({2});
  builder.emit(Opcode::kCall1, self);
  builder.emit(Opcode::kDone);
  Machine machine(builder.load(), {.call_depth = 100});
  machine.set_parameter_float(0, 5);
  EXPECT_THAT(
      error_text(machine.call(FunctionIndex{2})),
      HasSubstr("the calls are 100 levels deep (endless recursion?); in down (test.qc), statement 4"));
  ASSERT_THAT(machine.failure_trace(), SizeIs(100));
  EXPECT_THAT(machine.describe(machine.failure_trace().first(2)),
              "  down (test.qc), statement 4\n  down (test.qc), statement 4\n");
  EXPECT_EQ(add(machine, 1, 2), 3);
}

TEST(Machine, LocalsOfWaitingFunctionsHaveALimit) {
  ProgsBuilder builder = adding_program();
  builder.function("down", {}, 50);
  builder.emit(Opcode::kCall0, builder.words({2}));
  builder.emit(Opcode::kDone);
  Machine machine(builder.load(), {.saved_words = 1020});
  EXPECT_THAT(error_text(machine.call(FunctionIndex{2})), HasSubstr("1050 words; the limit is 1020"));
  EXPECT_THAT(machine.failure_trace(), SizeIs(20));
  EXPECT_EQ(add(machine, 1, 2), 3);
}

TEST(Machine, LocalsAreBackAfterAFailure) {
  ProgsBuilder builder;
  const int nine = builder.number(9), none = builder.words({0});
  builder.function("fails", {}, 1);
  const int local = builder.locals();
  builder.emit(Opcode::kStoreF, nine, local);
  builder.emit(Opcode::kCall0, none);
  builder.emit(Opcode::kDone);
  Machine machine(builder.load());
  machine.set_global_float(global(local), 4);
  EXPECT_THAT(error_text(machine.call(FunctionIndex{1})),
              HasSubstr("it calls a function variable that is not set"));
  EXPECT_EQ(machine.global_float(global(local)), 4);
}

// --- Built-in functions

TEST(Machine, BuiltInFunctionsAreFoundByNumberAndName) {
  ProgsBuilder builder;
  const int numbered = builder.builtin("twice", 3), named = builder.builtin("thrice", 0),
            unknown = builder.builtin("unknown", 99), nameless = builder.builtin("nameless", 0);
  builder.function("by_number");
  builder.emit(Opcode::kCall1, numbered);
  builder.emit(Opcode::kReturn, 1);
  builder.function("by_name");
  builder.emit(Opcode::kCall1, named);
  builder.emit(Opcode::kReturn, 1);
  builder.function("by_unknown_number");
  builder.emit(Opcode::kCall1, unknown);
  builder.function("by_unknown_name");
  builder.emit(Opcode::kCall1, nameless);
  Machine machine(builder.load());
  const auto times = [](float factor) {
    return [factor](Machine& io_machine) -> base::Status {
      io_machine.return_float(factor * io_machine.parameter_float(0));
      return base::Ok{};
    };
  };
  machine.add_builtin(3, "twice", times(2));
  machine.add_named_builtin("thrice", times(3));
  machine.set_parameter_float(0, 5);
  ASSERT_TRUE(machine.call(machine.program().find_function("by_number")).ok());
  EXPECT_EQ(machine.returned_float(), 10);
  ASSERT_TRUE(machine.call(machine.program().find_function("by_name")).ok());
  EXPECT_EQ(machine.returned_float(), 15);
  ASSERT_TRUE(machine.call(machine.program().find_function("twice")).ok());  // itself
  EXPECT_EQ(machine.returned_float(), 10);
  EXPECT_THAT(error_text(machine.call(machine.program().find_function("by_unknown_number"))),
              HasSubstr("no built-in function 99 (unknown); in by_unknown_number (test.qc), statement 5"));
  EXPECT_THAT(error_text(machine.call(machine.program().find_function("by_unknown_name"))),
              HasSubstr("no built-in function 0 (nameless)"));
}

TEST(Machine, ErrorOfABuiltInFunctionNamesItAndItsCaller) {
  ProgsBuilder builder;
  const int fails = builder.builtin("fails", 1);
  builder.function("test");
  builder.emit(Opcode::kCall0, fails);
  Machine machine(builder.load());
  machine.add_builtin(1, "fails", [](Machine&) -> base::Status { return base::malformed("no such sound"); });
  EXPECT_EQ(error_text(machine.call(FunctionIndex{2})),
            "fails: no such sound; in test (test.qc), statement 1");
  EXPECT_THAT(machine.failure_trace(), SizeIs(1));
}

// test() calls again(), which calls test().
struct Circle {
  explicit Circle(Limits limits) : machine(program(), limits) {
    machine.add_builtin(1, "again", [this](Machine& io_machine) {
      deepest = std::max(deepest, ++depth);
      const base::Status status = io_machine.call(FunctionIndex{2});
      --depth;
      return status;
    });
  }
  static std::shared_ptr<const Program> program() {
    ProgsBuilder builder;
    const int again = builder.builtin("again", 1);
    builder.function("test");
    builder.emit(Opcode::kCall0, again);
    builder.emit(Opcode::kDone);
    return builder.load();
  }
  int depth = 0, deepest = 0;
  Machine machine;
};

TEST(Machine, NestedCallsHaveALimitOfTheirOwn) {
  Circle circle({.nested_calls = 10});
  const std::string what = error_text(circle.machine.call(FunctionIndex{2}));
  EXPECT_THAT(what, HasSubstr("10 levels deep; in test (test.qc), statement 1"));
  EXPECT_EQ(what.find("again: "), std::string::npos);  // only the failing function is named
  EXPECT_EQ(circle.deepest, 10);
  EXPECT_THAT(circle.machine.failure_trace(), SizeIs(10));
  EXPECT_TRUE(circle.machine.current_trace().empty());
}

TEST(Machine, NestedCallsShareDepthWithTheOuterOnes) {
  Circle circle({.call_depth = 6, .nested_calls = 100});
  EXPECT_THAT(error_text(circle.machine.call(FunctionIndex{2})), HasSubstr("the calls are 6 levels deep"));
}

TEST(Machine, NestedCallsShareTheBudgetWithTheOuterOnes) {
  ProgsBuilder builder;
  const int run = builder.builtin("run", 1);
  builder.function("loop");
  builder.emit(Opcode::kCall0, run);
  builder.emit(Opcode::kGoto, -1);
  builder.function("short");
  builder.emit(Opcode::kDone);
  Machine machine(builder.load(), {.instructions = 300});
  int calls = 0;
  machine.add_builtin(1, "run", [&](Machine& io_machine) {
    ++calls;
    return io_machine.call(FunctionIndex{3});
  });
  EXPECT_THAT(error_text(machine.call(FunctionIndex{2})), HasSubstr("endless loop?"));
  EXPECT_NEAR(calls, 100, 1);  // CALL, DONE, and GOTO each time
}

TEST(Machine, ABuiltInFunctionMayLiveWithAFailureWithinIt) {
  ProgsBuilder builder;
  const int attempt = builder.builtin("attempt", 1), none = builder.words({0}), seven = builder.number(7);
  builder.function("fails");
  builder.emit(Opcode::kCall0, none);
  builder.function("test");
  builder.emit(Opcode::kCall0, attempt);
  builder.emit(Opcode::kReturn, seven);
  Machine machine(builder.load());
  std::string inner;
  machine.add_builtin(1, "attempt", [&](Machine& io_machine) -> base::Status {
    inner = error_text(io_machine.call(FunctionIndex{2}));
    return base::Ok{};
  });
  EXPECT_EQ(error_text(machine.call(FunctionIndex{3})), "no error");
  EXPECT_THAT(inner, HasSubstr("in fails (test.qc), statement 1"));
  EXPECT_EQ(machine.returned_float(), 7);
}

TEST(Machine, BuiltInFunctionsMayMakeEntities) {
  ProgsBuilder builder;
  const int health = builder.field("health", ProgsType::kFloat), spawn = builder.builtin("spawn", 1),
            value = builder.number(50), pointer = builder.number(), read = builder.number();
  builder.function("test");
  builder.emit(Opcode::kCall0, spawn);
  builder.emit(Opcode::kAddress, 1, health, pointer);
  builder.emit(Opcode::kStorePF, value, pointer);
  builder.emit(Opcode::kLoadF, 1, health, read);
  builder.emit(Opcode::kReturn, read);
  Machine machine(builder.load());
  machine.add_builtin(1, "spawn", [](Machine& io_machine) -> base::Status {
    TRY_STATUS(io_machine.set_entity_count(5000));
    io_machine.return_entity(EntityIndex{4999});
    return base::Ok{};
  });
  EXPECT_EQ(error_text(machine.call(FunctionIndex{2})), "no error");
  EXPECT_EQ(machine.returned_float(), 50);
}

TEST(Machine, EntitiesHaveALimit) {
  ProgsBuilder builder;
  builder.field("place", ProgsType::kVector);
  Machine machine(builder.load(), {.entities = 100});
  EXPECT_TRUE(machine.set_entity_count(100).ok());
  EXPECT_THAT(error_text(machine.set_entity_count(101)),
              HasSubstr("101 entities of 3 words exceed the memory limit"));
  Machine tight(builder.load(), {.entities = 100, .entity_bytes = 10 * 12});
  EXPECT_TRUE(tight.set_entity_count(10).ok());
  EXPECT_FALSE(tight.set_entity_count(11).ok());
  EXPECT_EQ(tight.entity_count(), 10u);
}

TEST(Machine, EntitiesThatComeBackAreEmpty) {
  ProgsBuilder builder;
  builder.field("health", ProgsType::kFloat);
  Machine machine(builder.load());
  ASSERT_TRUE(machine.set_entity_count(3).ok());
  machine.entity(EntityIndex{2})[0] = 5;
  ASSERT_TRUE(machine.set_entity_count(2).ok());
  ASSERT_TRUE(machine.set_entity_count(3).ok());
  EXPECT_EQ(machine.entity(EntityIndex{2})[0], 0u);
}

// --- Tracing

TEST(Machine, ProfileCountsCallsAndOwnInstructions) {
  ProgsBuilder builder = adding_program();
  builder.function("twice");
  const int add_at = builder.words({1});
  builder.emit(Opcode::kCall2, add_at);
  builder.emit(Opcode::kCall2, add_at);
  builder.emit(Opcode::kDone);
  builder.function("unused");
  builder.emit(Opcode::kDone);
  Machine machine(builder.load());
  for (int i = 0; i < 5; ++i) ASSERT_TRUE(machine.call(FunctionIndex{2}).ok());
  const auto profile = machine.profile();
  ASSERT_THAT(profile, SizeIs(2));
  EXPECT_EQ(profile[0].function, FunctionIndex{1});
  EXPECT_EQ(profile[0].calls, 10u);
  EXPECT_EQ(profile[0].instructions, 20u);
  EXPECT_EQ(profile[1].function, FunctionIndex{2});
  EXPECT_EQ(profile[1].calls, 5u);
  EXPECT_EQ(profile[1].instructions, 15u);
  machine.reset_profile();
  EXPECT_TRUE(machine.profile().empty());
}

TEST(Machine, TracerSeesEveryStatementFromWhereItIsSet) {
  ProgsBuilder builder;
  const int on = builder.builtin("traceon", 1), off = builder.builtin("traceoff", 2),
            x = builder.named("x", ProgsType::kFloat), one = builder.number(1), test = builder.number();
  builder.function("test");
  builder.emit(Opcode::kAddF, x, one, x);
  builder.emit(Opcode::kCall0, on);
  builder.emit(Opcode::kLt, one, x, test);
  builder.emit(Opcode::kIfNot, test, 2);
  builder.emit(Opcode::kSubF, x, one, x);
  builder.emit(Opcode::kCall0, off);
  builder.emit(Opcode::kReturn, x);
  Machine machine(builder.load());
  std::vector<std::string> lines;
  machine.add_builtin(1, "traceon", [&](Machine& io_machine) -> base::Status {
    io_machine.set_tracer([&](std::string_view line) { lines.emplace_back(line); });
    return base::Ok{};
  });
  machine.add_builtin(2, "traceoff", [](Machine& io_machine) -> base::Status {
    io_machine.set_tracer(nullptr);
    return base::Ok{};
  });
  EXPECT_EQ(error_text(machine.call(FunctionIndex{3})), "no error");
  EXPECT_EQ(machine.returned_float(), 1);
  EXPECT_EQ(machine.instructions_run(), 6u);
  ASSERT_THAT(lines, SizeIs(3));
  EXPECT_THAT(lines[0], HasSubstr("LT"));
  EXPECT_THAT(lines[1], HasSubstr("IFNOT"));
  EXPECT_THAT(lines[2], HasSubstr("CALL0      traceoff"));
}

}  // namespace
}  // namespace temblor::vm
