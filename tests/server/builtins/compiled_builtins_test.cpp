// Built-in functions as compiled QuakeC calls them: declared as game code does, by number and by name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/builtins/builtin_stage.h"
#include "server/system_source.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr char kProgram[] = R"(
void(vector v) makevectors = #1;
void(entity e, vector v) setorigin = #2;
void(entity e, vector low, vector high) setsize = #4;
void(string s, ...) error = #10;
vector(vector v) normalize = #9;
float(vector v) vlen = #12;
entity() spawn = #14;
void(entity e) remove = #15;
void(vector a, vector b, float kind, entity passing) traceline = #16;
entity(entity start, .string field, string match) find = #18;
entity(vector center, float radius) findradius = #22;
void(string s, ...) bprint = #23;
string(float f) ftos = #26;
string(vector v) vtos = #27;
entity(entity e) nextent = #47;
void(float to, float value) WriteByte = #52;
void(float to, float value) WriteCoord = #56;
float(string name) checkextension = #99;
entity(.float field, float match) findchainfloat = #403;
float(float a, float b, ...) min = #94;
string(string s, float first, float count) substring = #116;
string(string s, ...) sprintf = #627;
float(float a, float b, float c) bound = #0;
void(entity e, string s, ...) ex_sprint = #0;
void(float a) ex_nobody_knows = #0;
.float score;

void(float i, string tag) make = {
  local entity e;
  e = spawn();
  e.classname = tag;
  e.score = i;
  e.solid = 2;
  setsize(e, '-8 -8 -8', '8 8 8');
  setorigin(e, '256 256 64' + i * '10 0 0');
};

void() test_text = {
  bprint(ftos(1.5), "|", vtos('1 2 3'), "|", sprintf("%d %s %v", 7, "x", '1 0 2'), "|", substring("hello", 1, 2));
  bprint(ftos(min(4, 3, 5)), ftos(bound(1, 9, 5)), ftos(checkextension("DP_QC_SPRINTF")));
};

void() test_entities = {
  local entity e;
  local float i, sum;
  for (i = 0; i < 5; i = i + 1)
    if (i == 2)
      make(i, "odd");
    else
      make(i, "even");
  e = find(world, classname, "odd");
  remove(e);
  for (e = find(world, classname, "even"); e; e = find(e, classname, "even"))
    sum = sum + e.score;
  bprint(ftos(sum), " ");
  for (e = findradius('256 256 64', 15), sum = 0; e; e = e.chain)
    sum = sum * 10 + e.score + 1;
  bprint(ftos(sum), " ");
  for (e = nextent(world), sum = 0; e; e = nextent(e))
    sum = sum + 1;
  bprint(ftos(sum), " ", ftos(findchainfloat(score, 3).score));
};

void() test_world = {
  local entity passing;
  passing = spawn();
  traceline('256 256 64', '256 256 -64', 0, passing);
  bprint(vtos(trace_plane_normal), ftos(trace_ent == world));
  makevectors('0 90 0');
  bprint(vtos(normalize(v_forward * 7)), ftos(vlen('3 4 0')));
  WriteByte(0, 23);
  WriteByte(0, 11);
  WriteCoord(0, 8);
  WriteCoord(0, 16);
  WriteCoord(0, -24);
};

void(entity player) test_named = {
  ex_sprint(player, "{1} {0}", "world", "hello");
};
void() test_unknown = { ex_nobody_knows(1); };
void() test_error = { self = spawn(); error("it ", "broke"); };
)";

std::vector<std::string> prints_in(const base::ByteWriter& writer) {
  std::vector<std::string> texts;
  for (const net::Print& print : messages_in<net::Print>(writer.view())) texts.emplace_back(print.text);
  return texts;
}

// Runs one function of the program.
std::string error_text(Stage& io_stage, std::string_view function) {
  const base::Status status = io_stage.machine.call(io_stage.machine.program().find_function(function));
  return status.ok() ? "" : status.error().message();
}

class CompiledBuiltins : public ::testing::Test {
 protected:
  void SetUp() override {
    QUAKEC_OR_SKIP(program, std::string(kSystemSource) + kProgram);
    stage = std::make_unique<Stage>(net::Dialect{}, program);
    stage->world.time_s = 10;
  }
  std::unique_ptr<Stage> stage;
};

TEST_F(CompiledBuiltins, SystemDefinitionsAreQuakes) {
  EXPECT_EQ(stage->machine.program().progs().crc, 5927u);
}

TEST_F(CompiledBuiltins, Text) {
  EXPECT_EQ(error_text(*stage, "test_text"), "");
  EXPECT_THAT(prints_in(stage->outbox.reliable()),
              ElementsAre("  1.5|'  1.0   2.0   3.0'|7 x 1 0 2|el", "351"));
}

TEST_F(CompiledBuiltins, Entities) {
  EXPECT_EQ(error_text(*stage, "test_entities"), "");
  // 0 + 1 + 3 + 4; the second and, after it, the first; two players and four more; the third.
  EXPECT_THAT(prints_in(stage->outbox.reliable()), ElementsAre("8 ", "21 ", "6 3"));
}

TEST_F(CompiledBuiltins, World) {
  EXPECT_EQ(error_text(*stage, "test_world"), "");
  EXPECT_THAT(prints_in(stage->outbox.reliable()),
              ElementsAre("'  0.0   0.0   1.0'1", "'  0.0   1.0  -0.0'5"));
  const auto sent = messages_in<net::TempEntity>(stage->outbox.broadcast().view());
  ASSERT_EQ(sent.size(), 1u);
  EXPECT_EQ(sent[0].kind, net::TempEntityKind::kTeleport);
  EXPECT_EQ(sent[0].origin, math::Vec3(8, 16, -24));
}

TEST_F(CompiledBuiltins, ByName) {
  stage->machine.set_parameter_entity(0, Stage::kPlayer2);
  EXPECT_EQ(error_text(*stage, "test_named"), "");
  EXPECT_THAT(prints_in(*stage->outbox.reliable_to(Stage::kPlayer2)), ElementsAre("hello world"));
  EXPECT_THAT(error_text(*stage, "test_unknown"), HasSubstr("ex_nobody_knows"));
}

TEST_F(CompiledBuiltins, ErrorsNameTheCaller) {
  const std::string error = error_text(*stage, "test_error");
  EXPECT_THAT(error, HasSubstr("builtin error: it broke"));
  EXPECT_THAT(error, HasSubstr("test_error"));
  EXPECT_THAT(stage->printed, HasSubstr("test_error: it broke\nentity 3:"));
}

}  // namespace
}  // namespace temblor::test
