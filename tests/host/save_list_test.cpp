// Saved games as the menus describe them.
#include "host/menus/save_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <ctime>
#include <filesystem>
#include <map>

#include "host/frame/host_parts.h"
#include "host/headless_host.h"
#include "host/menus/menu_lists.h"
#include "support/programs/quakec.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

formats::Sav make_sav(const std::string& comment) {
  formats::Sav sav;
  sav.comment = comment;
  sav.skill = 3;
  sav.time_s = 75;
  return sav;
}

TEST(SaveList, ReadsStockComments) {
  const client::MenuSave save =
      host::describe_save(make_sav("The Slipgate Complex   kills:  3/ 21"), "The Slipgate Complex");
  EXPECT_EQ(save.title, "");
  EXPECT_EQ(save.level_title, "The Slipgate Complex");
  EXPECT_EQ(save.skill, 3);
  EXPECT_EQ(save.time_s, 75);
  EXPECT_EQ(save.kills, 3);
  EXPECT_EQ(save.monsters, 21);
}

TEST(SaveList, TakesOtherTextThanTheLevelsTitleAsTheNameOfTheSave) {
  const auto title = [](const std::string& comment, const std::string& level_title) {
    return host::describe_save(make_sav(comment), level_title).title;
  };
  EXPECT_EQ(title("Before the bridge      kills:  3/ 21", "The Copperworks"), "Before the bridge");
  EXPECT_EQ(title("My kills:9/9           kills:  3/ 21", "The Copperworks"), "My kills:9/9");
  EXPECT_EQ(title("Forgotten Catacombs, a kills:  3/ 21", "Forgotten Catacombs, also in the dark"), "");
  EXPECT_EQ(title("two lines              kills:  0/  0", "two_lines\n"), "");
  EXPECT_EQ(title("", "The Copperworks"), "");
  const client::MenuSave of_lost_level =
      host::describe_save(make_sav("Azure Agony            kills:  3/ 21"), "");
  EXPECT_EQ(of_lost_level.title, "");
  EXPECT_EQ(of_lost_level.level_title, "Azure Agony");
}

TEST(SaveList, ShowsTheLocalTimeOfTheLastChange) {
  const TemporaryFolder folder;
  folder.write("a.sav", std::string_view("x"));
  std::tm date{};
  date.tm_year = 2026 - 1900;
  date.tm_mon = 10;
  date.tm_mday = 26;
  date.tm_hour = 7;
  date.tm_min = 2;
  date.tm_isdst = -1;
  const auto time = std::chrono::system_clock::from_time_t(std::mktime(&date));
  std::filesystem::last_write_time(folder.path() / "a.sav", std::chrono::file_clock::from_sys(time));
  EXPECT_EQ(host::format_date(folder.path() / "a.sav"), "2026-11-26 07:02");
  EXPECT_EQ(host::format_date(folder.path() / "b.sav"), "");
}

TEST(SaveList, ShowsNamesThatPlayersGive) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost host({"skill 2", "map small"});
  ASSERT_TRUE(host.run_until_playing());
  host.command("save s0; save s1 \"Before the bridge\"; save; save a b c");
  host.run(0.2);
  EXPECT_TRUE(host.has_printed("save NAME [TITLE]"));
  EXPECT_TRUE(host.has_printed("put quotes around a title"));
  std::map<std::string, client::MenuSave> saves;
  for (const client::MenuSave& save : host.host().game.menu_lists->saves()) saves[save.name] = save;
  ASSERT_TRUE(saves.contains("s0") && saves.contains("s1"));
  EXPECT_EQ(saves["s0"].title, "");
  EXPECT_EQ(saves["s1"].title, "Before the bridge");
  EXPECT_EQ(saves["s1"].level_title, saves["s0"].level_title);
  EXPECT_EQ(saves["s1"].skill, 2);
  EXPECT_EQ(saves["s1"].date.size(), std::string_view("2026-11-26 07:02").size());
  host.command("load s1");
  host.run(0.5);
  EXPECT_TRUE(host.run_until_playing());
}

}  // namespace
}  // namespace temblor::test
