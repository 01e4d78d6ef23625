#include "command/completion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "command/colors.h"
#include "command/console.h"

namespace temblor::command {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class CompletionTest : public ::testing::Test {
 protected:
  CompletionTest() {
    variables_.add_int("m_speed", 3, 0, 20, "How far the mouse turns.");
    variables_.add_bool("m_filter", false, "Smooths it.");
    variables_.add_choice("color", kColors, "A color.");
    console_.add_command("Map", "map NAME starts a level.", [](Console::Arguments) {});
    console_.set_argument_list("map", [] {
      return std::vector<Candidate>{{"start", CandidateKind::kArgument, "", "Welcome"},
                                    {"e1m1", CandidateKind::kArgument, "", "The Slipgate Complex"},
                                    {"e1m2", CandidateKind::kArgument, "", ""}};
    });
    console_.append("alias mine \"map start\"");
    console_.run();
  }
  // The names of the candidates, and where the word begins.
  std::vector<std::string> names(std::string_view line) const {
    std::vector<std::string> names;
    for (const Candidate& candidate : console_.complete_line(line).candidates)
      names.push_back(candidate.name);
    return names;
  }
  std::size_t begin(std::string_view line) const { return console_.complete_line(line).begin; }

  Variables variables_;
  Console console_{variables_, [](std::string_view) {}};
};

TEST_F(CompletionTest, CandidatesSayWhatTheyAre) {
  const std::vector<Candidate> found = console_.candidates("M");
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[0].name, "m_filter");
  EXPECT_EQ(found[1].name, "m_speed");
  EXPECT_EQ(found[1].kind, CandidateKind::kVariable);
  EXPECT_EQ(found[1].value, "3");
  EXPECT_EQ(found[1].help, "How far the mouse turns.");
  EXPECT_EQ(found[2].name, "map");
  EXPECT_EQ(found[2].kind, CandidateKind::kCommand);
  EXPECT_EQ(found[2].help, "map NAME starts a level.");
  EXPECT_EQ(found[3].name, "mine");
  EXPECT_EQ(found[3].kind, CandidateKind::kAlias);
  EXPECT_EQ(found[3].value, "map start");
}

TEST_F(CompletionTest, FirstWordsAreNames) {
  EXPECT_THAT(names("m_"), ElementsAre("m_filter", "m_speed"));
  EXPECT_EQ(begin("m_"), 0u);
  EXPECT_THAT(names("echo x;  MI"), ElementsAre("mine"));
  EXPECT_EQ(begin("echo x;  MI"), 9u);
  EXPECT_THAT(names("\"m_s"), ElementsAre("m_speed"));
  EXPECT_EQ(names("").size(), console_.candidates("").size());
  EXPECT_EQ(names("say a; ").size(), console_.candidates("").size());
}

TEST_F(CompletionTest, ArgumentsAreOfTheirCommand) {
  EXPECT_THAT(names("map "), ElementsAre("e1m1", "e1m2", "start"));
  EXPECT_THAT(names("MAP E1"), ElementsAre("e1m1", "e1m2"));
  EXPECT_EQ(begin("MAP E1"), 4u);
  EXPECT_THAT(names("map e1m1 s"), IsEmpty()) << "it takes one";
  EXPECT_THAT(names("map \"st"), ElementsAre("start"));
  EXPECT_THAT(names("echo "), IsEmpty());
  EXPECT_THAT(names("nothing "), IsEmpty());
}

TEST_F(CompletionTest, BuiltInCommandsKnowNames) {
  EXPECT_THAT(names("help mi"), ElementsAre("mine"));
  EXPECT_THAT(names("help m_f"), ElementsAre("m_filter"));
  EXPECT_THAT(names("toggle m"), ElementsAre("m_filter", "m_speed"));
  EXPECT_THAT(names("unalias m"), ElementsAre("mine"));
  EXPECT_THAT(names("cmdlist ma"), ElementsAre("map"));
}

TEST_F(CompletionTest, ValuesAreOfTheirVariable) {
  EXPECT_THAT(names("color "), ElementsAre("blue", "green", "red"));
  EXPECT_THAT(names("color G"), ElementsAre("green"));
  EXPECT_THAT(names("set color r"), ElementsAre("red"));
  EXPECT_THAT(names("m_filter "), ElementsAre("0", "1"));
  EXPECT_THAT(names("m_speed "), IsEmpty());
}

TEST_F(CompletionTest, HintsSayWhatIsTaken) {
  EXPECT_THAT(console_.complete_line("m_speed ").hint,
              AllOf(HasSubstr("m_speed is \"3\""), HasSubstr("0 to 20"), HasSubstr("mouse")));
  EXPECT_EQ(console_.complete_line("map ").hint, "map NAME starts a level.");
  EXPECT_EQ(console_.complete_line("set m_speed ").hint, console_.complete_line("m_speed ").hint);
  EXPECT_EQ(console_.complete_line("nothing ").hint, "");
}

// For any input, all candidates begin with the word.
TEST_F(CompletionTest, CandidatesAlwaysBeginWithTheWord) {
  for (const std::string line :
       {"m", "set color b", "map e", ";;m_", "\"", "\";", "a \"b", "//", "// m", "\x80"}) {
    const Completion completion = console_.complete_line(line);
    ASSERT_LE(completion.begin, line.size()) << line;
    const std::string word = line.substr(completion.begin);
    for (const Candidate& candidate : completion.candidates)
      EXPECT_EQ(candidate.name.substr(0, word.size()), word) << line;
  }
}

}  // namespace
}  // namespace temblor::command
