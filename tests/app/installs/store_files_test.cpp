#include "app/installs/store_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace temblor::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr std::string_view kVdf = R"("libraryfolders"
{
	"contentstatsid"		"-123"
	"0"
	{
		"path"		"/home/me/.local/share/Steam"
		"label"		""
		"apps" { "2310" "1234567" }
	}
	"1" { "path" "/mnt/big \"disk\"/games" "path" "relative" }
}
)";

TEST(StoreFiles, ReadsSteamLibraries) {
  EXPECT_THAT(app::read_steam_libraries(kVdf),
              ElementsAre("/home/me/.local/share/Steam", "/mnt/big \"disk\"/games"));
  EXPECT_THAT(app::read_steam_libraries(
                  R"("LibraryFolders" { "TimeNextStatsReport" "12" "1" "/mnt/a" "2" "/mnt/b" })"),
              ElementsAre("/mnt/a", "/mnt/b"));
}

TEST(StoreFiles, ReadsHeroicFolders) {
  EXPECT_THAT(app::read_heroic_folders(
                  R"({"installed":[{"platform":"windows","install_path":"\/home\/me\/Games\/Heroic\/Quake"},
                                          {"install_path" : "/mnt/Quake II"}, {"install_path": 7}]})"),
              ElementsAre("/home/me/Games/Heroic/Quake", "/mnt/Quake II"));
}

TEST(StoreFiles, ReadsLutrisPaths) {
  EXPECT_THAT(app::read_lutris_paths(
                  "game:\n  exe: /mnt/Quake/quakespasm\n  args: -x /tmp\n  prefix: '/mnt/prefix'\r\n"
                  "  working_dir: ./here\nsystem: {}\n"),
              ElementsAre("/mnt/Quake/quakespasm", "/mnt/prefix"));
}

TEST(StoreFiles, DamagedFilesAreHarmless) {
  for (std::size_t size = 0; size < kVdf.size(); ++size)
    EXPECT_LE(app::read_steam_libraries(kVdf.substr(0, size)).size(), 2u);
  for (const auto read : {app::read_steam_libraries, app::read_heroic_folders, app::read_lutris_paths}) {
    EXPECT_THAT(read(std::string(1000000, '"')), IsEmpty());
    EXPECT_THAT(read(std::string(1000000, '{')), IsEmpty());
    EXPECT_THAT(read("\"path\" \"/" + std::string(100000, 'x') + "\"\nexe: /" + std::string(100000, 'x')),
                IsEmpty());
    EXPECT_THAT(read("\"path\\"), IsEmpty());
  }
  std::string many;
  for (int i = 0; i < 100000; ++i) many += "\"path\" \"/a\"\n";
  EXPECT_EQ(app::read_steam_libraries(many).size(), app::kMaxStorePaths);
}

}  // namespace
}  // namespace temblor::test
