#include "architecture/wording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "architecture/sources.h"

namespace temblor::test {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

// Every text that we write. CONTRIBUTING.md, the list of retired words, and the tests of this rule name them.
std::vector<std::string> text_files() {
  static constexpr std::array kTextTypes = {".h",  ".cpp",   ".md", ".qc",    ".src", ".txt",
                                            ".sh", ".cmake", ".py", ".level", ".art", ".json"};
  std::vector<std::string> paths = {"README.md", "CMakeLists.txt"};
  for (const char* top : {"src", "tests", "bench", "fuzz", "game", "cmake", "tools", "docs"}) {
    for (const auto& entry : fs::recursive_directory_iterator(repository_root() / top)) {
      const std::string path = entry.path().lexically_relative(repository_root()).generic_string();
      const bool is_text = std::ranges::find(kTextTypes, entry.path().extension()) != kTextTypes.end();
      const bool names_retired_words = path.starts_with("tests/architecture/");
      if (entry.is_regular_file() && is_text && !names_retired_words && !path.starts_with("fuzz/corpus/"))
        paths.push_back(path);
    }
  }
  return paths;
}

std::vector<RetiredWord> words_from(std::string_view text) {
  const auto words = parse_retired_words(text);
  EXPECT_TRUE(words.ok());
  return words.ok() ? *words : std::vector<RetiredWord>{};
}

std::vector<std::string> find_retired_words(const std::string& path, std::string_view text,
                                            const std::vector<RetiredWord>& words) {
  return RetiredWordFinder(words).find(path, text);
}

TEST(Wording, NoRetiredWordIsUsed) {
  const std::vector<RetiredWord> words =
      words_from(read_text(repository_root() / "tests/architecture/retired_words.txt"));
  ASSERT_GT(words.size(), 40u);
  RetiredWordFinder finder(words);
  std::vector<std::string> violations;
  for (const std::string& path : text_files()) {
    const auto found = finder.find(path, read_text(repository_root() / path));
    violations.insert(violations.end(), found.begin(), found.end());
  }
  EXPECT_THAT(violations, IsEmpty());
}

TEST(Wording, SentencesOfCommentsStartWithTheirSubject) {
  std::vector<std::string> violations;
  for (const std::string& path : text_files()) {
    if (!path.ends_with(".h") && !path.ends_with(".cpp") && !path.ends_with(".qc")) continue;
    const auto found = find_sentences_without_subject(path, read_text(repository_root() / path));
    violations.insert(violations.end(), found.begin(), found.end());
  }
  EXPECT_THAT(violations, IsEmpty());
}

TEST(WordingRules, FindSentencesWithoutSubject) {
  EXPECT_THAT(find_sentences_without_subject("a.h", "// What it shows.\nint a;  // Of two, the first.\n"),
              ElementsAre(HasSubstr("a.h:1:"), HasSubstr("a.h:2:")));
  EXPECT_THAT(find_sentences_without_subject("a.h", "// Draws it. As in stock Quake, it\n// sways.\n"),
              ElementsAre(HasSubstr("a.h:1:")));
  EXPECT_THAT(
      find_sentences_without_subject("a.h", "// It sways as in Quake. Cites \"A\n// Of B\" and ends.\n"),
      IsEmpty());
}

TEST(WordingRules, FindPartsOfNames) {
  const auto words = words_from("part: colour -> color\n");
  EXPECT_THAT(find_retired_words("a.h", "int fog_colour;\nColourTable t;\ncolor c;", words),
              ElementsAre(HasSubstr("a.h:1: 'fog_colour'"), HasSubstr("a.h:2: 'ColourTable'")));
  EXPECT_THAT(find_retired_words("a.h", "ANewGame; DrawnAnew;", words_from("part: anew -> again\n")),
              ElementsAre(HasSubstr("'DrawnAnew'")));
}

TEST(WordingRules, FindWholeNames) {
  const auto words = words_from("name: SpanRun -> Span\n");
  EXPECT_THAT(find_retired_words("a.h", "SpanRun a; SpanRunner b;", words),
              ElementsAre(HasSubstr("use 'Span'")));
}

TEST(WordingRules, FindPhrasesAcrossLines) {
  const auto words = words_from("# a comment\nphrase: but for -> except for\n");
  EXPECT_THAT(find_retired_words("a.h", "x\n// All of it But\n//   for the last.\n", words),
              ElementsAre(HasSubstr("a.h:2:")));
  EXPECT_THAT(find_retired_words("a.h", "// tribute forms\n", words), IsEmpty());
}

TEST(WordingRules, FindPatternsOfNames) {
  const auto words = words_from("pattern: \\b[a-z_]+_of\\( -> a verb\n");
  EXPECT_THAT(find_retired_words("a.h", "int x;\nint size_of(int);\nint of(int);\n", words),
              ElementsAre(HasSubstr("a.h:2: 'size_of('")));
}

TEST(WordingRules, FindTheSameNameInEachFileAndPatternsOnceInAFile) {
  RetiredWordFinder finder(words_from("part: colours -> colors\npattern: \\bkMost[A-Z] -> kMax...\n"));
  const std::string_view text = "kMostColours;\nkMostColours;\n";
  for (const char* path : {"a.h", "b.h"})
    EXPECT_THAT(finder.find(path, text),
                UnorderedElementsAre(HasSubstr("use 'colors'"), HasSubstr("use 'colors'"),
                                     HasSubstr("use 'kMax...'")))
        << path;
}

TEST(WordingRules, IgnoreMarkedLines) {
  const auto words = words_from("part: colour -> color\n");
  EXPECT_THAT(find_retired_words("a.h", "alias(\"colour\");  // old spelling\nint colour;\n", words),
              ElementsAre(HasSubstr("a.h:2:")));
}

TEST(WordingRules, RejectLinesThatAreNoRules) {
  EXPECT_FALSE(parse_retired_words("part colour\n").ok());
  EXPECT_FALSE(parse_retired_words("word: colour -> color\n").ok());
}

}  // namespace
}  // namespace temblor::test
