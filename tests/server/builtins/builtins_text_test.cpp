// Conversion of numbers to text and back; cutting, joining and splitting of text.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <limits>

#include "server/builtins/builtin_stage.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using math::Vec3;
using ::testing::HasSubstr;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

template <typename... Values>
std::string printed_by_c(const char* format, Values... values) {
  std::array<char, 4096> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, values...);
  return buffer.data();
}

TEST(TextBuiltins, FtosAndVtos) {
  Stage stage;
  EXPECT_EQ(stage.text("ftos", 12), "12");
  EXPECT_EQ(stage.text("ftos", -3), "-3");
  EXPECT_EQ(stage.text("ftos", -0.0f), "0");
  EXPECT_EQ(stage.text("ftos", 0.5f), "  0.5");
  EXPECT_EQ(stage.text("ftos", 123.45f), "123.4") << "123.4499969";
  EXPECT_EQ(stage.text("vtos", Vec3(1, -2.25f, 1000)), "'  1.0  -2.2 1000.0'");
  EXPECT_EQ(stage.text("etos", Stage::kPlayer2), "entity 2");
  Random random(5);
  for (int i = 0; i < 500; ++i) {
    const auto value = static_cast<float>(random.uniform(-2000, 2000));
    ASSERT_EQ(stage.text("ftos", value), printed_by_c("%5.1f", double{value}));
  }
  for (const float value : {3e9f, -1e30f, kInfinity})
    EXPECT_EQ(stage.text("ftos", value), printed_by_c("%5.1f", double{value}));
  stage.run("ftos", kNan);
}

TEST(TextBuiltins, StofReadsAsCDoes) {
  Stage stage;
  for (const char* text : {"12", " -3.5abc", "+7", "1e3", ".5", "5.", "", "abc", "-", "\t 8", "1 2", "--1",
                           "1e", "00012", "+-1", "-.25e-1x"})
    EXPECT_EQ(stage.number("stof", text), static_cast<float>(std::atof(text))) << text;
  EXPECT_EQ(stage.number("stof", "1e300"), std::numeric_limits<float>::max());
}

TEST(TextBuiltins, StovReadsThreeNumbers) {
  Stage stage;
  EXPECT_EQ(stage.vector("stov", "'1 2.5 -3'"), Vec3(1, 2.5f, -3));
  EXPECT_EQ(stage.vector("stov", "1 2"), Vec3(1, 2, 0));
  EXPECT_EQ(stage.vector("stov", "x"), Vec3(0.0f));
  EXPECT_EQ(stage.vector("stov", stage.text("vtos", Vec3(-8, 16, 0.5f))), Vec3(-8, 16, 0.5f));
}

TEST(TextBuiltins, LengthJoinAndPart) {
  Stage stage;
  EXPECT_EQ(stage.number("strlen", "hello"), 5);
  EXPECT_EQ(stage.number("strlen", ""), 0);
  EXPECT_EQ(stage.text("strcat", "a", "bc", "", "d"), "abcd");
  EXPECT_EQ(stage.text("substring", "hello", 1, 3), "ell");
  EXPECT_EQ(stage.text("substring", "hello", 3, 99), "lo");
  EXPECT_EQ(stage.text("substring", "hello", 5, 1), "");
  // FTE_STRINGS counts negative numbers from the end.
  EXPECT_EQ(stage.text("substring", "hello", -2, 2), "lo");
  EXPECT_EQ(stage.text("substring", "hello", -9, 2), "he");
  EXPECT_EQ(stage.text("substring", "hello", 1, -1), "ello");
  EXPECT_EQ(stage.text("substring", "hello", 1, -2), "ell");
  EXPECT_EQ(stage.text("substring", "hello", 1, -9), "");
  EXPECT_EQ(stage.text("substring", "hello", kNan, kInfinity), "hello");
}

TEST(TextBuiltins, ResultsOutliveTheNextCall) {
  Stage stage;
  stage.run("ftos", 1.5f);
  const vm::StringIndex first = stage.machine.returned_string();
  stage.run("ftos", 2.5f);
  EXPECT_EQ(stage.machine.text(first), "  1.5");
}

TEST(TextBuiltins, StrzoneOutlivesTheFieldThatHeldIt) {
  Stage stage;
  stage.run("strzone", "kept");
  const vm::StringIndex zoned = stage.machine.returned_string();
  stage.run("ftos", 0);
  stage.machine.set_parameter_float(0, 0);
  stage.machine.strings().collect({});
  EXPECT_EQ(stage.machine.text(zoned), "kept");
  stage.machine.set_parameter_string(0, zoned);
  ASSERT_TRUE(stage.call_function(stage.look_up_function("strunzone"), 1).ok());
  EXPECT_EQ(stage.printed, "");
  stage.machine.strings().collect({});
  EXPECT_FALSE(stage.machine.strings().contains(zoned));
  stage.run("strunzone", "never zoned");
  EXPECT_THAT(stage.printed, HasSubstr("builtin strunzone: "));
}

TEST(TextBuiltins, TokenizeAndArgv) {
  Stage stage;
  EXPECT_EQ(stage.number("tokenize", "say  \"hello world\"\tnow \"\" x\"y"), 5);
  EXPECT_EQ(stage.text("argv", 0), "say");
  EXPECT_EQ(stage.text("argv", 1), "hello world");
  EXPECT_EQ(stage.text("argv", 2), "now");
  EXPECT_EQ(stage.text("argv", 3), "");
  EXPECT_EQ(stage.text("argv", 4), "x\"y");
  for (const float number : {5.0f, -1.0f, 1e20f}) EXPECT_EQ(stage.text("argv", number), "");
  EXPECT_EQ(stage.number("tokenize", "\"open"), 1);
  EXPECT_EQ(stage.text("argv", 0), "open");
  EXPECT_EQ(stage.number("tokenize", ""), 0);
  EXPECT_EQ(stage.text("argv", 0), "");
}

TEST(Sprintf, DirectivesAsInC) {
  Stage stage;
  const auto f = [&](const char* format, const auto&... values) {
    return stage.text("sprintf", format, values...);
  };
  EXPECT_EQ(f("plain 100%%"), "plain 100%");
  EXPECT_EQ(f("%d|%5d|%-5d|%05d|%+d|% d", 42, 42, 42, 42, 42, 42), "42|   42|42   |00042|+42| 42");
  EXPECT_EQ(f("%d", -1.9f), "-1");
  EXPECT_EQ(f("%x %X %#x %o %u", 255, 255, 255, 8, 7), "ff FF 0xff 10 7");
  EXPECT_EQ(f("%c%c", 72, 105), "Hi");
  EXPECT_EQ(f("%f %.2f %8.3f|%e|%g %G", 1.5f, 1.005f, 2.5f, 1000, 0.0001f, 1e20f),
            printed_by_c("%f %.2f %8.3f|%e|%g %G", 1.5, double{1.005f}, 2.5, 1000.0, double{0.0001f},
                         double{1e20f}));
  EXPECT_EQ(f("[%s|%6s|%-6s|%.2s]", "abc", "abc", "abc", "abc"), "[abc|   abc|abc   |ab]");
  EXPECT_EQ(f("%v", Vec3(1, -2.5f, 0)), "1 -2.5 0");
  EXPECT_EQ(f("%.1v", Vec3(1, 2, 3)), "1 2 3");
}

TEST(Sprintf, WidthsAndValuesByIndex) {
  Stage stage;
  const auto f = [&](const char* format, const auto&... values) {
    return stage.text("sprintf", format, values...);
  };
  EXPECT_EQ(f("%*d|%-*d|%.*f", 4, 1, 4, 2, 1, 3.25f), "   1|2   |3.2");
  EXPECT_EQ(f("%*d|", -4, 1), "1   |");
  EXPECT_EQ(f("%2$s %1$s", "world", "hello"), "hello world");
  EXPECT_EQ(f("%2$d %d", 1, 2), "2 1");
}

TEST(Sprintf, WholeWordsAndFloats) {
  Stage stage;
  const auto f = [&](const char* format, const auto&... values) {
    return stage.text("sprintf", format, values...);
  };
  EXPECT_EQ(f("%i", 5), "5") << "a float, as all numbers of version 6 are";
  EXPECT_EQ(f("%i %i", RawWord{5}, RawWord{0xffffffff}), "5 -1");
  EXPECT_EQ(f("%i", 0), "0");
  EXPECT_EQ(f("%ld", RawWord{5}), "5");
  EXPECT_EQ(f("%hi", 7), "7");
}

TEST(Sprintf, BearsEverything) {
  Stage stage;
  const auto f = [&](const char* format, const auto&... values) {
    return stage.text("sprintf", format, values...);
  };
  EXPECT_EQ(f("%d %s|%v|%f", 1), "1 |0 0 0|0.000000") << "values that were not passed";
  EXPECT_EQ(f("%9$d %99999999999$d"), "0 0");
  EXPECT_EQ(f("%d %x", kNan, -1), "0 ffffffff");
  EXPECT_EQ(f("%d", 1e30f), "9000000000000000000");
  EXPECT_EQ(f("a%"), "a%");
  EXPECT_EQ(f("%n%p%y %-", 1), "%n%p%y %-");
  EXPECT_EQ(f("%999999999d", 1).size(), 512u);
  EXPECT_EQ(f("%.999999999f", 1).size(), 514u);
  EXPECT_EQ(f("%.*f", -1, 0.5f), "0.500000");
  EXPECT_LE(f("%512f%512.512f", 3e38f, 3e38f).size(), 512u + 39 + 1 + 512);
}

TEST(Sprintf, RandomFormatsEndAndAreShort) {
  Stage stage;
  Random random(9);
  const std::string_view alphabet = "%%%%%0123456789$*.-+ #lhdicxXoufFeEgGvsq";
  for (int i = 0; i < 3000; ++i) {
    std::string format;
    for (std::size_t k = random.below(40); k-- > 0;) format += alphabet[random.below(alphabet.size())];
    const std::string error = stage.error("sprintf", format, 3.5f, "text", Vec3(1, 2, 3), kNan, 1e38f);
    if (!error.empty()) {
      ASSERT_THAT(error, HasSubstr("is not a string")) << format;
    } else {
      ASSERT_LE(stage.machine.text(stage.machine.returned_string()).size(), std::size_t{1} << 16) << format;
    }
  }
}

TEST(Sprintf, NumbersAreThoseOfC) {
  Stage stage;
  Random random(10);
  for (int i = 0; i < 1000; ++i) {
    std::string format = "%";
    for (const char flag : std::string_view("-+ 0#"))
      if (random.chance(0.3)) format += flag;
    if (random.chance(0.5)) format += fmt::format("{}", random.below(20));
    if (random.chance(0.5)) format += fmt::format(".{}", random.below(10));
    format += "feEgG"[random.below(5)];
    const auto value = static_cast<float>(random.uniform(-1, 1) * random.log_uniform(1e-6, 1e6));
    ASSERT_EQ(stage.text("sprintf", format, value), printed_by_c(format.c_str(), double{value})) << format;
  }
}

}  // namespace
}  // namespace temblor::test
