#include "vm/machine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/progs_builder.h"

namespace temblor::vm {
namespace {

using test::ProgsBuilder;
using ::testing::HasSubstr;

TEST(Machine, AddsTwoParameters) {
  ProgsBuilder builder;
  const int sum = builder.number();
  builder.function("add", {1, 1});
  builder.emit(Opcode::kAddF, builder.locals(), builder.locals() + 1, sum);
  builder.emit(Opcode::kReturn, sum);
  Machine machine(builder.load());
  machine.set_parameter_float(0, 2);
  machine.set_parameter_float(1, 3.5f);
  const base::Status status = machine.call(machine.program().find_function("add"));
  ASSERT_TRUE(status.ok()) << status.error().message();
  EXPECT_EQ(machine.returned_float(), 5.5f);
  EXPECT_EQ(machine.instructions_run(), 2u);
}

TEST(Machine, EndlessLoopEnds) {
  ProgsBuilder builder;
  builder.function("loop");
  builder.emit(Opcode::kGoto, 0);
  Machine machine(builder.load(), {.instructions = 1000});
  const base::Status status = machine.call(machine.program().find_function("loop"));
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().what,
              HasSubstr("does not end: 1000 instructions were run; in loop (test.qc), statement 1"));
  EXPECT_EQ(machine.instructions_run(), 1001u);
}

}  // namespace
}  // namespace temblor::vm
