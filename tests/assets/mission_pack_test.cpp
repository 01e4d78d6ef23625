#include "assets/mission_pack.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/programs/temporary_folder.h"

namespace temblor::assets {
namespace {

TEST(MissionPack, IsFoundByTheGameFolders) {
  const test::TemporaryFolder folder;
  for (const char* game : {"id1", "Hipnotic", "rogue", "quoth", "mymod"})
    folder.write(std::string(game) + "/notes.txt", std::string_view("."));
  const auto pack = [&](const std::vector<std::string>& games) {
    return find_mission_pack(vfs::FileSystem::open(folder.path(), games).value());
  };
  EXPECT_EQ(pack({}), MissionPack::kNone);
  EXPECT_EQ(pack({"mymod"}), MissionPack::kNone);
  EXPECT_EQ(pack({"hipnotic"}), MissionPack::kHipnotic) << "case of the folder on the disk";
  EXPECT_EQ(pack({"quoth", "mymod"}), MissionPack::kHipnotic);
  EXPECT_EQ(pack({"ROGUE", "mymod"}), MissionPack::kRogue);
  EXPECT_EQ(pack({"hipnotic", "rogue"}), MissionPack::kRogue) << "the last one wins";
}

TEST(MissionPack, OptionsOfOtherEnginesNameFolders) {
  EXPECT_EQ(find_pack_folder("-hipnotic"), "hipnotic");
  EXPECT_EQ(find_pack_folder("-rogue"), "rogue");
  EXPECT_EQ(find_pack_folder("-quoth"), "quoth");
  for (const char* other : {"", "hipnotic", "-game", "--hipnotic", "-o"})
    EXPECT_EQ(find_pack_folder(other), std::nullopt) << other;
}

}  // namespace
}  // namespace temblor::assets
