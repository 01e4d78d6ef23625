#include "vm/code/strings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "support/programs/progs_builder.h"
#include "support/random.h"
#include "vm/machine.h"

namespace temblor::vm {
namespace {

using ::testing::HasSubstr;

constexpr std::string_view kProgram("\0axe\0ogre\0", 10);

std::uint32_t number(StringIndex index) {
  return static_cast<std::uint32_t>(index);
}

TEST(Strings, OfTheProgramBeginAnywhere) {
  const Strings strings(kProgram, 1000);
  EXPECT_EQ(strings.text(kEmptyString), "");
  EXPECT_EQ(strings.text(StringIndex{1}), "axe");
  EXPECT_EQ(strings.text(StringIndex{6}), "gre");
  EXPECT_TRUE(strings.contains(StringIndex{9}));
  for (const std::uint32_t none : {10u, 0x7fffffffu, 0x80000000u, 0x80000001u, 0xffffffffu}) {
    EXPECT_FALSE(strings.contains(StringIndex{none})) << none;
    EXPECT_EQ(strings.text(StringIndex{none}), "") << none;
  }
}

TEST(Strings, MadeOnesEndAtTheFirstZero) {
  Strings strings(kProgram, 1000);
  const auto made = strings.make(std::string_view("ab\0cd", 5));
  ASSERT_TRUE(made.ok());
  EXPECT_GT(number(*made), 0x80000000u);  // 2^31 itself is -0.0
  EXPECT_EQ(strings.text(*made), "ab");
  EXPECT_EQ(*strings.make(""), kEmptyString);
  EXPECT_EQ(*strings.zone(""), kEmptyString);
  EXPECT_EQ(strings.made_count(), 1u);
}

TEST(Strings, HaveALimit) {
  Strings strings(kProgram, 10'000);
  std::size_t made = 0;
  while (strings.make("0123456789").ok()) ++made;
  EXPECT_GT(made, 50u);
  EXPECT_LE(strings.made_bytes(), 10'000u);
  EXPECT_THAT(strings.make("0123456789").error().what, HasSubstr("out of string memory"));
  strings.collect({});
  EXPECT_EQ(strings.made_bytes(), 0u);
  EXPECT_TRUE(strings.make("0123456789").ok());
  EXPECT_FALSE(strings.make(std::string(10'000, 'x')).ok());
}

// Makes, zones, unzones, releases, and collects strings at random, and compares with a map.
TEST(Strings, LiveAsLongAsTheyAreHeldOrZoned) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    test::Random random(seed);
    Strings strings(kProgram, 1 << 20);
    std::vector<std::uint32_t> words(64);
    std::map<std::uint32_t, std::string> zoned, known;
    for (int step = 0; step < 500; ++step) {
      std::uint32_t& word = words[random.below(words.size())];
      const std::string text = "text " + std::to_string(step);
      switch (random.below(6)) {
        case 0:
        case 1:
          word = number(*strings.make(text));
          ASSERT_EQ(known.count(word), 0u) << seed;  // the number of a live string is not used again
          known[word] = text;
          break;
        case 2: {
          const std::uint32_t index = number(*strings.zone(text));
          ASSERT_EQ(known.count(index), 0u) << seed;
          zoned[index] = known[index] = text;
          if (random.chance(0.5)) word = index;
          break;
        }
        case 3:
          word = 0;
          break;
        case 4:
          if (zoned.empty()) break;
          EXPECT_TRUE(strings.unzone(StringIndex{zoned.begin()->first}));
          EXPECT_FALSE(strings.unzone(StringIndex{zoned.begin()->first}));
          zoned.erase(zoned.begin());
          break;
        default: {
          strings.collect({std::span<const std::uint32_t>(words).first(20),
                           std::span<const std::uint32_t>(words).subspan(20)});
          std::map<std::uint32_t, std::string> left;
          for (const auto& [index, what] : known)
            if (zoned.contains(index) || std::ranges::count(words, index) > 0) left[index] = what;
          for (const auto& [index, what] : known)
            ASSERT_EQ(strings.contains(StringIndex{index}), left.contains(index)) << seed;
          known = left;
        }
      }
      ASSERT_EQ(strings.made_count(), known.size()) << seed;
      for (const auto& [index, what] : known) ASSERT_EQ(strings.text(StringIndex{index}), what) << seed;
    }
  }
}

TEST(Strings, UnzoningWhatWasNeverZoned) {
  Strings strings(kProgram, 1000);
  const StringIndex made = *strings.make("x");
  for (const StringIndex index : {made, kEmptyString, StringIndex{1}, StringIndex{0xffffffff}})
    EXPECT_FALSE(strings.unzone(index));
}

// A program that makes strings in every call needs bounded memory, and strings in globals and entities stay.
TEST(Strings, AMachineForgetsThoseThatNobodyHolds) {
  test::ProgsBuilder builder;
  builder.field("netname", formats::ProgsType::kString);
  const int kept = builder.words({0}), make = builder.builtin("make", 1);
  builder.function("test");
  builder.emit(Opcode::kCall0, make);
  builder.emit(Opcode::kDone);
  Machine machine(builder.load(), {.string_bytes = 4 << 20});
  int count = 0;
  machine.add_builtin(1, "make", [&](Machine& io_machine) -> base::Status {
    TRY(const StringIndex text, io_machine.make_string("player " + std::to_string(count++)));
    io_machine.return_string(text);
    return base::Ok{};
  });
  machine.set_global_string(GlobalIndex{static_cast<std::uint32_t>(kept)}, *machine.make_string("kept"));
  machine.entity(kWorld)[0] = number(*machine.make_string("world"));
  for (int i = 0; i < 200'000; ++i) {
    const base::Status status = machine.call(FunctionIndex{2});
    ASSERT_TRUE(status.ok()) << status.error().message();
    machine.collect_strings();
  }
  EXPECT_LT(machine.strings().made_bytes(), 3u << 20);
  EXPECT_EQ(machine.text(machine.global_string(GlobalIndex{static_cast<std::uint32_t>(kept)})), "kept");
  EXPECT_EQ(machine.text(StringIndex{machine.entity(kWorld)[0]}), "world");
}

TEST(Strings, AProgramThatMakesTooManyInOneCallEndsWithAnError) {
  test::ProgsBuilder builder;
  const int make = builder.builtin("make", 1);
  builder.function("test");
  builder.emit(Opcode::kCall0, make);
  builder.emit(Opcode::kGoto, -1);
  Machine machine(builder.load(), {.string_bytes = 1 << 20});
  machine.add_builtin(1, "make", [&](Machine& io_machine) -> base::Status {
    TRY([[maybe_unused]] const StringIndex text, io_machine.make_string("once more"));
    return base::Ok{};
  });
  for (int i = 0; i < 3; ++i) {
    const base::Status status = machine.call(FunctionIndex{2});
    ASSERT_FALSE(status.ok());
    EXPECT_THAT(status.error().what, HasSubstr("make: out of string memory"));
    machine.collect_strings();
    EXPECT_EQ(machine.strings().made_count(), 0u);
  }
}

}  // namespace
}  // namespace temblor::vm
