#include "command/console.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "command/colors.h"

namespace temblor::command {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

class ConsoleTest : public ::testing::Test {
 protected:
  ConsoleTest() {
    variables_.add_int("sensitivity", 3, 0, 20, "How far the mouse turns.");
    variables_.add_bool("crosshair", false, "Shows a cross.");
    variables_.add_choice("color", kColors, "A color.");
    console_.add_command("note", "Notes its words.", [this](Console::Arguments arguments) {
      std::string line;
      for (const std::string& word : arguments.subspan(1)) line += "[" + word + "]";
      notes_.push_back(line);
    });
    console_.set_loader([this](std::string_view name) -> base::Result<std::string> {
      const auto found = files_.find(name);
      if (found == files_.end()) return base::error(base::ErrorCode::kNotFound, "no file {}", name);
      return found->second;
    });
  }

  void run(std::string_view text) {
    console_.append(text);
    console_.run();
  }

  Variables variables_;
  std::vector<std::string> lines_, notes_;
  std::map<std::string, std::string, std::less<>> files_;
  Console console_{variables_, [this](std::string_view line) { lines_.emplace_back(line); }};
};

TEST_F(ConsoleTest, RunsCommandsInOrder) {
  run("note one; note two words // no three\nNOTE \"quoted; text\"");
  EXPECT_THAT(notes_, ElementsAre("[one]", "[two][words]", "[quoted; text]"));
  EXPECT_THAT(lines_, IsEmpty());
  EXPECT_FALSE(console_.has_pending());
}

TEST_F(ConsoleTest, NothingRunsBeforeRun) {
  console_.append("note one");
  EXPECT_THAT(notes_, IsEmpty());
  EXPECT_TRUE(console_.has_pending());
}

TEST_F(ConsoleTest, AppendedTextsDoNotRunTogether) {
  console_.append("note o");
  console_.append("note two");
  console_.run();
  EXPECT_THAT(notes_, ElementsAre("[o]", "[two]"));
}

// The rules see each command of the server, and none of the player's.
TEST_F(ConsoleTest, TheServersTextKeepsItsSource) {
  std::vector<std::string> seen;
  console_.set_server_rules({.may_run =
                                 [&](Console::Arguments words) {
                                   seen.push_back(words.back());
                                   return words.back() != "refused";
                                 },
                             .finish = [&] { seen.emplace_back("end"); }});
  files_["server.cfg"] = "note file; note refused";
  console_.append("alias mine \"note own\"; note player");
  console_.append("alias theirs \"note alias\"; wait; mine; exec server.cfg; note last", Source::kServer);
  console_.append("note player; theirs; note player");
  for (int i = 0; i < 2; ++i) console_.run();
  EXPECT_THAT(seen, ElementsAre("note alias", "wait", "end", "mine", "own", "server.cfg", "file", "refused",
                                "last", "end", "alias", "end"));
  EXPECT_THAT(notes_,
              ElementsAre("[player]", "[own]", "[file]", "[last]", "[player]", "[alias]", "[player]"));
}

TEST_F(ConsoleTest, DropsOnlyTheServersText) {
  console_.append("note 1; wait; note 2");
  console_.append("alias theirs \"wait; note 3\"; theirs; note 4", Source::kServer);
  console_.append("note 5");
  console_.append("note 6", Source::kServer);
  console_.append("note 7; wait; note 8");
  console_.run();
  console_.run();
  console_.drop_server_text();
  for (int i = 0; i < 2; ++i) console_.run();
  EXPECT_THAT(notes_, ElementsAre("[1]", "[2]", "[5]", "[7]", "[8]"));
  EXPECT_FALSE(console_.has_pending());
}

TEST_F(ConsoleTest, UnknownNamesGiveALine) {
  run("fly high");
  EXPECT_THAT(lines_, ElementsAre("unknown command or variable \"fly\""));
}

TEST_F(ConsoleTest, NumbersOutOfRangeAreMovedIntoIt) {
  run("sensitivity 99; set sensitivity -1; sensitivity; sensitivity fast; sensitivity");
  EXPECT_THAT(lines_, ElementsAre(AllOf(HasSubstr("0 to 20"), HasSubstr("it is \"20\" now")),
                                  HasSubstr("it is \"0\" now"), "\"sensitivity\" is \"0\"",
                                  HasSubstr("cannot be \"fast\""), "\"sensitivity\" is \"0\""));
}

TEST_F(ConsoleTest, VariablesAreShownAndSet) {
  run("Sensitivity; sensitivity 7; sensitivity; set sensitivity 8; sensitivity 99; reset sensitivity");
  EXPECT_THAT(lines_,
              ElementsAre("\"sensitivity\" is \"3\"", "\"sensitivity\" is \"7\"", HasSubstr("0 to 20")));
  EXPECT_EQ(variables_.find("sensitivity")->text, "3");
}

TEST_F(ConsoleTest, ToggleGoesThroughFixedValues) {
  run("toggle crosshair; toggle color");
  EXPECT_EQ(variables_.find("crosshair")->text, "1");
  EXPECT_EQ(variables_.find("color")->text, "green");
  run("toggle crosshair; toggle color; toggle color");
  EXPECT_EQ(variables_.find("crosshair")->text, "0");
  EXPECT_EQ(variables_.find("color")->text, "red");
  EXPECT_THAT(lines_, IsEmpty());
  run("toggle sensitivity; toggle nothing; toggle");
  EXPECT_EQ(lines_.size(), 3u);
}

TEST_F(ConsoleTest, WaitPutsTheRestOff) {
  run("note 1; wait; note 2; wait; wait; note 3");
  EXPECT_THAT(notes_, ElementsAre("[1]"));
  console_.run();
  EXPECT_THAT(notes_, ElementsAre("[1]", "[2]"));
  console_.run();
  EXPECT_EQ(notes_.size(), 2u);
  console_.run();
  EXPECT_THAT(notes_, ElementsAre("[1]", "[2]", "[3]"));
  EXPECT_FALSE(console_.has_pending());
}

TEST_F(ConsoleTest, AliasesExpandInPlace) {
  run("alias both \"note a; note b\"; note before; BOTH; note after");
  EXPECT_THAT(notes_, ElementsAre("[before]", "[a]", "[b]", "[after]"));
}

TEST_F(ConsoleTest, AliasOfSeveralWordsKeepsItsQuotes) {
  run("alias greet note \"good day\" you; greet");
  EXPECT_THAT(notes_, ElementsAre("[good day][you]"));
}

TEST_F(ConsoleTest, AliasesMayUseEachOtherAndWait) {
  run("alias inner \"note x; wait; note y\"; alias outer \"inner; note z\"; outer; note last");
  EXPECT_THAT(notes_, ElementsAre("[x]"));
  console_.run();
  EXPECT_THAT(notes_, ElementsAre("[x]", "[y]", "[z]", "[last]"));
}

TEST_F(ConsoleTest, AliasesAreShownReplacedAndRemoved) {
  run("alias a note 1; alias A note 2; alias a; alias; unalias a; a; alias a; unalias a");
  EXPECT_THAT(lines_, ElementsAre("a: note 2", "a: note 2", "unknown command or variable \"a\"",
                                  "there is no alias \"a\"", "there is no alias \"a\""));
}

TEST_F(ConsoleTest, AliasesHideNothing) {
  run("alias note \"echo hidden\"; alias sensitivity \"echo hidden\"; note 1; sensitivity");
  EXPECT_THAT(notes_, ElementsAre("[1]"));
  ASSERT_EQ(lines_.size(), 3u);
  EXPECT_THAT(lines_[0], HasSubstr("cannot be an alias"));
  EXPECT_THAT(lines_[1], HasSubstr("cannot be an alias"));
  EXPECT_EQ(lines_[2], "\"sensitivity\" is \"3\"");
}

TEST_F(ConsoleTest, AliasesThatCallThemselvesEnd) {
  for (const char* text : {"alias a a; a", "alias a \"a; a\"; a", "alias a b; alias b \"a; b\"; b"}) {
    lines_.clear();
    run(std::string(text) + "; note never");
    ASSERT_EQ(lines_.size(), 1u) << text;
    EXPECT_THAT(lines_[0], HasSubstr("call itself"));
    EXPECT_THAT(notes_, IsEmpty()) << "the rest is dropped";
    EXPECT_FALSE(console_.has_pending());
  }
  run("note alive");
  EXPECT_THAT(notes_, ElementsAre("[alive]"));
}

TEST_F(ConsoleTest, AliasesThatWaitMayCallThemselvesForever) {
  run("alias loop \"note tick; wait; loop\"; loop");
  for (int frame = 1; frame < 3 * Console::kMaxExpansions; ++frame) console_.run();
  EXPECT_EQ(notes_.size(), 3u * Console::kMaxExpansions);
  EXPECT_THAT(lines_, IsEmpty());
}

// Few expansions, but each one inserts a long text.
TEST_F(ConsoleTest, LongAliasesThatCallThemselvesEndSooner) {
  run("alias a \"a" + std::string(200'000, ' ') + "\"; a; note never");
  ASSERT_EQ(lines_.size(), 1u);
  EXPECT_THAT(lines_[0], HasSubstr("call itself"));
  EXPECT_THAT(notes_, IsEmpty());
  run("note alive");
  EXPECT_THAT(notes_, ElementsAre("[alive]"));
}

// Each line would load the whole megabyte again.
TEST_F(ConsoleTest, MegabyteFileThatExecutesItselfEnds) {
  std::string text;
  while (text.size() + 1000 < Console::kMaxPendingChars) text += "exec a.cfg\n";
  files_["a.cfg"] = text;
  run("exec a.cfg; note never");
  ASSERT_FALSE(lines_.empty());
  EXPECT_LT(lines_.size(), 20u);
  EXPECT_THAT(lines_.back(), HasSubstr("call itself"));
  EXPECT_THAT(notes_, IsEmpty());
}

TEST_F(ConsoleTest, MegabyteLinesGetShortAnswers) {
  const std::string megabyte(Console::kMaxPendingChars - 100, 'x');
  for (const char* before :
       {"", "sensitivity ", "help ", "inc ", "unalias ", "cycle color ", "apropos ", "reset "}) {
    lines_.clear();
    run(before + megabyte);
    for (const std::string& line : lines_) EXPECT_LT(line.size(), 200u) << before;
    EXPECT_EQ(lines_.size(), 1u) << before;
  }
}

TEST_F(ConsoleTest, TooMuchTextIsRefused) {
  console_.append("note kept");
  console_.append(std::string(Console::kMaxPendingChars, 'x'));
  EXPECT_EQ(lines_.size(), 1u);
  console_.run();
  EXPECT_THAT(notes_, ElementsAre("[kept]"));
  EXPECT_EQ(lines_.size(), 1u);
}

TEST_F(ConsoleTest, ManyShortCommandsAreQuick) {
  std::string text;
  while (text.size() + 8 < Console::kMaxPendingChars) text += "wait\n;;;";
  console_.append(text);
  std::size_t runs = 0;
  for (; console_.has_pending(); ++runs) console_.run();
  EXPECT_EQ(runs, text.size() / 8 + 1) << "the commands after the last wait need one more run";
}

TEST_F(ConsoleTest, ExecRunsAFileInPlace) {
  files_["a.cfg"] = "note a // comment\nexec b.cfg\nnote c";
  files_["b.cfg"] = "note b";
  run("exec a.cfg; note d");
  EXPECT_THAT(notes_, ElementsAre("[a]", "[b]", "[c]", "[d]"));
}

TEST_F(ConsoleTest, ExecOfAFileThatExecsItselfEnds) {
  files_["a.cfg"] = "exec a.cfg";
  run("exec a.cfg");
  ASSERT_EQ(lines_.size(), 2u);
  EXPECT_THAT(lines_[1], HasSubstr("call itself"));
}

TEST_F(ConsoleTest, ExecReportsOnceWhenTyped) {
  files_["a.cfg"] = "exec b.cfg\nwait\nexec b.cfg";
  files_["b.cfg"] = "note b";
  run("exec a.cfg");
  console_.run();
  EXPECT_THAT(notes_, ElementsAre("[b]", "[b]"));
  EXPECT_THAT(lines_, ElementsAre("exec a.cfg"));
}

TEST_F(ConsoleTest, ErrorsInFilesNameFileAndLine) {
  files_["a.cfg"] =
      "// a comment\n\nnote 1; fly high; sensitivity 99\ntoggle nothing\r\nwait\n"
      "exec b.cfg; walk\nalias hop \"note 2; skip\"\nexec none.cfg";
  files_["b.cfg"] = "\nrun away // no newline after it";
  run("exec a.cfg; jump");
  console_.append("swim");
  console_.run();
  run("hop");
  EXPECT_THAT(
      lines_,
      ElementsAre("exec a.cfg", "a.cfg:3: unknown command or variable \"fly\"",
                  AllOf(StartsWith("a.cfg:3: "), HasSubstr("0 to 20")),
                  "a.cfg:4: there is no variable \"nothing\"", "b.cfg:2: unknown command or variable \"run\"",
                  "a.cfg:6: unknown command or variable \"walk\"", "a.cfg:8: no file none.cfg",
                  "unknown command or variable \"jump\"", "unknown command or variable \"swim\"",
                  "unknown command or variable \"skip\""));
}

// An alias has no lines of its own, so errors name the line that calls it.
TEST_F(ConsoleTest, ErrorsInAliasesNameCallingLine) {
  files_["a.cfg"] =
      "alias inner \"wait; oops; oops\"\nalias outer \"note x; inner; last\"\nouter\n\nouter; end\n";
  run("exec a.cfg");
  for (int frame = 0; frame < 2; ++frame) console_.run();
  const auto at = [](int line, const char* name) {
    return fmt::format("a.cfg:{}: unknown command or variable \"{}\"", line, name);
  };
  EXPECT_THAT(lines_, ElementsAre("exec a.cfg", at(3, "oops"), at(3, "oops"), at(3, "last"), at(5, "oops"),
                                  at(5, "oops"), at(5, "last"), at(5, "end")));
  EXPECT_FALSE(console_.has_pending());
}

TEST_F(ConsoleTest, CommandsTellTheirErrorsWithTheFilesLine) {
  console_.add_command("fail", "Says that it failed.", [this](Console::Arguments) {
    console_.print_error("it failed");
    console_.execute("no_such_thing");
  });
  files_["a.cfg"] = "note 1\nfail";
  run("exec a.cfg; fail");
  EXPECT_THAT(lines_, ElementsAre("exec a.cfg", "a.cfg:2: it failed",
                                  "a.cfg:2: unknown command or variable \"no_such_thing\"", "it failed",
                                  "unknown command or variable \"no_such_thing\""));
}

TEST_F(ConsoleTest, CommandsThatNeedANameSaySo) {
  for (const char* command : {"unalias", "reset", "toggle", "cycle", "inc", "set", "exec", "apropos"}) {
    lines_.clear();
    run(command);
    EXPECT_EQ(lines_.size(), 1u) << command;
  }
}

TEST_F(ConsoleTest, ExecSaysWhatIsWrong) {
  run("exec none.cfg; exec; exec a b");
  ASSERT_EQ(lines_.size(), 3u);
  EXPECT_EQ(lines_[0], "no file none.cfg");
  console_.set_loader(nullptr);
  run("exec a.cfg");
  EXPECT_EQ(lines_.back(), "exec is not available here: there are no config files");
}

TEST_F(ConsoleTest, EchoHelpAndList) {
  run("echo a  \"b  c\"; help note; help sensitivity; help nothing; help a b; list sens");
  EXPECT_THAT(lines_, ElementsAre("a b  c", "Notes its words.",
                                  "How far the mouse turns. Takes a whole number from 0 to 20; 3 by default.",
                                  HasSubstr("nothing"), HasSubstr("help NAME"), "sensitivity"));
}

TEST_F(ConsoleTest, HelpAloneListsTheCommands) {
  console_.add_command("-note", "Ends +note.", [](Console::Arguments) {});
  run("help");
  EXPECT_THAT(lines_, Contains("note: Notes its words."));
  EXPECT_THAT(lines_, Contains("echo TEXT prints the text."));
  EXPECT_THAT(lines_, Not(Contains(HasSubstr("-note"))));
  EXPECT_THAT(lines_, Not(Contains(HasSubstr("crosshair"))));
  for (const char* more : {"help NAME", "cvarlist", "apropos WORD"})
    EXPECT_THAT(lines_.back(), HasSubstr(more));
}

TEST_F(ConsoleTest, EveryCommandHasHelp) {
  for (const std::string& name : console_.complete("")) {
    lines_.clear();
    run("help " + name);
    ASSERT_EQ(lines_.size(), 1u) << name;
    EXPECT_GT(lines_[0].size(), 10u) << name;
  }
}

TEST_F(ConsoleTest, CompletesNamesOfEveryKind) {
  run("alias setup note; alias other note");
  EXPECT_THAT(console_.complete("SE"), ElementsAre("sensitivity", "set", "seta", "setup"));
  EXPECT_THAT(console_.complete("zz"), IsEmpty());
}

TEST_F(ConsoleTest, CommandsMayAppendAndExecute) {
  console_.add_command("twice", "Notes now and later.", [this](Console::Arguments) {
    console_.append("note later");
    console_.execute("note now");
  });
  run("twice; note between");
  EXPECT_THAT(notes_, ElementsAre("[now]", "[between]", "[later]"));
}

TEST_F(ConsoleTest, TwoConsolesShareOnlyTheirVariables) {
  std::vector<std::string> other_lines;
  Console other(variables_, [&](std::string_view line) { other_lines.emplace_back(line); });
  run("alias mine note; sensitivity 9");
  other.append("mine; sensitivity");
  other.run();
  EXPECT_THAT(other_lines, ElementsAre("unknown command or variable \"mine\"", "\"sensitivity\" is \"9\""));
}

}  // namespace
}  // namespace temblor::command
