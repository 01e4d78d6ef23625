#include "formats/game/localization.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace temblor::test {
namespace {

using formats::Localization;
using formats::LocalizationProblem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

formats::ReadLocalization read_or_die(std::string_view text) {
  return formats::read_localization(text).value();
}
std::string read_text(std::string_view line) {
  const auto read = read_or_die(fmt::format("key = {}", line));
  return read.problem_count > 0 ? read.problems[0].what : read.localization.localize("$key");
}

TEST(Localization, ReplacesAKeyAtTheStart) {
  const auto read = read_or_die(
      "\xef\xbb\xbf// comment\r\nmap_e1 = \"Slip\"\r\n\n  map_e2=\"two\" // rest\nmap_e1 = \"Gate\"");
  EXPECT_EQ(read.problem_count, 0u);
  const Localization& texts = read.localization;
  EXPECT_EQ(texts.localize("$map_e1"), "Gate") << "the last line with a key counts";
  EXPECT_EQ(texts.localize("$map_e2"), "two");
  EXPECT_EQ(texts.localize("$map_e1\n"), "Gate\n");
  for (const char* const other :
       {"", "$", "$map", "$map_e", "$map_e10", "map_e1", " $map_e1", "$$map_e1", "\x01$map_e1"}) {
    EXPECT_EQ(texts.localize(other), other);
    EXPECT_FALSE(texts.has_text_for(other)) << other;
  }
  EXPECT_TRUE(texts.has_text_for("$map_e2 and more"));
}

TEST(Localization, UnescapesTexts) {
  EXPECT_EQ(read_text(R"("a\nb\tc\"d\\e")"), "a\nb\tc\"d\\e");
  EXPECT_EQ(read_text(R"("\q // no comment")"), "\\q // no comment");
  EXPECT_EQ(read_text(R"("")"), "");
  EXPECT_EQ(read_text("\"\\ü\""), "\\u");
}

TEST(Localization, UsesTheLettersOfTheGame) {
  EXPECT_EQ(read_text("\"Schlüssel, große Tür, ÀÖÿ, œuf, ¡No!, “x”… – «y»\""),
            "Schlussel, grosse Tur, AOy, oeuf, !No!, \"x\"... - \"y\"");
  EXPECT_EQ(read_text("\"Zażółć gęślą jaźń, Łódź, İstanbul, čeština\""),
            "Zazolc gesla jazn, Lodz, Istanbul, cestina");
  EXPECT_EQ(read_text("\"鍵 €\""), "? ?");
  EXPECT_EQ(read_text("\"a\xff\xc3 b\xc3\""), "a?? b?") << "invalid UTF-8";
}

// The spellings are those of English atlases and dictionaries.
TEST(Localization, WritesRussianInLatinLetters) {
  EXPECT_EQ(read_text("\"Москва, Хрущёв, борщ, Чайковский\""), "Moskva, Khrushchyov, borshch, Chaykovskiy");
  EXPECT_EQ(read_text("\"Юрий Жданов: объект №7 (съезд), цыплята, ЭЛЬБРУС\""),
            "Yuriy Zhdanov: obekt ?7 (sezd), tsyplyata, ELBRUS");
  const auto read = read_or_die("a = \"Ключ\"\nb = \"鍵\"\nc = \"key\"\nd = \"鍵 €\"\n");
  EXPECT_EQ(read.unknown_letters, 2u);
}

TEST(Localization, FillsPlacesOfJoinedTexts) {
  const Localization texts = read_or_die(
                                 "got = \"You got {0}\\n\"\nitem = \"the item\"\nkill = \"{0} killed {1}\"\n"
                                 "plain = \"Plain\"\nplainly = \"Plainly\"")
                                 .localization;
  EXPECT_EQ(texts.localize_joined("$got$item\n"), "You got the item\n\n");
  EXPECT_EQ(texts.localize_joined("$got $item"), "You got the item\n");
  EXPECT_EQ(texts.localize_joined("$kill$item$plain\n\n"), "the item killed Plain\n\n");
  EXPECT_EQ(texts.localize_joined("$killRanger\n"), "Ranger killed {1}\n") << "one argument is known";
  EXPECT_EQ(texts.localize_joined("$kill"), "{0} killed {1}");
  EXPECT_EQ(texts.localize_joined("$plain and more"), "Plain and more");
  EXPECT_EQ(texts.localize_joined("$plainly"), "Plainly");
  for (const std::string other : {"", "$", "$plainest", "$none$item", "it is $plain", "\x01$plain"})
    EXPECT_EQ(texts.localize_joined(other), other);
  const std::string keys = "$kill" + std::string(100000, '$');
  EXPECT_EQ(texts.localize_joined(keys), "$ killed $");
  EXPECT_EQ(texts.localize_joined("$" + std::string(100000, 'k')).size(), 100001u);
}

TEST(Localization, FollowsReferencesAndFindsLoops) {
  const auto read = read_or_die(
      "a = \"$b\"\nb = \"$c\"\nc = \"end\"\nself = \"$self\"\nx = \"$y\"\ny = \"$x\"\nnone = "
      "\"$other\"\nmore = \"$c!\"");
  const Localization& texts = read.localization;
  EXPECT_EQ(texts.localize("$a"), "end");
  EXPECT_EQ(texts.localize("$none"), "$other");
  EXPECT_EQ(texts.localize("$more"), "$c!") << "only a whole text is a reference";
  EXPECT_EQ(texts.localize("$self"), "$self");
  EXPECT_THAT(read.problems, ElementsAre(LocalizationProblem{4, "self: \"$self\" refers to itself"},
                                         LocalizationProblem{5, "x: \"$y\" refers to itself"},
                                         LocalizationProblem{6, "y: \"$x\" refers to itself"}));
}

TEST(Localization, ABadLineCostsOnlyItself) {
  const auto read =
      read_or_die("no equals\n = \"no key\"\na b = \"x\"\nkey = none\nkey = \"cut\nok = \"fine\"\n" +
                  std::string(200, 'k') + " = \"x\"\nlong = \"" + std::string(9000, 'x') + "\"");
  EXPECT_EQ(read.localization.texts(), (Localization::Texts{{"ok", "fine"}}));
  EXPECT_THAT(read.problems,
              ElementsAre(LocalizationProblem{1, "no '=' between a key and its text"},
                          LocalizationProblem{2, "no key before '='"},
                          LocalizationProblem{3, "\"a b\" is not a key: letters, digits, '_', '-', and '.'"},
                          LocalizationProblem{4, "key: no text in quotes after '='"},
                          LocalizationProblem{5, "key: the text has no closing quote"},
                          LocalizationProblem{7, "a key of 200 characters, the limit is 128"},
                          LocalizationProblem{8, "long: a text of 9000 characters, the limit is 8192"}));
}

TEST(Localization, EveryTruncationKeepsTheTextsBefore) {
  const std::string whole = "first = \"1\"\nsecond = \"two\"\n";
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto read = read_or_die(whole.substr(0, size));
    EXPECT_EQ(read.localization.has_text_for("$first"), size >= 11) << size;
    EXPECT_LE(read.problem_count, 1u) << size;
  }
}

TEST(Localization, RejectsFilesThatAreNoTexts) {
  EXPECT_EQ(formats::read_localization(std::string(100 << 20, 'x')).error().message(),
            "104857600 bytes, the limit is 8388608");
  EXPECT_EQ(formats::read_localization(std::string_view("a = \"b\"\n\n\0", 10)).error().message(),
            "line 3: not a text file: it has a zero byte");
}

TEST(Localization, LimitsCounts) {
  std::string text;
  for (std::size_t i = 0; i < formats::kMaxLocalizationEntries + 30; ++i)
    text += fmt::format("k{}=\"\"\n", i);
  text += "k0 = \"known\"\n";
  const auto read = read_or_die(text);
  EXPECT_EQ(read.localization.texts().size(), formats::kMaxLocalizationEntries);
  EXPECT_EQ(read.localization.localize("$k0"), "known");
  EXPECT_EQ(read.problem_count, 30u);
  EXPECT_EQ(read.problems.size(), formats::ReadLocalization::kMaxProblems);
  EXPECT_THAT(read.problems[0].what, HasSubstr("more than 65536 texts"));
}

TEST(Localization, LaterTextsWinWhenTwoFilesAreJoined) {
  Localization texts(Localization::Texts{{"a", "english a"}, {"b", "english b"}});
  texts.add(Localization(Localization::Texts{{"b", "german b"}, {"c", "german c"}}));
  EXPECT_EQ(texts.texts(), (Localization::Texts{{"a", "english a"}, {"b", "german b"}, {"c", "german c"}}));
}

TEST(FillPlaces, FillsByNumber) {
  const std::vector<std::string> arguments = {"A", "{0}", ""};
  EXPECT_EQ(formats::fill_places("{0} {1}{2}{0}", arguments), "A {0}A");
  EXPECT_EQ(formats::fill_places("{3} {} {x} {-1} {99999999999999999999} { {0", arguments),
            "{3} {} {x} {-1} {99999999999999999999} { {0");
  EXPECT_EQ(formats::fill_places("", arguments), "");
}

TEST(FillPlaces, LimitsTheResult) {
  std::string places;
  for (int i = 0; i < 2000; ++i) places += "{0}";
  const std::vector<std::string> arguments = {std::string(5000, 'x')};
  EXPECT_EQ(formats::fill_places(places, arguments), std::string(formats::kMaxLocalizedBytes, 'x'));
}

}  // namespace
}  // namespace temblor::test
