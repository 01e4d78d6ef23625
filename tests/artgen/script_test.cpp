#include "artgen/scripts/script.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace temblor::artgen {
namespace {

std::string error_message(std::string_view text) {
  const base::Result<std::vector<ScriptLine>> script = read_script(text);
  return script.ok() ? "none" : script.error().message();
}

std::vector<ScriptLine> parse_lines(std::string_view text) {
  base::Result<std::vector<ScriptLine>> script = read_script(text);
  EXPECT_TRUE(script.ok());
  return script.ok() ? std::move(script).value() : std::vector<ScriptLine>();
}

TEST(Script, LinesContainTheLinesIndentedUnderThem) {
  const std::vector<ScriptLine> lines = parse_lines(
      "# a wall\n"
      "texture old 64x32\n"
      "  bricks width=32   # as the others\n"
      "      mortar \"light gray\" tone=\"0.1..0.2\"\n"
      "\n"
      "  shade\r\n"
      "texture new 16x16");
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].keyword, "texture");
  EXPECT_EQ(lines[0].number, 2);
  EXPECT_EQ(lines[0].values, (std::vector<std::string>{"old", "64x32"}));
  ASSERT_EQ(lines[0].below.size(), 2u);
  ASSERT_EQ(lines[0].below[0].below.size(), 1u);
  const ScriptLine& mortar = lines[0].below[0].below[0];
  EXPECT_EQ(mortar.values, std::vector<std::string>{"light gray"});
  EXPECT_EQ(mortar.settings[0].first, "tone");
  EXPECT_EQ(mortar.settings[0].second, "0.1..0.2");
  EXPECT_EQ(lines[0].below[1].keyword, "shade");
  EXPECT_EQ(lines[1].number, 7);
  EXPECT_TRUE(parse_lines("").empty());
}

TEST(Script, BadIndentationIsAnErrorWithItsLine) {
  EXPECT_EQ(error_message("a\n  b\n c\n"), "line 3: the indentation matches no line above");
  EXPECT_EQ(error_message("  a\n"), "line 1: the indentation matches no line above");
  EXPECT_EQ(error_message("a\n\tb\n"), "line 2: scripts are indented with spaces, not tabs");
  EXPECT_EQ(error_message("a\nb \"c\n"), "line 2: a quote is not closed");
}

TEST(Script, ArgumentsAreReadByPositionAndByName) {
  const ScriptLine line =
      parse_lines("wall old 64x32 1,-2,3.5 0.5 width=8 glow=yes tone=0.2..0.6 at=4,5,6 one=3").front();
  Arguments arguments(line);
  EXPECT_EQ(arguments.text(), "old");
  EXPECT_EQ(arguments.size(64), (std::pair<std::int32_t, std::int32_t>(64, 32)));
  EXPECT_EQ(arguments.vector(), math::Vec3(1, -2, 3.5f));
  EXPECT_EQ(arguments.number(0, 1), 0.5);
  EXPECT_FALSE(arguments.text_if_present());
  EXPECT_EQ(arguments.integer("width", 1, 1, 16), 8);
  EXPECT_TRUE(arguments.flag("glow"));
  EXPECT_FALSE(arguments.flag("dim"));
  EXPECT_EQ(arguments.range("tone", {0, 1}), std::pair(0.2, 0.6));
  EXPECT_EQ(arguments.range("one", {0, 1}), std::pair(3.0, 3.0));
  EXPECT_EQ(arguments.vector("at", math::Vec3(0.0f)), math::Vec3(4, 5, 6));
  EXPECT_EQ(arguments.number("height", 7, 0, 10), 7);
  EXPECT_TRUE(arguments.finish().ok());
}

TEST(Script, TheFirstProblemIsReported) {
  const auto wrong = [](std::string_view text, auto ask) {
    const ScriptLine line = parse_lines(text).front();
    Arguments arguments(line);
    ask(arguments);
    const base::Status status = arguments.finish();
    return status.ok() ? "none" : status.error().message();
  };
  EXPECT_EQ(wrong("a", [](Arguments& a) { a.text(); }), "line 1: a: expected a word");
  EXPECT_EQ(wrong("a b", [](Arguments&) {}), "line 1: a: unexpected value 'b'");
  EXPECT_EQ(wrong("a wdith=3", [](Arguments& a) { a.number("width", 1, 0, 9); }),
            "line 1: a: unknown setting 'wdith'");
  EXPECT_EQ(wrong("a b=12", [](Arguments& a) { a.number("b", 1, 0, 9); }),
            "line 1: a: b=12 is not from 0 to 9");
  EXPECT_EQ(wrong("a b=x c=y",
                  [](Arguments& a) {
                    a.number("b", 1, 0, 9);
                    a.number("c", 1, 0, 9);
                  }),
            "line 1: a: b=x is not a number");
  EXPECT_EQ(wrong("a 0x4", [](Arguments& a) { a.size(64); }),
            "line 1: a: '0x4' is not WIDTHxHEIGHT, each from 1 to 64");
  EXPECT_EQ(wrong("a b=1,2", [](Arguments& a) { a.vector("b", {}); }), "line 1: a: b=1,2 is not X,Y,Z");
  EXPECT_EQ(wrong("a b=1.5", [](Arguments& a) { a.integer("b", 1, 0, 9); }),
            "line 1: a: b=1.5 is not a whole number");
}

}  // namespace
}  // namespace temblor::artgen
