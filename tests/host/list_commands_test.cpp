// path, dir, flocate, mapname, mods, demos, saves, and others: commands that list files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "host/headless_host.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

TEST(ListCommands, ShowFilesAndTheLevel) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost host({"map small"});
  host.folder().write("id1/first.dem", "0\n");
  host.folder().write("other/maps/x.bsp", "");
  host.folder().write("drafts/maps/x.map", "an editor's folder is no game");
  ASSERT_TRUE(host.run_until_playing());
  host.command(
      "mapname; path; flocate maps/small.bsp; flocate maps/nowhere.bsp; demos; mods; saves; reconnect");
  host.run(0.1);
  EXPECT_TRUE(host.has_printed("small: "));
  EXPECT_TRUE(host.has_printed("id1/maps/small.bsp"));
  EXPECT_TRUE(host.has_printed("\"maps/nowhere.bsp\" is in no game folder"));
  EXPECT_TRUE(host.has_printed("   first"));
  EXPECT_TRUE(host.has_printed("1 demo"));
  EXPECT_TRUE(host.has_printed("   id1 (in use)"));
  EXPECT_TRUE(host.has_printed("   other"));
  EXPECT_TRUE(host.has_printed("2 game folders"));
  EXPECT_TRUE(host.has_printed("0 saved games"));
  EXPECT_TRUE(host.has_printed("reconnect: you have not joined a server yet"));
  host.command("mods OTH; randmap");
  host.run(0.1);
  EXPECT_TRUE(host.has_printed("1 game folder"));
  EXPECT_FALSE(host.has_printed("unknown"));
}

TEST(ListCommands, DirListsAFolder) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost host;
  for (const char* name : {"e1m1.bsp", "e1m2.bsp", "e1m1.lit", "e2m1.bsp", "old/e1m9.bsp"})
    host.folder().write(std::string("id1/maps/") + name, "");
  host.restart();
  const auto list = [&](const std::string& arguments) {
    host.command("echo \"" + arguments + ":\"; dir " + arguments);
    host.run(0.1);
    const auto begin = std::ranges::find(host.lines(), arguments + ":");
    const auto end = std::find_if(begin, host.lines().end(), [](const std::string& line) {
      return line.ends_with(" name") || line.ends_with(" names");
    });
    EXPECT_NE(end, host.lines().end());
    return end == host.lines().end() ? std::vector<std::string>() : std::vector(begin + 1, end + 1);
  };
  using ::testing::Contains;
  using ::testing::ElementsAre;
  EXPECT_THAT(list("maps/E1*.bsp"), ElementsAre("   e1m1.bsp", "   e1m2.bsp", "2 names"));
  EXPECT_THAT(list("maps/*m1*"), ElementsAre("   e1m1.bsp", "   e1m1.lit", "   e2m1.bsp", "3 names"));
  EXPECT_THAT(list("maps/e1m1"), ElementsAre("0 names"));
  EXPECT_THAT(list("maps"), Contains("   old/"));
  EXPECT_THAT(list("maps/old"), ElementsAre("   e1m9.bsp", "1 name"));
  EXPECT_THAT(list(""), Contains("   maps/"));
  host.command("flocate E1M2.bsp");
  host.run(0.1);
  EXPECT_TRUE(host.has_printed("maps/e1m2.bsp: " + (host.folder().path() / "id1/maps/e1m2.bsp").string()));
}

TEST(ListCommands, ScreenshotsTakeTheNextFreeNumber) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost host({"map small"});
  ASSERT_TRUE(host.run_until_playing());
  host.run(0.1);
  for (int i = 0; i < 2; ++i) {
    host.command("screenshot");
    host.run(0.1);
  }
  EXPECT_TRUE(std::filesystem::exists(host.folder().path() / "id1/temblor0000.png"));
  EXPECT_TRUE(std::filesystem::exists(host.folder().path() / "id1/temblor0001.png"));
  EXPECT_THAT(host.lines(), ::testing::Contains("Screenshot saved: id1/temblor0001.png"));
  const std::string elsewhere = (host.folder().path() / "elsewhere.png").string();
  host.command("screenshot \"" + elsewhere + "\"");
  host.run(0.1);
  EXPECT_THAT(host.lines(), ::testing::Contains("Screenshot saved: " + elsewhere));
}

}  // namespace
}  // namespace temblor::test
