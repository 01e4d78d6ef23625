// The pages of saved games.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/menu/menu_driver.h"

namespace temblor::client {
namespace {

using platform::Key;
using test::MenuDriver;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST(MenuSaves, LoadsAndSaves) {
  MenuDriver hand;
  hand.menu().open(MenuPage::kLoad);
  EXPECT_THAT(hand.all_text(),
              AllOf(HasSubstr("The Level of\n"), HasSubstr("Number 1\n"), HasSubstr("Before the bridge\n"),
                    HasSubstr("2026-11-26\n07:02\n"), HasSubstr("12:34 played\nhard skill\n"),
                    HasSubstr("12 of 30"), HasSubstr("File: s0")));
  ASSERT_TRUE(hand.choose("quick"));
  EXPECT_THAT(hand.commands(), ElementsAre("load quick"));
  hand.menu().open(MenuPage::kSave);
  ASSERT_TRUE(hand.choose("New save") && hand.choose("Save"));
  EXPECT_THAT(hand.commands(), ElementsAre("save s1")) << "s0 is taken";
  hand.menu().open(MenuPage::kSave);
  ASSERT_TRUE(hand.choose("Before the bridge"));
  EXPECT_THAT(hand.all_text(), HasSubstr("Overwrite Before the bridge"));
  EXPECT_THAT(hand.commands(), IsEmpty());
  hand.press(Key::kEnter);
  EXPECT_THAT(hand.commands(), IsEmpty()) << "No is selected first";
  ASSERT_TRUE(hand.choose("Before the bridge") && hand.choose("Yes"));
  EXPECT_THAT(hand.commands(), ElementsAre("save s0 \"Before the bridge\""));
}

TEST(MenuSaves, NamesSaves) {
  MenuDriver hand;
  hand.menu().open(MenuPage::kSave);
  ASSERT_TRUE(hand.choose("New save"));
  hand.type("At the \"well\", with 3 rockets");  // one press of Enter then saves
  hand.press(Key::kEnter);
  EXPECT_THAT(hand.commands(), ElementsAre("save s1 \"At the well, with 3\"")) << "22 characters, no quotes";
  hand.menu().open(MenuPage::kSave);
  ASSERT_TRUE(hand.choose("New save"));
  hand.type("At the");
  hand.press(Key::kEscape);
  EXPECT_THAT(hand.commands(), IsEmpty());
  ASSERT_TRUE(hand.choose("Cancel"));
  ASSERT_TRUE(hand.choose("quick") && hand.choose("Name"));
  hand.type("well");
  hand.press(Key::kEnter);
  EXPECT_THAT(hand.commands(), IsEmpty()) << "the question is still open";
  ASSERT_TRUE(hand.choose("Yes"));
  EXPECT_THAT(hand.commands(), ElementsAre("save quick well"));
}

// A name is cut off neither by the level's title beside it nor by the frame; nor are messages of empty lists.
TEST(MenuSaves, CutsOffNoNamesAndMessages) {
  MenuContent content = MenuDriver::some_content();
  content.saves = [] {
    return std::vector<client::MenuSave>{
        {.name = "s0", .title = "Just before the bridge", .level_title = "The Copperworks", .date = ""}};
  };
  for (const MenuDriver::Size& size : {MenuDriver::Size{640, 480}, {1280, 720}, {1920, 1080}}) {
    MenuDriver hand(content, size);
    hand.menu().open(MenuPage::kLoad);
    const std::string text = hand.all_text();
    EXPECT_TRUE(text.find("Just before the bridge\n") != text.npos ||
                text.find("Just before the\n") != text.npos)
        << "in the list, or beside it in two lines\n"
        << text;
    hand.menu().open(MenuPage::kGameData);
    EXPECT_THAT(hand.all_text(), HasSubstr("FOLDER."));
    EXPECT_THAT(hand.all_text(), Not(HasSubstr("..\n")));
  }
}

TEST(MenuSaves, OffersSavingOnlyIfTheGameCanBeSaved) {
  MenuContent content = MenuDriver::some_content();
  content.can_save = [] { return false; };
  MenuDriver hand(content);
  hand.menu().open(MenuPage::kSinglePlayer);
  EXPECT_FALSE(hand.go_to("Save"));
  hand.menu().open(MenuPage::kSave);
  EXPECT_THAT(hand.all_text(), HasSubstr("can't save right now"));
}

TEST(MenuSaves, ShowsNamesOfAutosavesInFull) {
  MenuContent content = MenuDriver::some_content();
  content.saves = [] {
    return std::vector<client::MenuSave>{
        {.name = "autosave2", .title = "", .level_title = "The Toll House", .date = ""},
        {.name = "autosave3", .title = "", .level_title = "The Fault", .date = ""}};
  };
  MenuDriver hand(content);
  hand.menu().open(MenuPage::kLoad);
  EXPECT_THAT(hand.all_text(), AllOf(HasSubstr("autosave2"), HasSubstr("autosave3")));
}

}  // namespace
}  // namespace temblor::client
