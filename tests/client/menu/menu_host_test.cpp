// The page that hosts a game.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/menu/menu_driver.h"

namespace temblor::client {
namespace {

using platform::Key;
using test::MenuDriver;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;

TEST(MenuHost, HostsAGame) {
  MenuDriver hand;
  hand.menu().open(MenuPage::kHost);
  EXPECT_TRUE(hand.go_to("Frag limit"));
  ASSERT_TRUE(hand.choose("Level") && hand.choose("e1m7"));
  EXPECT_THAT(hand.all_text(), HasSubstr("The Level of Number 7"));
  ASSERT_TRUE(hand.go_to("Max players"));
  hand.press(Key::kRightArrow);
  ASSERT_TRUE(hand.choose("Port"));
  for (int i = 0; i < 3; ++i) hand.press(Key::kBackspace);
  hand.type("001");
  hand.press(Key::kEnter);
  EXPECT_EQ(hand.variables().find("port")->text, "26001");
  hand.type("x");
  hand.press(Key::kEnter);
  EXPECT_EQ(hand.variables().find("port")->text, "26001") << "not a number";
  ASSERT_TRUE(hand.choose("Start game"));
  EXPECT_THAT(hand.commands(), ElementsAre("disconnect", "maxplayers 9", "deathmatch 1", "coop 0",
                                           "teamplay 0", "bot_fill 4", "map e1m7"));
  hand.menu().open(MenuPage::kHost);
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(hand.choose("Game mode"));
  EXPECT_FALSE(hand.go_to("Frag limit"));
  EXPECT_TRUE(hand.go_to("Skill"));
  ASSERT_TRUE(hand.choose("Start game"));
  EXPECT_THAT(hand.commands(),
              ElementsAre("disconnect", "maxplayers 9", "deathmatch 0", "coop 1", "teamplay 0", "map e1m7"));
}

TEST(MenuHost, HostsAnArenaWithBots) {
  MenuContent content = MenuDriver::some_content();
  content.levels = [] {
    return std::vector<client::MenuLevel>{
        {"gallery", "The Gallery"}, {"tdm1", "The Anvil"}, {"tdm2", "The Cistern"}};
  };
  MenuDriver hand(content);
  hand.menu().open(MenuPage::kHost);
  ASSERT_TRUE(hand.go_to("Fill with bots"));
  EXPECT_THAT(hand.selected(), HasSubstr("4")) << "bots are the default";
  for (int i = 0; i < 2; ++i) hand.press(Key::kRightArrow);
  EXPECT_THAT(hand.selected(), HasSubstr("6"));
  ASSERT_TRUE(hand.go_to("Bot skill"));
  hand.press(Key::kRightArrow);
  EXPECT_EQ(hand.variables().find("bot_skill")->text, "2");
  ASSERT_TRUE(hand.choose("Start game"));
  EXPECT_THAT(hand.commands(), IsSupersetOf({"bot_fill 6", "map tdm1"}));
  hand.menu().open(MenuPage::kHost);
  ASSERT_TRUE(hand.go_to("Fill with bots"));
  for (int i = 0; i < 5; ++i) hand.press(Key::kLeftArrow);
  EXPECT_THAT(hand.selected(), HasSubstr("none"));
  ASSERT_TRUE(hand.choose("Start game"));
  EXPECT_THAT(hand.commands(), Contains("bot_fill 0")) << "the choice lasts";
  hand.menu().open(MenuPage::kHost);
  ASSERT_TRUE(hand.go_to("Fill with bots"));
  EXPECT_THAT(hand.selected(), HasSubstr("none"));
}

TEST(MenuHost, HostsTeams) {
  MenuDriver hand;
  hand.menu().open(MenuPage::kHost);
  EXPECT_FALSE(hand.go_to("Friendly fire"));
  ASSERT_TRUE(hand.choose("Game mode"));
  ASSERT_TRUE(hand.choose("Start game"));
  EXPECT_THAT(hand.commands(), IsSupersetOf({"deathmatch 1", "teamplay 1", "bot_fill 4"}));
  hand.menu().open(MenuPage::kHost);
  ASSERT_TRUE(hand.choose("Friendly fire"));
  EXPECT_TRUE(hand.go_to("Frag limit"));
  ASSERT_TRUE(hand.choose("Start game"));
  EXPECT_THAT(hand.commands(), Contains("teamplay 2"));
}

TEST(MenuHost, HostsCaptureTheFlagInALevelWithFlags) {
  MenuContent content = MenuDriver::some_content();
  content.levels = [] {
    return std::vector<client::MenuLevel>{{"tdm1", "The Anvil"}, {"tdm3", "The Two Towers", true}};
  };
  MenuDriver hand(content);
  hand.menu().open(MenuPage::kHost);
  for (int i = 0; i < 2; ++i) ASSERT_TRUE(hand.choose("Game mode"));
  EXPECT_THAT(hand.all_text(), HasSubstr("The Two Towers"));
  EXPECT_FALSE(hand.go_to("Frag limit"));
  ASSERT_TRUE(hand.go_to("Capture limit"));
  for (int i = 0; i < 3; ++i) hand.press(Key::kRightArrow);
  EXPECT_EQ(hand.variables().find("capturelimit")->text, "3");
  ASSERT_TRUE(hand.choose("Start game"));
  EXPECT_THAT(hand.commands(), IsSupersetOf({"deathmatch 1", "teamplay 3", "map tdm3"}));
}

TEST(MenuHost, HostsWithAsManyBotsAsTheConsoleHasSet) {
  MenuDriver hand;
  ASSERT_TRUE(hand.variables().set("bot_fill", "7").ok());
  hand.menu().open(MenuPage::kHost);
  ASSERT_TRUE(hand.choose("Start game"));
  EXPECT_THAT(hand.commands(), Contains("bot_fill 7"));
}

}  // namespace
}  // namespace temblor::client
