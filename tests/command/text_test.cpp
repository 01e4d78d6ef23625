#include "command/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace temblor::command {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::string first_command(std::string_view text) {
  return std::string(text.substr(0, command_length(text)));
}

TEST(CommandLength, EndsAtNewlineOrSemicolon) {
  EXPECT_EQ(first_command("map start; god"), "map start");
  EXPECT_EQ(first_command("map start\ngod"), "map start");
  EXPECT_EQ(first_command(";god"), "");
  EXPECT_EQ(first_command("\n"), "");
  EXPECT_EQ(first_command("god"), "god");
  EXPECT_EQ(first_command(""), "");
}

TEST(CommandLength, QuotesHoldSemicolonsButNotNewlines) {
  EXPECT_EQ(first_command("bind x \"a; b\"; c"), "bind x \"a; b\"");
  EXPECT_EQ(first_command("say \"open\nnext"), "say \"open");
}

TEST(SplitCommands, KeepsEmptyCommandsAndComments) {
  EXPECT_EQ(split_commands("a; \"b;c\" // d;e\n;f\n"),
            (std::vector<std::string_view>{"a", " \"b;c\" // d;e", "", "f"}));
  EXPECT_TRUE(split_commands("").empty());
}

TEST(CommandLength, CommentsReachToTheEndOfTheLine) {
  EXPECT_EQ(first_command("god // be; strong \"\nnext"), "god // be; strong \"");
  EXPECT_EQ(first_command("say \"http://x\"; next"), "say \"http://x\"");
}

TEST(SplitWords, AtWhiteSpace) {
  EXPECT_THAT(split_words("  map \t start\r"), ElementsAre("map", "start"));
  EXPECT_THAT(split_words(""), IsEmpty());
  EXPECT_THAT(split_words(" \t "), IsEmpty());
}

TEST(SplitWords, QuotesMakeOneWord) {
  EXPECT_THAT(split_words("say \"hello  there\" \"\""), ElementsAre("say", "hello  there", ""));
  EXPECT_THAT(split_words("say \"open end"), ElementsAre("say", "open end"));
  EXPECT_THAT(split_words("a\"b c\"d"), ElementsAre("a", "b c", "d"));
  EXPECT_THAT(split_words("\""), ElementsAre(""));
}

TEST(SplitWords, CommentsAreLeftOut) {
  EXPECT_THAT(split_words("god // mode"), ElementsAre("god"));
  EXPECT_THAT(split_words("god//mode"), ElementsAre("god"));
  EXPECT_THAT(split_words("// all of it"), IsEmpty());
  EXPECT_THAT(split_words("say \"//\" /x/"), ElementsAre("say", "//", "/x/"));
}

TEST(SplitWords, OtherPunctuationIsOrdinary) {
  EXPECT_THAT(split_words("connect 10.0.0.1:26000 {(')}"), ElementsAre("connect", "10.0.0.1:26000", "{(')}"));
}

// The reference: a state machine that splits text into commands and words, one character at a time.
std::vector<std::vector<std::string>> reference_commands(std::string_view text) {
  enum class Where { kBetween, kWord, kQuote, kComment } where = Where::kBetween;
  std::vector<std::vector<std::string>> commands(1);
  std::vector<std::string>* words = &commands.back();
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool slashes = c == '/' && i + 1 < text.size() && text[i + 1] == '/';
    if (c == '\n' || (c == ';' && (where == Where::kBetween || where == Where::kWord))) {
      words = &commands.emplace_back();
      where = Where::kBetween;
    } else if (where == Where::kQuote) {
      if (c == '"')
        where = Where::kBetween;
      else
        words->back() += c;
    } else if (where == Where::kComment || slashes) {
      where = Where::kComment;
    } else if (c == '"') {
      words->emplace_back();
      where = Where::kQuote;
    } else if (c == ' ') {
      where = Where::kBetween;
    } else {
      if (where == Where::kBetween) words->emplace_back();
      words->back() += c;
      where = Where::kWord;
    }
  }
  return commands;
}

TEST(CommandText, RandomTextsSplitAsTheReferenceSays) {
  constexpr std::string_view kAlphabet = "ab \"\";;\n//";
  for (unsigned seed = 0; seed < 5000; ++seed) {
    std::mt19937 random(seed);
    std::string text(random() % 24, ' ');
    for (char& c : text) c = kAlphabet[random() % kAlphabet.size()];
    std::vector<std::vector<std::string>> commands;
    std::string_view rest = text;
    for (;;) {
      const std::size_t length = command_length(rest);
      ASSERT_LE(length, rest.size());
      commands.push_back(split_words(rest.substr(0, length)));
      if (length == rest.size()) break;
      rest.remove_prefix(length + 1);
    }
    EXPECT_EQ(commands, reference_commands(text)) << "seed " << seed << ": " << text;
  }
}

TEST(ParseNumber, TakesWhatIsANumberAltogether) {
  EXPECT_EQ(parse_number("-1.5"), -1.5);
  EXPECT_EQ(parse_number("+2e3"), 2000.0);
  EXPECT_EQ(parse_whole_number("-12"), -12);
  EXPECT_EQ(parse_whole_number("+7"), 7);
  for (const char* wrong : {"", "+", "abc", "1x", " 1", "1 ", "nan", "inf", "1e999"}) {
    EXPECT_EQ(parse_number(wrong), std::nullopt) << wrong;
    EXPECT_EQ(parse_whole_number(wrong), std::nullopt) << wrong;
  }
  EXPECT_EQ(parse_whole_number("1.5"), std::nullopt);
  EXPECT_EQ(parse_whole_number("99999999999999999999"), std::nullopt);
}

TEST(JoinWords, SplitsIntoTheSameWordsAgain) {
  constexpr std::string_view kAlphabet = "ab ;/{}:'";
  for (unsigned seed = 0; seed < 2000; ++seed) {
    std::mt19937 random(seed);
    std::vector<std::string> words(1 + random() % 4);
    for (std::string& word : words) {
      word.resize(random() % 6);
      for (char& c : word) c = kAlphabet[random() % kAlphabet.size()];
    }
    const std::string text = join_words(words);
    EXPECT_EQ(command_length(text), text.size()) << "seed " << seed << ": " << text;
    EXPECT_EQ(split_words(text), words) << "seed " << seed << ": " << text;
  }
}

TEST(JoinWords, LeavesOutWhatCannotBeQuoted) {
  EXPECT_EQ(join_words({"say", "a\"b\nc"}), "say abc");
}

}  // namespace
}  // namespace temblor::command
