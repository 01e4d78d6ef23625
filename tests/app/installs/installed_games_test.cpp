// Homes as stores leave them, with files that only look like games.
#include "app/installs/installed_games.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

namespace fs = std::filesystem;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

std::vector<std::string> find(const TemporaryFolder& home) {
  const fs::path& path = home.path();
  std::vector<std::string> found;
  for (const app::InstalledGame& game :
       app::find_installed_games({path, path / ".config", path / ".local/share"}))
    found.push_back(game.title + ": " + fs::relative(game.base_folder, path).string());
  return found;
}

void write_game(const TemporaryFolder& home, const std::string& folder) {
  home.write(folder + "/Id1/PAK0.PAK", "PACK");
}

TEST(InstalledGames, SteamLibrariesHaveBothGames) {
  const TemporaryFolder home;
  const std::string library = home.path().string() + "/disk/SteamLibrary";
  home.write(".local/share/Steam/steamapps/libraryfolders.vdf",
             "\"libraryfolders\" { \"0\" { \"path\" \"" + home.path().string() +
                 "/.local/share/Steam\" } \"1\" { \"path\" \"" + library + "\" } }");
  fs::create_directories(home.path() / ".steam");
  fs::create_directory_symlink(home.path() / ".local/share/Steam", home.path() / ".steam/steam");
  write_game(home, "disk/SteamLibrary/steamapps/common/Quake");
  write_game(home, "disk/SteamLibrary/steamapps/common/Quake/rerelease");
  EXPECT_THAT(
      find(home),
      UnorderedElementsAre("Quake, 2021 release (Steam): disk/SteamLibrary/steamapps/common/Quake/rerelease",
                           "Quake (Steam): disk/SteamLibrary/steamapps/common/Quake"));
}

TEST(InstalledGames, SteamOfFlatpak) {
  const TemporaryFolder home;
  const std::string quake = ".var/app/com.valvesoftware.Steam/.local/share/Steam/steamapps/common/Quake";
  write_game(home, quake);
  EXPECT_THAT(find(home), UnorderedElementsAre("Quake (Steam): " + quake));
}

TEST(InstalledGames, GogHeroicAndLutris) {
  const TemporaryFolder home;
  const std::string path = home.path().string();
  write_game(home, "GOG Games/Quake The Offering/data");
  write_game(home, "Games/Heroic/Quake");
  write_game(home, "elsewhere/one");
  write_game(home, "elsewhere/two/rerelease");
  write_game(home, "elsewhere/three");
  write_game(home, "wine/drive_c/GOG Games/Quake");
  write_game(home, "Games/quake-enhanced");
  home.write(".config/heroic/gog_store/installed.json",
             "{\"installed\":[{\"install_path\":\"" + path + "/elsewhere/one\"}]}");
  home.write(".var/app/com.heroicgameslauncher.hgl/config/heroic/legendaryConfig/legendary/installed.json",
             "{\"x\":{\"install_path\":\"" + path + "/elsewhere/two\"}}");
  home.write(".config/lutris/games/quake-1.yml", "game:\n  exe: " + path + "/elsewhere/three/quakespasm\n");
  home.write(".local/share/lutris/games/quake-2.yml", "game:\n  prefix: " + path + "/wine\n");
  EXPECT_THAT(find(home),
              UnorderedElementsAre(
                  "Quake (GOG): GOG Games/Quake The Offering/data", "Quake (Heroic): Games/Heroic/Quake",
                  "Quake (Heroic): elsewhere/one", "Quake, 2021 release (Heroic): elsewhere/two/rerelease",
                  "Quake (Lutris): elsewhere/three", "Quake (Lutris): wine/drive_c/GOG Games/Quake",
                  "Quake (Lutris): Games/quake-enhanced"));
}

TEST(InstalledGames, OtherFilesAreNoGames) {
  const TemporaryFolder home;
  EXPECT_THAT(find(home), IsEmpty());
  home.write("Games/quake/id1/config.cfg", "");
  home.write("Games/quake2/baseq2/pak0.pak", "PACK");
  home.write("GOG Games/Quake", "a file");
  fs::create_directories(home.path() / "Games/quake3/id1/pak0.pak");
  home.write(".config/lutris/games/quake.yml", std::string(2 << 20, 'x'));
  home.write(".steam/steam/steamapps/libraryfolders.vdf", "\"path\" \"\xff\x01\n");
  EXPECT_THAT(find(home), IsEmpty());
  EXPECT_THAT(app::find_installed_games({}), IsEmpty());
}

// A library in itself, and links that lead back.
TEST(InstalledGames, LoopsEnd) {
  const TemporaryFolder home;
  const std::string path = home.path().string();
  home.write(
      ".steam/steam/steamapps/libraryfolders.vdf",
      "\"path\" \"" + path + "/.steam/steam\" \"path\" \"" + path + "/.steam/steam/steamapps/common/Quake\"");
  write_game(home, ".steam/steam/steamapps/common/Quake");
  const fs::path quake = home.path() / ".steam/steam/steamapps/common/Quake";
  fs::create_directory_symlink(quake, quake / "rerelease");
  fs::create_directory_symlink("loop", home.path() / "loop");
  fs::create_directories(home.path() / "GOG Games");
  fs::create_directory_symlink(home.path() / "loop", home.path() / "GOG Games/Quake");
  EXPECT_EQ(find(home).size(), 1u);
}

}  // namespace
}  // namespace temblor::test
