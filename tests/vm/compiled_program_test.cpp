// Typical QuakeC source, compiled by fteqcc.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/programs/quakec.h"
#include "vm/machine.h"

namespace temblor::vm {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr std::string_view kBegin = R"(
entity self, other, world; float time;
void end_sys_globals;
.float nextthink, frame, health; .void() think; .vector origin; .entity enemy; .string netname;
void end_sys_fields;
void(string s, ...) dprint = #25;
string(float a) ftos = #26;
)";

// Runs the program's function `main`, and returns the text that it printed.
std::vector<std::string> printed(Machine& io_machine) {
  std::vector<std::string> lines;
  io_machine.add_builtin(25, "dprint", [&](Machine& machine) -> base::Status {
    std::string line;
    for (int i = 0; i < machine.parameter_count(); ++i) line += machine.parameter_text(i);
    lines.push_back(line);
    return base::Ok{};
  });
  io_machine.add_builtin(26, "ftos", [](Machine& machine) -> base::Status {
    TRY(const StringIndex text, machine.make_string(fmt::format("{:g}", machine.parameter_float(0))));
    machine.return_string(text);
    return base::Ok{};
  });
  const base::Status status = io_machine.call(io_machine.program().find_function("main"));
  if (!status.ok()) lines.push_back("error: " + status.error().what);
  return lines;
}

TEST(CompiledProgram, RecursesAndCallsBuiltIns) {
  QUAKEC_OR_SKIP(program, std::string(kBegin) + R"(
float(float n) fib = { if (n < 2) return n; return fib(n - 1) + fib(n - 2); };
void() main = { dprint("fib ", ftos(fib(20))); };
)");
  Machine machine(program);
  EXPECT_THAT(printed(machine), ElementsAre("fib 6765"));
}

TEST(CompiledProgram, WorksOnEntities) {
  QUAKEC_OR_SKIP(program, std::string(kBegin) + R"(
void() main = {
  self.origin = self.origin + '1 2 3' * 2;
  self.enemy = self;
  self.enemy.origin_y = 7;
  self.netname = "ogre";
  if (self.enemy.netname == "ogre" && self.origin_z == 6) dprint(ftos(self.origin * '1 1 1'));
};
)");
  Machine machine(program);
  ASSERT_TRUE(machine.set_entity_count(3).ok());
  machine.set_global_entity(GlobalIndex{program->find_global("self")->offset}, EntityIndex{2});
  EXPECT_THAT(printed(machine), ElementsAre("15"));
}

}  // namespace
}  // namespace temblor::vm
