#include "command/variables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string_view>

#include "command/colors.h"

namespace temblor::command {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// A table with one variable of each type.
struct Table {
  Variables variables;
  VariableIndex flag = variables.add_bool("r_flag", true, "A flag.");
  VariableIndex count = variables.add_int("r_count", 5, -1, 10, "A count.");
  VariableIndex scale = variables.add_float("r_scale", 0.5, 0, 2, "A scale.");
  VariableIndex name = variables.add_text("name", "player", "A name.");
  VariableIndex color = variables.add_choice("Color", kColors, "A color.");
};

TEST(Variables, StartWithTheirDefaults) {
  const Table table;
  EXPECT_TRUE(table.variables.bool_value(table.flag));
  EXPECT_EQ(table.variables.int_value(table.count), 5);
  EXPECT_EQ(table.variables.float_value(table.scale), 0.5);
  EXPECT_EQ(table.variables.text_value(table.name), "player");
  EXPECT_EQ(table.variables.choice_value(table.color), 0u);
  EXPECT_EQ(table.variables.version(), 0u);
}

TEST(Variables, BoolsTakeTheUsualWords) {
  Table table;
  for (const char* no : {"0", "false", "OFF", "No"}) {
    ASSERT_TRUE(table.variables.set("r_flag", "1").ok());
    ASSERT_TRUE(table.variables.set("r_flag", no).ok()) << no;
    EXPECT_FALSE(table.variables.bool_value(table.flag)) << no;
    EXPECT_EQ(table.variables.get(table.flag).text, "0");
  }
  for (const char* yes : {"1", "true", "On", "YES"}) {
    ASSERT_TRUE(table.variables.set("r_flag", "0").ok());
    ASSERT_TRUE(table.variables.set("r_flag", yes).ok()) << yes;
    EXPECT_TRUE(table.variables.bool_value(table.flag)) << yes;
  }
  for (const char* wrong : {"", "2", "-1", "maybe", "1 "})
    EXPECT_FALSE(table.variables.set("r_flag", wrong).ok()) << wrong;
}

TEST(Variables, BoundsMayLeaveOutAllBut0) {
  Variables variables;
  const VariableIndex rate = variables.add_int_or_zero("rate", 0, 2500, 9000, "A rate.");
  EXPECT_EQ(variables.int_value(rate), 0);
  for (const char* right : {"2500", "9000", "0"}) EXPECT_TRUE(variables.set("rate", right).ok()) << right;
  for (const char* wrong : {"1", "-1", "2499", "9001", "none", ""})
    EXPECT_FALSE(variables.set("rate", wrong).ok()) << wrong;
  EXPECT_EQ(variables.int_value(rate), 0);
  EXPECT_EQ(describe_values(variables.get(rate)), "0 or a whole number from 2500 to 9000");
}

TEST(Variables, IntsAreWholeAndInRange) {
  Table table;
  for (const auto& [text, value] : {std::pair("-1", -1), {"10", 10}, {"+3", 3}, {"007", 7}, {"-0", 0}}) {
    ASSERT_TRUE(table.variables.set("r_count", text).ok()) << text;
    EXPECT_EQ(table.variables.int_value(table.count), value) << text;
  }
  ASSERT_TRUE(table.variables.set("r_count", "4").ok());
  for (const char* wrong : {"-2", "11", "1.5", "", "+", "4x", " 4", "99999999999999999999", "0x3", "+-3"})
    EXPECT_FALSE(table.variables.set("r_count", wrong).ok()) << wrong;
  EXPECT_EQ(table.variables.int_value(table.count), 4) << "a refused value changes nothing";
}

TEST(Variables, FloatsAreFiniteAndInRange) {
  Table table;
  for (const auto& [text, value] :
       {std::pair("0", 0.0), {"2", 2.0}, {".25", 0.25}, {"1e-3", 0.001}, {"+1.5", 1.5}}) {
    ASSERT_TRUE(table.variables.set("r_scale", text).ok()) << text;
    EXPECT_EQ(table.variables.float_value(table.scale), value) << text;
  }
  for (const char* wrong : {"-0.001", "2.001", "nan", "inf", "-inf", "1e999", "", "1,5", "one"})
    EXPECT_FALSE(table.variables.set("r_scale", wrong).ok()) << wrong;
}

TEST(Variables, ChoicesAreByName) {
  Table table;
  ASSERT_TRUE(table.variables.set("color", "BLUE").ok());
  EXPECT_EQ(table.variables.choice_value(table.color), 2u);
  EXPECT_EQ(table.variables.get(table.color).text, "blue");
  for (const char* wrong : {"2", "", "blu", "blue "})
    EXPECT_FALSE(table.variables.set("color", wrong).ok()) << wrong;
}

TEST(Variables, TextIsKeptAsItIs) {
  Table table;
  for (const char* text : {"", " a  b ", "=", "Ranger\x80"}) {
    ASSERT_TRUE(table.variables.set("name", text).ok());
    EXPECT_EQ(table.variables.text_value(table.name), text);
  }
}

TEST(Variables, ErrorsSayWhatIsTaken) {
  Table table;
  const base::Status range = table.variables.set("R_COUNT", "77");
  ASSERT_FALSE(range.ok());
  EXPECT_EQ(range.error().code, base::ErrorCode::kUsage);
  EXPECT_EQ(range.error().what, "r_count cannot be \"77\": it takes a whole number from -1 to 10");
  EXPECT_THAT(table.variables.set("color", "pink").error().what, HasSubstr("one of red, green, blue"));
  EXPECT_THAT(table.variables.set("r_scale", "9").error().what, HasSubstr("a number from 0 to 2"));
  EXPECT_THAT(table.variables.set("r_flag", "9").error().what, HasSubstr("0 or 1"));
  const base::Status unknown = table.variables.set("r_nothing", "1");
  EXPECT_EQ(unknown.error().code, base::ErrorCode::kNotFound);
  EXPECT_THAT(unknown.error().what, HasSubstr("r_nothing"));
}

TEST(Variables, AssignmentsSplitAtTheFirstEqualsSign) {
  Table table;
  ASSERT_TRUE(table.variables.set_assignment("name=a=b").ok());
  EXPECT_EQ(table.variables.text_value(table.name), "a=b");
  ASSERT_TRUE(table.variables.set_assignment("name=").ok());
  EXPECT_EQ(table.variables.text_value(table.name), "");
  for (const char* wrong : {"", "name", "=1", "nobody=1", "r_count=x"})
    EXPECT_FALSE(table.variables.set_assignment(wrong).ok()) << wrong;
}

TEST(Variables, VersionsTellChanges) {
  Table table;
  ASSERT_TRUE(table.variables.set("r_count", "6").ok());
  EXPECT_EQ(table.variables.version(), 1u);
  ASSERT_TRUE(table.variables.set("r_count", "+6").ok());
  EXPECT_EQ(table.variables.version(), 1u) << "the same value is no change";
  EXPECT_FALSE(table.variables.set("r_count", "600").ok());
  EXPECT_EQ(table.variables.version(), 1u) << "a refused value is no change";
  ASSERT_TRUE(table.variables.set("r_flag", "0").ok());
  EXPECT_EQ(table.variables.version(), 2u);
  EXPECT_EQ(table.variables.get(table.count).version, 1u);
  EXPECT_EQ(table.variables.get(table.flag).version, 2u);
  EXPECT_EQ(table.variables.get(table.scale).version, 0u);
}

TEST(Variables, ResetGivesTheDefaultBack) {
  Table table;
  ASSERT_TRUE(table.variables.set("r_scale", "2").ok());
  ASSERT_TRUE(table.variables.reset("R_Scale").ok());
  EXPECT_EQ(table.variables.float_value(table.scale), 0.5);
  EXPECT_EQ(table.variables.reset("nobody").error().code, base::ErrorCode::kNotFound);
  EXPECT_EQ(table.variables.restore("nobody").error().code, base::ErrorCode::kNotFound);
  EXPECT_EQ(table.variables.adopt_as_default("nobody").error().code, base::ErrorCode::kNotFound);
}

TEST(Variables, AnAdoptedDefaultLastsUntilTheRegisteredOneIsRestored) {
  Table table;
  ASSERT_TRUE(table.variables.set("r_scale", "2").ok());
  ASSERT_TRUE(table.variables.adopt_as_default("R_Scale").ok());
  ASSERT_TRUE(table.variables.set("r_scale", "1").ok());
  ASSERT_TRUE(table.variables.reset("r_scale").ok());
  EXPECT_EQ(table.variables.float_value(table.scale), 2);
  ASSERT_TRUE(table.variables.restore("r_scale").ok());
  EXPECT_EQ(table.variables.float_value(table.scale), 0.5);
  EXPECT_EQ(table.variables.get(table.scale).default_text, "0.5");
}

TEST(Variables, AllAreListedByName) {
  const Table table;
  std::vector<std::string> names;
  for (const Variable* variable : table.variables.all()) names.push_back(variable->name);
  EXPECT_THAT(names, ElementsAre("Color", "name", "r_count", "r_flag", "r_scale"));
  EXPECT_EQ(table.variables.find("nobody"), nullptr);
  EXPECT_EQ(table.variables.find("COLOR"), &table.variables.get(table.color));
}

TEST(Variables, AliasAcceptsTheFormerName) {
  Table table;
  table.variables.add_alias("Old_Color", "color");
  const std::size_t listed = table.variables.all().size();
  ASSERT_TRUE(table.variables.set("old_color", table.variables.get(table.color).choices.back()).ok());
  EXPECT_EQ(table.variables.find("old_color"), &table.variables.get(table.color));
  EXPECT_NE(table.variables.get(table.color).text, table.variables.get(table.color).default_text);
  ASSERT_TRUE(table.variables.reset("old_color").ok());
  EXPECT_EQ(table.variables.get(table.color).text, table.variables.get(table.color).default_text);
  EXPECT_EQ(table.variables.all().size(), listed) << "only the new name is listed";
}

TEST(Variables, TwoTablesShareNothing) {
  Table first, second;
  ASSERT_TRUE(first.variables.set("r_count", "9").ok());
  EXPECT_EQ(second.variables.int_value(second.count), 5);
}

TEST(VariablesDeathTest, ProgrammersMistakesAreChecked) {
  Table table;
  EXPECT_DEATH(table.variables.add_bool("R_FLAG", true, "Again."), "CHECK failed");
  EXPECT_DEATH(table.variables.add_int("r_out", 3, 0, 2, "Out of range."), "CHECK failed");
  EXPECT_DEATH(table.variables.add_alias("r_count", "r_flag"), "CHECK failed");
  EXPECT_DEATH(table.variables.add_alias("r_old", "nobody"), "CHECK failed");
  EXPECT_DEATH((void)table.variables.int_value(table.flag), "CHECK failed");
}

}  // namespace
}  // namespace temblor::command
