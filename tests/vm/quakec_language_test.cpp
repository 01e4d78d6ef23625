// Programs that use the whole language of fteqcc, compiled for each of its targets.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/programs/quakec.h"
#include "vm/machine.h"

namespace temblor::vm {
namespace {

using ::testing::ElementsAreArray;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::string_view kPrelude = R"(
entity self, other, world; float time;
void end_sys_globals;
.float nextthink, frame, health; .void() think; .vector origin; .entity enemy; .string netname;
void end_sys_fields;
void(string s, ...) print = #1;
void(float f) show = #2;
void(int i) show_int = #3;
void(vector v) show_vector = #4;
entity() spawn = #5;
)";

void add_builtins(Machine& io_machine, std::vector<std::string>& out_lines) {
  io_machine.add_builtin(1, "print", [&](Machine& machine) -> base::Status {
    std::string line;
    for (int i = 0; i < machine.parameter_count(); ++i) line += machine.parameter_text(i);
    out_lines.push_back(line);
    return base::Ok{};
  });
  io_machine.add_builtin(2, "show", [&](Machine& machine) -> base::Status {
    out_lines.push_back(fmt::format("{:g}", machine.parameter_float(0)));
    return base::Ok{};
  });
  io_machine.add_builtin(3, "show_int", [&](Machine& machine) -> base::Status {
    out_lines.push_back(fmt::format("{}i", static_cast<std::int32_t>(machine.parameter_string(0))));
    return base::Ok{};
  });
  io_machine.add_builtin(4, "show_vector", [&](Machine& machine) -> base::Status {
    const math::Vec3 v = machine.parameter_vector(0);
    out_lines.push_back(fmt::format("{:g} {:g} {:g}", v.x, v.y, v.z));
    return base::Ok{};
  });
  io_machine.add_builtin(5, "spawn", [](Machine& machine) -> base::Status {
    TRY_STATUS(machine.set_entity_count(machine.entity_count() + 1));
    machine.return_entity(EntityIndex{machine.entity_count() - 1});
    return base::Ok{};
  });
}

// Compiles a program, and returns what its function `main` prints.
std::vector<std::string> run_language(std::string_view source, std::string_view options) {
  const auto program = test::load_quakec(std::string(kPrelude) + std::string(source), options);
  Machine machine(program);
  std::vector<std::string> lines;
  add_builtins(machine, lines);
  const auto field = [&](std::string_view name) { return FieldIndex{program->find_field(name)->offset}; };
  machine.set_state_fields({GlobalIndex{program->find_global("self")->offset},
                            GlobalIndex{program->find_global("time")->offset}, field("nextthink"),
                            field("frame"), field("think")});
  EXPECT_TRUE(machine.set_entity_count(3).ok());
  machine.set_global_entity(GlobalIndex{program->find_global("self")->offset}, EntityIndex{1});
  machine.set_global_entity(GlobalIndex{program->find_global("other")->offset}, EntityIndex{2});
  machine.protect_world(true);
  const base::Status status = machine.call(program->find_function("main"));
  if (!status.ok()) lines.push_back("error: " + status.error().what);
  return lines;
}

struct Sample {
  std::string_view name, source;
  std::vector<std::string> lines;
};

// Programs for all targets.
const std::vector<Sample>& samples() {
  static const std::vector<Sample> kSamples = {
      {"Arrays",
       R"(float numbers[12]; vector places[3]; string names[3]; entity monsters[3]; void() actions[2];
          void() hello = { print("hello"); };
          void() main = {
            local float i;
            for (i = 0; i < 12; i++) numbers[i] = i * i;
            show(numbers[3] + numbers[i - 1]);
            places[i - 10] = '1 2 3'; show_vector(places[2]); show_vector(places[i - 12]);
            names[1] = "ogre"; names[i - 10] = "fiend"; i = 1; print(names[i], names[i + 1]);
            monsters[i] = other; monsters[i].health = 7; show(other.health);
            actions[i] = hello; actions[1]();
          };)",
       {"130", "1 2 3", "0 0 0", "ogrefiend", "7", "hello"}},
      {"Control",
       R"(enum { kRed, kGreen = 5, kBlue };
          enumflags { kOne, kTwo, kFour };
          #define TWICE(x) ((x) + (x))
          typedef float number;
          void(float n) choose = {
            switch (n) { case 0: print("zero"); case 1: print("one"); break; case 2 .. 4: print("few"); break;
                         default: print("many"); }
          };
          void(string s) pick = { switch (s) { case "a": print("A"); break; case "b": print("B"); break; } };
          void(entity e) meet = { switch (e) { case self: print("self"); break; case other: print("other"); } };
          
          void() main = {
            local number i, sum;
            show(kBlue); show(kOne | kFour); show(TWICE(4));
            choose(0); choose(1); choose(3); choose(9); pick("b"); pick("c"); meet(other);
            for (i = 0; i < 10; i++) { if (i == 3) continue; if (i == 6) break; sum += i; }
            show(sum);
            do { i -= 1; } while (i > 2);
            while (i) i--;
            show(i ? 1 : 2);
          };)",
       {"6", "5", "8", "zero", "one", "one", "few", "many", "B", "other", "12", "2"}},
      {"Assignments",
       R"(void() main = {
            local float f, g; local vector v;
            f = g = 3; f += 2; f *= 4; f -= 2; f /= 3; show(f); f = 5; f |= 2; show(f); f(+)8; f(-)4; show(f);
            v = '1 2 3'; v += '1 1 1'; v -= '0 0 1'; v *= 2; show_vector(v); v_y += 3; show(v_y);
            self.health = 10; self.health += 5; self.health -= 3; self.health *= 2; self.health /= 4;
            show(self.health); self.health = 6; self.health |= 1; show(self.health);
            self.origin = v; self.origin += '1 0 0';  show_vector(self.origin);
          };)",
       {"6", "7", "11", "4 6 6", "9", "6", "7", "5 9 6"}},
      {"Functions",
       R"(float(float a, float b, float c, float d, float e, float f, float g, float h, float i, float j) ten =
            { return a + b * 10 + i * 100 + j * 1000; };
          void() walk1 = [1, walk2] { print("walk1"); }; void() walk2 = [2, walk1] { print("walk2"); };
          float(float n) factorial = { if (n < 2) return 1; return n * factorial(n - 1); };
          vector(vector a, vector b) add = { return a + b; };
          float(float(float n) f, float n) apply = { return f(n); };
          class Counter { float count; };
          void() main = {
            local Counter counter;
            show(ten(1, 2, 3, 4, 5, 6, 7, 8, 9, 10)); walk1(); show(self.frame); self.think();
            show(self.frame); show(factorial(6)); show_vector(add('1 2 3', add('1 1 1', '0 0 5')));
            show(apply(factorial, 4)); print("a", "b", "c", "d", "e", "f", "g", "h");
            counter = spawn(); counter.count = 2; counter.count += 3; show(counter.count);
          };)",
       {"10921", "walk1", "1", "walk2", "2", "720", "2 3 9", "24", "abcdefgh", "5"}},
      {"Values",
       R"(float primes[4] = {2, 3, 5, 7}; vector corners[2] = {'1 2 3', '4 5 6'}; string words[2] = {"a", "b"};
          nosave float kept; const float kNine = 9;
          .void(float f) act; void(float f) tell = { show(f); };
          $frame stand1 stand2 stand3
          void() rest = [$stand3, rest] { };
          float add(float a, float b) { return a + b; }
          #define AREA(a,b) ((a) * (b))
          #ifdef AREA
          void() main = {
            local float i; local .float reach; local .vector spot;
            :again
            i += 1; if (i < 3) goto again;
            show(primes[i]); show_vector(corners[i - 2]); print(words[i - 2]); kept = i; show(add(kept, kNine));
            reach = health; self.reach = 3; spot = origin; self.spot = '7 8 9'; reach = origin_y;
            show(self.health); show_vector(self.origin); show(self.reach);
            self.act = tell; self.act(AREA(2, 3)); rest(); show(self.frame);
            if (words[0]) print("set"); if (!"") print("empty"); print("tab\t" "quote\"");
          };
          #endif)",
       {"7", "4 5 6", "b", "12", "3", "7 8 9", "8", "6", "2", "set", "empty", "tab\tquote\""}}};
  return kSamples;
}

// Programs that need the operations of -Tfte, or that Debian's fteqcc compiles correctly only for it.
const std::vector<Sample>& extended_samples() {
  static const std::vector<Sample> kSamples = {
      {"Integers",
       R"(int whole; .int count; int numbers[4];
          void() main = {
            local int i, j; local float f;
            i = 7i; j = i * 3i + 1i; show_int(j); show_int(j / 4i); show_int(i - j); show_int(0i - 7i / 2i);
            show_int(i << 2i); show_int((0i - 9i) >> 1i); show_int(i & j); show_int(i | 8i); show_int(i ^ 2i);
            f = i; show(f); f = 2.9; i = f; show_int(i); show(i + 0.5); show(1.5 - i); show(f + i); show(i - f);
            if (i < j) print("less"); if (i >= j) print("wrong"); if (i != j && i <= j) print("differ");
            if (i < f) print("below"); if (f > i) print("above"); if (!(i == f)) print("unequal");
            f = (i > j) + 1; show(f); f = !i; show(f);
            whole = 16777217i; show_int(whole + 1i);
            self.count = 5i; self.count = self.count + 1i; show_int(self.count); self.health = i;
            show(self.health); self.count = 3.7; show_int(self.count);
            for (i = 0i; i < 4i; i++) numbers[i] = i * i;
            show_int(numbers[3]); f = 2; show_int(numbers[f]);
            switch (i) { case 4i: print("four"); break; case 1i: print("one"); }
            i = 6i; show(i & 3.0); f = 7; show(f & i); show(i | 1.0); show(f | i);
          };)",
       {"22i",       "5i",   "-15i", "-3i",  "28i",  "-5i",    "6i",    "15i",   "5i",      "7", "2i",
        "2.5",       "-0.5", "4.9",  "-0.9", "less", "differ", "below", "above", "unequal", "1", "0",
        "16777218i", "6i",   "2",    "3i",   "9i",   "4i",     "four",  "2",     "6",       "7", "7"}},
      {"PointersAndStructs",
       R"(typedef struct { float a; vector v; int n; string s; entity e; } Item;
          Item one, items[3]; float numbers[4]; vector places[2]; .float slots[3];
          void(Item item) use = { show(item.a); };
          union { float f; int i; } both;
          void(vector v) look = { switch (v) { case '0 0 1': print("up"); break; default: print("level"); } };
          void() main = {
            local float *p; local vector *q; local string *t; local string word; local Item mine; local float f;
            local int k; local float local_numbers[5];
            p = &numbers; *p = 4; p[1] = 5; k = 2i; p[k] = 6; f = 3; p[f] = 7;
            show(numbers[0] + numbers[1] * 10 + numbers[2] * 100 + numbers[3] * 1000);
            f = *p; show(f);  *p += 2; show(numbers[0]);
            q = &places; *q = '1 2 3'; show_vector(places[0]);
            t = &word; *t = "text"; print(word);
            p = &self.health; *p = 12; show(self.health); p = &local_numbers; p[2] = 8; show(local_numbers[2]);
            mine.a = 3; mine.v = '4 5 6'; mine.n = 7i; mine.s = "item"; mine.e = self;
            show(mine.a); show_vector(mine.v); show_int(mine.n); print(mine.s); show(mine.e.health);
            one.v = mine.v; items[k].v = one.v; items[1].s = mine.s; show_vector(items[2].v); print(items[1].s);
            use(mine); both.f = 1; show_int(both.i);
            f = 1; self.slots[f] = 5; self.slots[2] = 6; show(self.slots[1] + self.slots[f + 1]);
            look('0 0 1'); look('0 1 0'); self.origin = '5 9 6'; self.origin -= '0 1 0'; show_vector(self.origin);
          };)",
       {"7654", "4",  "6",     "1 2 3", "text", "12",          "8",  "3",  "4 5 6", "7i",
        "item", "12", "4 5 6", "item",  "3",    "1065353216i", "11", "up", "level", "5 8 6"}},
      {"Nesting",
       R"(typedef struct { float a[3]; vector v[2]; } Row;
          Row rows[2]; union { vector v; float f; } both; .float slots[3]; .vector spots[2];
          void() main = {
            local float i; local int k;
            k = 1i; rows[k].a[2] = 5; rows[1].v[k] = '1 2 3'; show(rows[1].a[k + 1i]); show_vector(rows[k].v[1]);
            show(rows[0].a[2]); both.v = '7 8 9'; show(both.f);
            i = 1; self.spots[i] = '4 5 6'; show_vector(self.spots[1]); self.slots[i] = 4; show(self.slots[1]);
            k = (int)3.7; show_int(k); i = 6; print(i ? "yes" : "no");
          };)",
       {"5", "1 2 3", "0", "7", "4 5 6", "4", "3i", "yes"}}};
  return kSamples;
}

TEST(QuakecLanguage, RunsForEveryTarget) {
  SKIP_WITHOUT_QUAKEC();
  for (const std::string_view target : {"", "-Tfte", "-Tkkqwsv"})
    for (const std::string_view optimization : {"", "-O0", "-O3"})
      for (const Sample& sample : samples())
        EXPECT_THAT(run_language(sample.source, fmt::format("{} {}", target, optimization)),
                    ElementsAreArray(sample.lines))
            << sample.name << " " << target << " " << optimization;
}

TEST(QuakecLanguage, RunsExtendedPrograms) {
  SKIP_WITHOUT_QUAKEC();
  for (const std::string_view optimization : {"", "-O0", "-O3"})
    for (const Sample& sample : extended_samples())
      EXPECT_THAT(run_language(sample.source, fmt::format("-Tfte {}", optimization)),
                  ElementsAreArray(sample.lines))
          << sample.name << " " << optimization;
}

// The machine sets the variable with which fteqcc lets arrays use the added operations in version 6. Only
// these check the index.
TEST(QuakecLanguage, RunsFastArraysOfVersion6) {
  SKIP_WITHOUT_QUAKEC();
  const std::string_view source = R"(
    float __ext__fasttrackarrays; float numbers[5]; vector places[2];
    void() main = { local float i; i = 3; numbers[i] = 8; show(numbers[i]);
      places[i - 2] = '1 2 3'; show_vector(places[i - 2]); i = 5; show(numbers[i]); };)";
  const std::vector<std::string> lines = run_language(source, "");
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], "8");
  EXPECT_EQ(lines[1], "1 2 3");
  EXPECT_THAT(lines[2], HasSubstr("error: 5 is not an index of the array"));

  // A program that clears the variable uses functions of its own.
  std::string slow_source(source);
  slow_source.insert(slow_source.find("i = 3;"), "__ext__fasttrackarrays = 0; ");
  const std::vector<std::string> slow_lines = run_language(slow_source, "");
  EXPECT_EQ(slow_lines.front(), "8");
  EXPECT_THAT(slow_lines.back(), Not(HasSubstr("is not an index of the array")));
}

TEST(QuakecLanguage, StopsAtBadPointers) {
  SKIP_WITHOUT_QUAKEC();
  const auto last_line = [](std::string_view statements) {
    return run_language(
               fmt::format(
                   "float numbers[3]; void() main = {{ local float *p; local int *q; local int i, j; local "
                   "float f; {} show(f); }};",
                   statements),
               "-Tfte")
        .back();
  };
  EXPECT_EQ(last_line("p = &numbers; f = *p;"), "0");
  EXPECT_THAT(last_line("p = &numbers; q = &p; *q = 2147483647i; f = *p;"),
              HasSubstr("it reads through the pointer 0x7fffffff"));
  EXPECT_THAT(last_line("p = &numbers; i = 1000000i; p[i] = 3;"),
              HasSubstr("it writes through the pointer 0x8"));
  EXPECT_THAT(last_line("p = &numbers; i = 0i - 1000000i; p[i] = 3;"),
              HasSubstr("it writes through the pointer 0x7"));
  EXPECT_THAT(last_line("*p = 3;"), HasSubstr("it writes through the pointer 0x0"));
  EXPECT_THAT(last_line("i = 0i - 1000i; numbers[i] = 3;"), HasSubstr("-1000 is not an index"));
  EXPECT_THAT(last_line("i = 1000000i; f = numbers[i];"), HasSubstr("1000000 is not an index"));
  EXPECT_THAT(last_line("i = i / j; f = i;"), HasSubstr("it divides the integer 0 by 0"));
}

// Programs with more than 65535 global words have wide definitions. Longer names exceed a limit of fteqcc.
TEST(QuakecLanguage, RunsProgramsWithManyGlobals) {
  SKIP_WITHOUT_QUAKEC();
  std::string source = "void(float f) pass; float before;\n";
  // fteqcc takes twice as long for as many floats, and 20 times as long without "nosave".
  for (int i = 0; i < 219; ++i) source += fmt::format("nosave vector a{}[100];\n", i);
  source += "float a219[300];\n";
  source +=
      "float after; void() main = { local float i; i = 7; after = 3; before = 5; a219[i] = 4; "
      "show(before + after + a219[7]); };";
  for (const std::string_view target : {"", "-Tfte"}) {
    const auto lines = run_language(source, target);
    EXPECT_THAT(lines, ElementsAreArray({"12"})) << target;
  }
}

}  // namespace
}  // namespace temblor::vm
