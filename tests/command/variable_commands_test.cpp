// Commands that set variables, and commands that list them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "command/colors.h"
#include "command/console.h"

namespace temblor::command {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class VariableCommands : public ::testing::Test {
 protected:
  VariableCommands() {
    variables_.add_int("viewsize", 100, 30, 120, "How much of the frame the view takes.");
    variables_.add_float("gamma", 1, 0.5, 2, "Brightens the dark.");
    variables_.add_bool("crosshair", false, "Shows a cross.");
    variables_.add_choice("color", kColors, "A color.");
    variables_.add_text("name", "player", "What others call you.");
    console_.add_command("map", "map NAME starts a level.", [](Console::Arguments) {});
  }
  // Returns the lines that it prints.
  std::vector<std::string> run(std::string_view text) {
    lines_.clear();
    console_.append(text);
    console_.run();
    return lines_;
  }
  std::string value(std::string_view name) const { return variables_.find(name)->text; }

  Variables variables_;
  std::vector<std::string> lines_;
  Console console_{variables_, [this](std::string_view line) { lines_.emplace_back(line); }};
};

TEST_F(VariableCommands, IncStaysInRange) {
  EXPECT_THAT(run("inc viewsize -10; inc gamma 0.1; inc gamma .1; inc gamma +0.1"), IsEmpty());
  EXPECT_EQ(value("viewsize"), "90");
  EXPECT_EQ(value("gamma"), "1.3");
  EXPECT_THAT(run("inc viewsize 1000; inc gamma -9"), IsEmpty());
  EXPECT_EQ(value("viewsize"), "120");
  EXPECT_EQ(value("gamma"), "0.5");
  run("inc viewsize; inc VIEWSIZE -2");
  EXPECT_EQ(value("viewsize"), "118");
}

TEST_F(VariableCommands, IncSaysWhatIsWrong) {
  for (const char* wrong :
       {"inc", "inc viewsize 1 2", "inc nothing", "inc viewsize x", "inc viewsize nan", "inc viewsize inf",
        "inc viewsize 1e999", "inc viewsize \"\"", "inc name 1", "inc color", "inc crosshair"})
    EXPECT_EQ(run(wrong).size(), 1u) << wrong;
  EXPECT_EQ(value("viewsize"), "100");
}

TEST_F(VariableCommands, CycleGoesThroughItsValues) {
  const auto after = [&](std::string_view name, std::string_view command) {
    EXPECT_THAT(run(command), IsEmpty());
    return value(name);
  };
  EXPECT_EQ(after("gamma", "cycle gamma 1.0 1.5 2"), "1.5");
  EXPECT_EQ(after("gamma", "cycle gamma 1.0 1.5 2"), "2");
  EXPECT_EQ(after("gamma", "cycle gamma 1.0 1.5 2"), "1");
  EXPECT_EQ(after("gamma", "cycle gamma 0.5 0.75"), "0.5") << "where none of them is set";
  EXPECT_EQ(after("color", "cycle color RED blue"), "blue");
  EXPECT_EQ(after("name", "cycle name a \"b c\""), "a");
  EXPECT_EQ(after("name", "cycle name a \"b c\""), "b c");
  for (const char* wrong : {"cycle", "cycle gamma", "cycle nothing 1 2", "cycle gamma 9"})
    EXPECT_EQ(run(wrong).size(), 1u) << wrong;
}

TEST_F(VariableCommands, SetaIsSet) {
  EXPECT_THAT(run("seta gamma 1.25"), IsEmpty());
  EXPECT_EQ(value("gamma"), "1.25");
  EXPECT_EQ(run("seta gamma").size(), 1u);
}

TEST_F(VariableCommands, SetMakesAVariable) {
  EXPECT_THAT(run("set Mod_Mode 2; seta mod_mode 3; mod_mode"), ElementsAre("\"Mod_Mode\" is \"3\""));
  EXPECT_TRUE(variables_.find("MOD_MODE")->is_kept);
  EXPECT_THAT(run("set hint \"two words\"; set hint a; reset hint"), IsEmpty());
  EXPECT_FALSE(variables_.find("hint")->is_kept);
  EXPECT_EQ(value("hint"), "");
  EXPECT_THAT(run("seta gamma 1"), IsEmpty());
  EXPECT_FALSE(variables_.find("gamma")->is_kept)
      << "registered ones are saved if they differ from their default";
}

TEST_F(VariableCommands, SetRefusesNamesThatCannotBeVariables) {
  run("alias short echo");
  for (const char* wrong : {"set echo 1", "set short 1", "set +jump 1", "set -jump 1", "set \"a b\" 1",
                            "set \"a;b\" 1", "set \"\" 1", "set \"//a\" 1", "set \"\xe9\" 1"})
    EXPECT_EQ(run(wrong).size(), 1u) << wrong;
  EXPECT_EQ(run("set " + std::string(65, 'a') + " 1").size(), 1u);
  EXPECT_THAT(run("set " + std::string(64, 'a') + " 1"), IsEmpty());
}

TEST_F(VariableCommands, SetMakesALimitedNumber) {
  for (std::size_t i = 0; i < Variables::kMaxUserMade; ++i) {
    const std::string name = "v" + std::to_string(i);
    ASSERT_TRUE(variables_.make(name, "1").ok());
  }
  EXPECT_THAT(run("set one_more 1"), ElementsAre(HasSubstr("already 1024 variables")));
  EXPECT_THAT(run("set v0 2"), IsEmpty());
}

TEST_F(VariableCommands, ResetallResetsAll) {
  run("gamma 2; viewsize 60; crosshair 1; color blue; name x; resetall");
  for (const Variable* variable : variables_.all()) EXPECT_EQ(variable->text, variable->default_text);
}

TEST_F(VariableCommands, UnaliasallForgetsAll) {
  EXPECT_THAT(run("alias a map; alias b map; unaliasall; alias"), IsEmpty());
}

TEST_F(VariableCommands, CvarlistMarksWhatHasChanged) {
  EXPECT_THAT(run("name x; cvarlist"),
              ElementsAre("  color \"red\"", "  crosshair \"0\"", "  gamma \"1\"", "* name \"x\"",
                          "  viewsize \"100\"", HasSubstr("5 variables;")));
  EXPECT_THAT(run("cvarlist C"), ElementsAre("  color \"red\"", "  crosshair \"0\"",
                                             HasSubstr("2 variables that begin with \"C\"")));
  EXPECT_THAT(run("cvarlist zz"), ElementsAre(HasSubstr("0 variables")));
}

TEST_F(VariableCommands, CmdlistListsCommandsOnly) {
  run("alias mapper map");
  EXPECT_THAT(run("cmdlist MA"), ElementsAre("  map", "1 command that begins with \"MA\""));
  EXPECT_THAT(run("cmdlist"), Contains("  cmdlist"));
  EXPECT_THAT(run("cmdlist"), Not(Contains("  gamma")));
  EXPECT_THAT(run("cmdlist"), Not(Contains("  mapper")));
}

TEST_F(VariableCommands, AproposSearchesNamesAndHelp) {
  EXPECT_THAT(run("apropos CROSS"), ElementsAre("crosshair: Shows a cross."));
  EXPECT_THAT(run("apropos level"), ElementsAre("map NAME starts a level."));
  EXPECT_THAT(run("find dark"), ElementsAre("gamma: Brightens the dark."));
  EXPECT_THAT(run("apropos zebra"), ElementsAre(HasSubstr("no command or variable mentions \"zebra\"")));
  for (const char* wrong : {"apropos", "apropos a b", "apropos \"\""})
    EXPECT_THAT(run(wrong), ElementsAre("usage: apropos WORD"));
}

TEST_F(VariableCommands, HelpKnowsAliases) {
  EXPECT_THAT(run("alias go \"map start\"; help GO"), ElementsAre("\"go\" is an alias of map start"));
}

TEST_F(VariableCommands, ValuesAreComparedAsTheyAreMeant) {
  const auto has = [&](const char* name, const char* text) {
    return has_value(*variables_.find(name), text);
  };
  EXPECT_TRUE(has("gamma", "1.0") && has("gamma", "+1") && has("crosshair", "off") && has("color", "Red"));
  EXPECT_FALSE(has("gamma", "1.1") || has("gamma", "x") || has("crosshair", "2") || has("name", "Player"));
}

}  // namespace
}  // namespace temblor::command
