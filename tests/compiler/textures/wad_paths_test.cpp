#include "compiler/wad_paths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "formats/levels/map.h"
#include "support/game_data.h"

namespace temblor::compiler {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
namespace fs = std::filesystem;

TEST(WadPaths, SplitsTheKeyAtSemicolons) {
  EXPECT_THAT(split_wad_key("a.wad;../b c.wad"), ElementsAre("a.wad", "../b c.wad"));
  EXPECT_THAT(split_wad_key(" a.wad ; 'b.wad';;\t;\"C:\\x\\c.wad\";"),
              ElementsAre("a.wad", "b.wad", "C:\\x\\c.wad"));
  EXPECT_THAT(split_wad_key(""), IsEmpty());
  EXPECT_THAT(split_wad_key(" ; "), IsEmpty());
}

TEST(WadPaths, RelativeEntries) {
  EXPECT_THAT(wad_candidates("../wads/a.wad", "/maps/src", {}),
              ElementsAre("/maps/wads/a.wad", "../wads/a.wad", "/maps/src/a.wad"));
  const fs::path folders[] = {"/w", "x"};
  EXPECT_THAT(wad_candidates("base\\a.wad", "m", folders),
              ElementsAre("m/base/a.wad", "base/a.wad", "/w/base/a.wad", "x/base/a.wad", "m/a.wad",
                          "/w/a.wad", "x/a.wad"));
}

TEST(WadPaths, ListsEachPathOnce) {
  const fs::path folders[] = {"/m", "/m/./"};
  EXPECT_THAT(wad_candidates("a.wad", "/m", folders), ElementsAre("/m/a.wad", "a.wad"));
}

TEST(WadPaths, AbsoluteEntries) {
  const fs::path folders[] = {"/w"};
  EXPECT_THAT(wad_candidates("/quake/a.wad", "/m", folders),
              ElementsAre("/quake/a.wad", "/m/a.wad", "/w/a.wad"));
}

TEST(WadPaths, ForeignPathsOnlyByName) {
  const fs::path folders[] = {"/w"};
  for (const char* entry :
       {"C:\\quake\\id1\\Base.WAD", "\\quake\\Base.WAD", "\\\\server\\Base.WAD", "c:/x/Base.WAD"})
    EXPECT_THAT(wad_candidates(entry, "/m", folders),
                ElementsAre("/m/Base.WAD", "/w/Base.WAD", "/m/base.wad", "/w/base.wad"))
        << entry;
}

TEST(WadPaths, NamesWithoutAnExtension) {
  EXPECT_THAT(wad_candidates("gfx/base", "/m", {}),
              ElementsAre("/m/gfx/base.wad", "gfx/base.wad", "/m/base.wad"));
}

TEST(WadPaths, IgnoresFolders) {
  EXPECT_THAT(wad_candidates("wads/", "/m", {}), IsEmpty());
  EXPECT_THAT(wad_candidates("", "/m", {}), IsEmpty());
}

// The stock maps name WADs by paths on their makers' machines; with one folder given, all are found.
TEST(WadPaths, StockWadsAreFound) {
  DATA_FOLDER_OR_SKIP(data);
  const fs::path folders[] = {data / "wads"};
  int found = 0;
  for (const auto& entry : fs::directory_iterator(data / "mapsrc")) {
    const auto map = formats::read_map(base::as_text(test::read_file(entry.path())));
    ASSERT_TRUE(map.ok());
    for (const std::string& wad : split_wad_key(map->entities.at(0).fields.find("wad").value_or(""))) {
      const auto candidates = wad_candidates(wad, entry.path().parent_path(), folders);
      EXPECT_TRUE(std::ranges::any_of(candidates, [](const fs::path& path) { return fs::exists(path); }))
          << wad;
      ++found;
    }
  }
  EXPECT_GT(found, 10);
}

}  // namespace
}  // namespace temblor::compiler
