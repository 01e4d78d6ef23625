// The number of each function: all stock numbers and extensions, and an error for all others.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "server/builtins/builtin_numbers.h"
#include "server/builtins/builtin_stage.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;

// Calls without parameters: the error names the function.
std::string error_of_number(Stage& io_stage, int number) {
  const base::Status status = io_stage.call_function(io_stage.function_of_number(number), 0);
  return status.ok() ? "" : status.error().message();
}

TEST(BuiltinNumbers, AllThatAreKnownAreThereAndNoOthers) {
  std::set<int> known;
  for (const BuiltinNumber& builtin : kStockBuiltins) known.insert(builtin.number);
  for (const BuiltinNumber& builtin : kExtensionBuiltins) known.insert(builtin.number);
  EXPECT_EQ(known.size(), std::size(kStockBuiltins) + std::size(kExtensionBuiltins));
  // The reference lists the numbers that stock Quake leaves out; extensions took some of them.
  for (const int unused : {0, 5, 33, 39, 42, 50, 63, 64, 66, 71}) EXPECT_FALSE(known.contains(unused));

  Stage stage;
  for (int number = 0; number <= kMaxBuiltin; ++number) {
    SCOPED_TRACE(number);
    const std::string error = error_of_number(stage, number);
    if (known.contains(number)) {
      EXPECT_TRUE(error.empty() || error.find("builtin ") != std::string::npos) << error;
    } else {
      EXPECT_THAT(error, HasSubstr(number == 0 ? "number_0" : std::to_string(number)));
    }
  }
}

TEST(BuiltinNumbers, EachIsCalledWhatTheReferenceCallsIt) {
  // Parameters that hardly any function accepts: the errors name the functions.
  Stage stage;
  std::size_t named = 0;
  const auto check = [&](const BuiltinNumber& builtin) {
    for (int i = 0; i < vm::Machine::kMaxParameters; ++i) stage.set_parameter(i, RawWord{0x7fc00000});
    const base::Status status = stage.call_function(stage.function_of_number(builtin.number), 8);
    if (status.ok()) return;
    ++named;
    EXPECT_THAT(status.error().message(), HasSubstr("builtin " + std::string(builtin.name) + ": "));
  };
  for (const BuiltinNumber& builtin : kStockBuiltins) check(builtin);
  for (const BuiltinNumber& builtin : kExtensionBuiltins) check(builtin);
  EXPECT_GT(named, 40u);
}

TEST(BuiltinNumbers, NumberNoneIsFoundByName) {
  Stage stage;
  for (const std::string_view name : kNamedBuiltins)
    EXPECT_THAT(stage.error(name, RawWord{0x7fc00000}, 0), testing::AnyOf("", HasSubstr(std::string(name))));
  stage.run("ex_bprint", "all");
  ASSERT_EQ(messages_in<net::Print>(stage.outbox.reliable().view()).size(), 1u);
}

}  // namespace
}  // namespace temblor::test
