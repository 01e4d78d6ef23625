#include "assets/localization.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/programs/temporary_folder.h"

namespace temblor::assets {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

struct Loaded {
  formats::Localization texts;
  std::vector<std::string> notes;
};
Loaded load(const test::TemporaryFolder& folder, std::string_view language) {
  Loaded loaded;
  loaded.texts = load_localization(vfs::FileSystem::open(folder.path()).value(), language, loaded.notes);
  return loaded;
}

TEST(LoadLocalization, FillsGapsWithEnglish) {
  const test::TemporaryFolder folder;
  folder.write("id1/localization/loc_english.txt", "a = \"hello\"\nb = \"bye\"\n");
  folder.write("id1/localization/loc_german.txt", "a = \"hallo\"\n");
  const Loaded german = load(folder, "German");
  EXPECT_EQ(german.texts.localize("$a"), "hallo");
  EXPECT_EQ(german.texts.localize("$b"), "bye");
  EXPECT_THAT(german.notes, ElementsAre());
  EXPECT_EQ(load(folder, "english").texts.localize("$a"), "hello");
}

TEST(LoadLocalization, MissingFilesAreNoErrors) {
  const test::TemporaryFolder folder;
  folder.write("id1/a.txt", "");
  EXPECT_THAT(load(folder, "german").notes, ElementsAre());
  folder.write("id1/localization/loc_english.txt", "a = \"hello\"\n");
  for (const char* const language : {"latin", "", "../../x", "a/b"}) {
    const Loaded loaded = load(folder, language);
    EXPECT_EQ(loaded.texts.localize("$a"), "hello");
    ASSERT_EQ(loaded.notes.size(), 1u) << language;
    EXPECT_THAT(loaded.notes[0], HasSubstr("only english"));
    EXPECT_THAT(loaded.notes[0], HasSubstr("texts stay English"));
  }
}

TEST(LoadLocalization, TextsOfAModAddToThoseOfTheGame) {
  const test::TemporaryFolder folder;
  folder.write("id1/localization/loc_english.txt", "a = \"a\"\nb = \"b\"\nc = \"c\"\n");
  folder.write("id1/localization/loc_german.txt", "a = \"A\"\nb = \"B\"\n");
  folder.write("mod/localization/loc_english.txt", "b = \"mod b\"\nd = \"mod d\"\n");
  std::vector<std::string> notes;
  const std::vector<std::string> games = {"mod"};
  const vfs::FileSystem files = vfs::FileSystem::open(folder.path(), games).value();
  EXPECT_EQ(load_localization(files, "german", notes).texts(),
            (formats::Localization::Texts{{"a", "A"}, {"b", "mod b"}, {"c", "c"}, {"d", "mod d"}}));
  EXPECT_THAT(notes, ElementsAre());
  EXPECT_THAT(list_languages(files), ElementsAre("english", "german"));
}

TEST(LoadLocalization, LanguagesWithoutLettersStayEnglish) {
  const test::TemporaryFolder folder;
  folder.write("id1/localization/loc_english.txt", "a = \"hello\"\nb = \"bye\"\n");
  const auto path = folder.write("id1/localization/loc_japanese.txt", "a = \"鍵\"\nb = \"扉\"\n");
  folder.write("id1/localization/loc_russian.txt", "a = \"привет\"\n");
  const Loaded japanese = load(folder, "japanese");
  EXPECT_EQ(japanese.texts.localize("$a"), "hello");
  EXPECT_THAT(japanese.notes,
              ElementsAre(path.string() + ": the game's characters lack the letters of this language: texts "
                                          "stay English"));
  EXPECT_EQ(load(folder, "russian").texts.localize("$a"), "privet");
  EXPECT_THAT(
      load(folder, "klingon").notes,
      ElementsAre("there is no language \"klingon\" here, only english, japanese, russian: texts stay "
                  "English"));
}

TEST(LoadLocalization, NotesNameFileAndLine) {
  const test::TemporaryFolder folder;
  const auto path =
      folder.write("id1/localization/loc_english.txt", "a = \"hello\"\nb = \"bye\nc = \"$c\"\n");
  const Loaded loaded = load(folder, "english");
  EXPECT_EQ(loaded.texts.localize("$a"), "hello");
  EXPECT_THAT(loaded.notes, ElementsAre(path.string() + ": line 2: b: the text has no closing quote",
                                        path.string() + ": line 3: c: \"$c\" refers to itself"));
  std::string bad;
  for (int i = 0; i < 21; ++i) bad += "bad\n";
  folder.write("id1/localization/loc_english.txt", bad);
  EXPECT_EQ(load(folder, "english").notes.back(), path.string() + ": 1 line more cannot be read");
  folder.write("id1/localization/loc_english.txt", std::string(9 << 20, '\n'));
  EXPECT_THAT(load(folder, "english").notes,
              ElementsAre(path.string() + ": 9437184 bytes, the limit is 8388608"));
}

}  // namespace
}  // namespace temblor::assets
